#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/driver/process_driver.hpp"

namespace limber {

/// One channel's answer to a jump of its set point from zero.
struct StepResponse {
  int channel = 0;            ///< segment, or chamber of an arm in space
  double setpoint_kpa = 0.0;  ///< signed: the side
  double reached_kpa = 0.0;   ///< mean over the last frames of the hold
  double dead_time_s = 0.0;   ///< until the reading moved; frames apart, interpolated
  double rise_time_s = 0.0;   ///< from 10 to 90 % of what was reached
  double overshoot_kpa = 0.0;
  bool answered = false;  ///< whether it moved and rose at all
};

/// Whether a driver's own deadman vents, and what was read then.
struct DeadmanResult {
  bool tested = false;
  bool vented = false;
  /// Of one that reads no pressure when it starts, whatever it left behind: nothing is known.
  bool starts_vented = false;
  double before_kpa = 0.0;
  double after_kpa = 0.0;
};

/// What a driver and its arm are like: `limber driver check`.
struct DriverCheck {
  DriverHello hello;
  DriverTiming timing;
  std::vector<std::string> channels;  ///< names: segments, or chambers of an arm in space
  std::vector<double> noise_kpa;      ///< standard deviation at rest, one per channel
  std::vector<double> zero_kpa;       ///< mean reading at rest
  std::vector<StepResponse> steps;
  DeadmanResult silence;                ///< no `set` for more than three frames
  DeadmanResult end_of_input;           ///< its input closed, as limber's end closes it; read by
                                        ///< a second start, once the page's 0.3 s are over
  std::vector<std::string> complaints;  ///< what is wrong; empty: nothing was found
  Episode episode;  ///< everything that was commanded and measured; backbones are not kept
};

/// Moves each segment, or chamber of an arm in space, alone, to either side: pulses of 5 % of the
/// limits in force, and only where those read right, jumps to 30 % of them. Takes about 20 s and
/// 10 s per segment.
/// @throws SystemFault where the driver fails, or reads a pressure when vented; Interrupted.
DriverCheck check_driver(const ArmDescription& arm, const ProcessDriverSettings& settings);

/// How long a driver is left alone until its arm has to be vented: three frames or the device's
/// 0.3 s (docs/driver.md), and time for the valves.
inline double silence_s(double period_s) {
  constexpr double kDeviceS = 0.3;
  constexpr double kFrames = 3.0;
  constexpr double kValvesS = 0.35;
  return std::max(kDeviceS, kFrames * period_s) + kValvesS;
}

/// What a reading of `measured_kpa` at a set point of `setpoint_kpa` says about the driver's unit;
/// empty where it is within a factor of two. @param channel  its name
std::string scale_complaint(const std::string& channel, double setpoint_kpa, double measured_kpa);

/// Of readings at a fixed rate that begin right after a jump from zero.
StepResponse step_response(const std::vector<double>& reading_kpa, double period_s,
                           double setpoint_kpa, double noise_kpa);

}  // namespace limber
