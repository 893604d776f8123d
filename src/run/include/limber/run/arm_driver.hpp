#pragma once
// For those who move an arm, real or virtual.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

/// What is known about the arm at one frame.
struct ArmState {
  double time_s = 0.0;
  Pressures pressure_kpa;  ///< measured, size n
  /// In force when this was measured, where the arm says so; else the one last commanded.
  std::optional<Pressures> setpoint_kpa;
  std::optional<Backbone> backbone;  ///< m×3; none where nothing tracks it or the frame was lost
  /// The same of an arm in space, m×7, in place of `backbone`.
  std::optional<SpaceBackbone> space_backbone = std::nullopt;
  /// When the shape was seen, on the tracker's own clock, where that is told.
  std::optional<double> tracker_s = std::nullopt;
};

/// An arm that takes set points frame by frame: the virtual one, or the user's behind an external
/// program.
///
/// Laws: `state().time_s` grows with each `command`, by about a frame period; no driver passes on a
/// set point beyond the arm's limits; after `vent` every set point is zero.
/// Whatever limber does with an arm, the set points of `execute`, `collect` and `record_episode`
/// pass a gate right before they get here: one that is beyond a limit, or changes faster than the
/// arm's rate allows, is not sent, and is a SystemFault.
/// Threads: one driver, one thread at a time.
class ArmDriver {
 public:
  virtual ~ArmDriver() = default;

  /// The latest state; before the first command, the arm at its start.
  virtual const ArmState& state() const = 0;

  /// Commands set points (size n, kPa, signed), lets one frame period pass and returns the state
  /// after it.
  /// @throws InputError if a set point is not finite or beyond its segment's limit (the arm stays
  /// as it was).
  /// @throws SystemFault if the arm fails; it has been vented.
  virtual const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) = 0;

  /// In force for set points, where they are narrower than the arm's; empty: the arm's.
  virtual std::vector<PressureLimits> limits_kpa() const { return {}; }

  /// Whether a frame takes its time: then a set point is due in each, also while somebody thinks.
  virtual bool is_real_time() const { return false; }

  /// Opens every vent valve; safe to call at any time, more than once.
  virtual void vent() noexcept = 0;
};

}  // namespace limber
