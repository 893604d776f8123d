#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/valve_model.hpp"
#include "limber/run/arm_estimate.hpp"

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

/// Which segments lose pressure: measured pressures fall short of what the valves would make of
/// the set points by the same share, frame after frame. A hose that leaks behind a controller
/// without integral looks like that. A valve that is slower than its model does not: its shortfall
/// goes with how fast the pressure moves, and is fitted apart.
///
/// Ideal valves know no pressures beside the set points: nothing is found out there.
class PressureLossWatch {
 public:
  PressureLossWatch(const ArmDescription& arm, const ValveModel& valves);

  /// Takes in a frame. @param expected_kpa  pressures of that frame by the set points alone
  void observe(const Pressures& expected_kpa, const Pressures& measured_kpa);

  /// In the order in which they were noticed; shares are the latest.
  const std::vector<PressureLoss>& found() const { return found_; }

 private:
  /// Of one segment, faded sums over frames, and frames in a row in which it was short.
  struct Segment {
    double least_kpa;  ///< that counts as short
    double frames = 0.0;
    Eigen::Matrix2d expected2 = Eigen::Matrix2d::Zero();  ///< of (expected, its change)
    Eigen::Vector2d expected_missed = Eigen::Vector2d::Zero();
    double missed2 = 0.0;
    int short_for = 0;
    bool is_noticed = false;
  };
  /// Of its pressure, as far as it is clear.
  static std::optional<double> share_missed(const Segment& sums);

  std::vector<Segment> segments_;
  std::vector<PressureLoss> found_;
  Pressures before_kpa_;
  double frame_period_s_;
  int frames_ = 0;
};

}  // namespace limber
