#pragma once

#include <functional>
#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_estimate.hpp"
#include "limber/driver/process_driver.hpp"

namespace limber {

struct CalibrateDriverSettings {
  ProcessDriverSettings driver;  ///< limits, rates and what is watched are set here
  CalibrationTolerance tolerance;
  /// Told what comes next; returns when it may begin, throws Interrupted to end.
  std::function<void(const std::string& step)> confirm;
  /// Asked once, after the timing step, what only a person or a setting can say.
  std::function<OperatorAnswer(int channel)> answer;
};

/// What came of it. The log is whole also where an estimate was refused.
struct DriverCalibration {
  CalibrationEstimate estimate;
  CalibrationLog log;
  DriverHello hello;
};

/// `limber driver calibrate`: channels may be crossed, so each is moved alone, at a tenth of the
/// smallest limit, vented between steps, and the gate is in force with a tenth of the limits.
/// @throws SystemFault where the driver fails, or a marker body jumps; Interrupted.
DriverCalibration calibrate_driver(const ArmDescription& arm,
                                   const CalibrateDriverSettings& settings);

}  // namespace limber
