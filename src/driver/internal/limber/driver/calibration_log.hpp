#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// One request and its answer, as they are on the wire: nothing is put in order yet.
struct CalibrationFrame : DriverExchange {
  Pressures setpoint_kpa;  ///< of the wire's channels
  ArmState state;          ///< its time is the driver's; bodies stand in place of its backbone
};

/// (x, y, z) of each body, z = 0 where it is not seen; none where nothing was.
std::optional<Eigen::MatrixX3d> seen_positions(const CalibrationFrame& frame);

/// Frames of a step, `first` to `end` − 1. A pulse holds its set point until
/// `hold_end`, and is zero from then on.
struct CalibrationPulse {
  int channel = 0;
  double setpoint_kpa = 0.0;
  std::size_t first = 0;
  std::size_t hold_end = 0;
  std::size_t end = 0;
};

/// One channel goes up and down: slowly until `fast_first`, then fast.
struct CalibrationTiming {
  int channel = 0;
  std::size_t first = 0;
  std::size_t peak = 0;  ///< the first frame of the first hold at the top
  std::size_t fast_first = 0;
  std::size_t end = 0;
};

/// Everything that a calibration is found from.
struct CalibrationLog {
  std::vector<CalibrationFrame> frames;
  std::size_t rest_end = 0;              ///< the arm lies straight and vented until there
  std::vector<CalibrationPulse> pulses;  ///< channel by channel, up and down
  CalibrationTiming timing;
  bool real_time = true;  ///< false: a simulation, whose clock is no clock
};

/// What moves while a log is recorded.
struct CalibrationRig {
  /// One frame. @param setpoint_kpa  of the wire's channels
  std::function<CalibrationFrame(const Pressures& setpoint_kpa)> command;
  std::function<void()> vent;
  /// Told what comes next, before it moves; returns when it may. Throws to end the calibration.
  std::function<void(const std::string& step)> confirm;
};

/// What each channel is raised to: a tenth of the smallest limit of any side, since it is not known
/// yet which side it is. @throws InputError where a segment has one side only.
double calibration_pulse_kpa(const ArmDescription& arm);

/// Rest, a pulse of each channel to either side with a vent after it, then slow and fast ramps of
/// the channel that bends the arm most. Set points keep the arm's rate limit.
CalibrationLog record_calibration(const ArmDescription& arm, double pulse_kpa,
                                  const CalibrationRig& rig);

}  // namespace limber
