#pragma once

#include <array>
#include <deque>

#include "limber/arm/valve_model.hpp"

namespace limber {

/// How many frames old a driver's states are that do not say which set points were in force: valves
/// do what the valve model says, and measured pressures do the same so many frames later. A state
/// is measured at one moment, so its backbone is as old as its pressures.
///
/// Ideal valves know no pressures beside the set points: nothing is found out there.
class PressureLag {
 public:
  static constexpr int kMaxFrames = 4;

  explicit PressureLag(const ValveModel& valves) : valves_(valves) {}

  /// Takes in a frame's set points and the pressures measured after it; the first ones are those of
  /// a settled arm.
  /// @return by how many frames they are behind, as far as is known: while pressures stand still,
  /// all of them look the same
  int note(const Pressures& setpoint_kpa, const Pressures& measured_kpa);

  /// Of the frame that is measured, by the set points alone. @pre noted, and valves are not ideal
  const Pressures& expected_kpa() const { return predicted_kpa_[frames_]; }

 private:
  const ValveModel& valves_;
  Eigen::VectorXf state_;                           // of the valves, never corrected
  std::deque<Pressures> predicted_kpa_;             // the latest frame first
  std::array<double, kMaxFrames + 1> missed_ = {};  // per lag: faded sum of squares [kPa²]
  int frames_ = 0;
};

}  // namespace limber
