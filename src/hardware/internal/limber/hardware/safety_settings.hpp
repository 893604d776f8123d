#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// Where the arm may be: every plate within, in frame B.
struct Fence {
  double x_min_m = 0.0;
  double x_max_m = 0.0;
  double y_min_m = 0.0;
  double y_max_m = 0.0;
};

/// When measured values mean that an arm has to be vented: the optional mapping `safety` of an arm
/// file (docs/hardware.md).
struct SafetySettings {
  double over_limit_percent = 5.0;    ///< of the arm's limit, beyond the limit in force
  double following_error_kpa = 10.0;  ///< off what the valves' rate allows …
  double following_time_s = 0.5;      ///< … for so long
  double stuck_change_kpa = 5.0;      ///< of the set point, while the reading stands still
  double jump_m = 0.05;               ///< of a plate in one frame
  double rise_kpa = 5.0;              ///< while venting
  double vented_kpa = 2.0;            ///< at most, to be called vented
  double vent_time_s = 5.0;           ///< until then
  std::optional<Fence> fence;
};

/// The mapping `safety` of an arm file; defaults where there is none.
/// @throws InputError naming line and key.
SafetySettings load_safety(const std::filesystem::path& arm_file);

/// `arm` with limits of `scale` times its own; for schedules and checks, never for hashes.
/// @throws InputError where `scale` is not in (0, 1].
ArmDescription with_scaled_limits(const ArmDescription& arm, double scale);

}  // namespace limber
