#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/safety_settings.hpp"

namespace limber {

/// Of the largest command: what float32 set points at a limit may be beyond it.
inline constexpr double kSetpointRoundingShare = 1e-5;

/// Whether limits allow a set point, rounded or not; no NaN.
bool allow(const PressureLimits& limits, double kpa, double rounding_kpa);

/// Of an arm's plates, m×3.
using PlatePositions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// In the plane z is 0. None: nothing saw them.
std::optional<PlatePositions> plate_positions(const ArmState& state);

/// The last step before a driver. Set points are never clipped: one that is beyond a limit is a
/// fault, since a clipped certified plan is another path. Measured values are watched, frame by
/// frame. Both return what is wrong, in words; empty where nothing is.
///
/// Threads: one at a time.
class SafetyGate {
 public:
  /// @param limits_kpa   in force, one per channel: the arm's, scaled, and the driver's own
  /// @param check_rate   whether set points may change by no more than the arm's rate allows; not
  ///                     where a schedule jumps, and the valves ramp by themselves
  SafetyGate(const ArmDescription& arm, std::vector<PressureLimits> limits_kpa, bool check_rate,
             const SafetySettings& settings);

  /// Of the next set point (size n). One that passes is taken for the one in force.
  std::string check_command(const Eigen::Ref<const Pressures>& setpoint_kpa);

  /// Of what was measured after it.
  std::string check_state(const ArmState& state);

  /// The arm is vented: set points are zero, and what is measured falls.
  void note_vented(const ArmState& state);

  /// The set point in force as the driver reports it: one that nothing allows would be recorded.
  std::string check_in_force(const ArmState& state) const;

  /// Pressures beyond a limit, shapes that jump or leave the fence: what is wrong in any state.
  std::string check_shape(const ArmState& state);

  /// What a channel may be told now.
  const PressureLimits& limits_kpa(int channel) const { return limits_kpa_[channel]; }

 private:
  struct Frame {
    Pressures setpoint_kpa;
    Pressures reference_kpa;
    Pressures measured_kpa;
  };

  std::string over_limit(const Pressures& kpa, const char* what) const;
  std::string following(const ArmState& state);
  std::string stuck(int channel) const;
  /// A set point in force that is none of those sent in the following time, nor between them.
  std::string never_sent(const ArmState& state) const;
  std::size_t first_recent() const;      // of history_, within the following time
  double excess_kpa(int channel) const;  // that is allowed beyond a limit

  ArmDescription arm_;
  std::vector<PressureLimits> limits_kpa_;
  bool check_rate_;
  SafetySettings settings_;
  double largest_jump_m_;
  Pressures setpoint_kpa_;
  Pressures reference_kpa_;      // what the valves' rate allows to be reached by now
  std::vector<int> frames_off_;  // each channel: how many in a row it was too far from it
  std::deque<Frame> history_;
  std::optional<PlatePositions> plates_;  // where they were tracked last …
  double seen_at_s_ = 0.0;                // … and when, by the driver's clock
  int frames_unseen_ = 0;                 // … and how many frames ago
};

/// What an arm in process takes for set points: within its limits, where float32 rounds beyond one.
/// @throws InputError for others, or where there is not one for each channel.
Eigen::VectorXd checked_setpoints(const ArmDescription& arm,
                                  const Eigen::Ref<const Pressures>& setpoint_kpa);

/// @throws SystemFault with these words, as the gate returns them; not where there are none.
void throw_if_wrong(const std::string& wrong);

}  // namespace limber
