#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

/// Where the arm may be: every plate within, in frame B.
struct Fence {
  double x_min_m = 0.0;
  double x_max_m = 0.0;
  double y_min_m = 0.0;
  double y_max_m = 0.0;
  double z_min_m = -std::numeric_limits<double>::infinity();  ///< of arms in space
  double z_max_m = std::numeric_limits<double>::infinity();
};

/// When measured values mean that an arm has to be vented: the optional mapping `safety` of an arm
/// file (docs/hardware.md).
struct SafetySettings {
  double over_limit_percent = 5.0;    ///< of the arm's limit, beyond the limit in force
  double following_error_kpa = 10.0;  ///< off what the valves' rate allows …
  double following_time_s = 0.5;      ///< … for so long, three frames at least
  double stuck_change_kpa = 5.0;      ///< of the set point, while the reading stands still
  std::optional<double> jump_m;       ///< of a plate in one frame; none: largest_jump_m of the arm
  double rise_kpa = 5.0;              ///< while venting
  double vented_kpa = 2.0;            ///< at most, to be called vented
  double vent_time_s = 5.0;           ///< until then
  std::optional<Fence> fence;
};

/// The mapping `safety` of an arm file; defaults where there is none.
/// @throws InputError naming line and key.
SafetySettings load_safety(const fs::path& arm_file);

/// How far a plate may move in one frame: as `safety` says, or four lengths of the arm per second,
/// half as much again as the fastest seen of the virtual arms where set points jump
/// (docs/hardware.md).
double largest_jump_m(const SafetySettings& safety, const ArmDescription& arm);

/// `arm` with limits of `scale` times its own; for schedules and checks, never for hashes.
/// @throws InputError where `scale` is not in (0, 1].
ArmDescription with_scaled_limits(const ArmDescription& arm, double scale);

/// What both allow: the arm's limits, so scaled, and the driver's own, if it has any.
std::vector<PressureLimits> limits_in_force(const ArmDescription& arm, double scale,
                                            const std::vector<PressureLimits>& drivers_own);

}  // namespace limber
