#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limber/driver/calibrate_driver.hpp"
#include "verb.hpp"

namespace limber {

/// `limber driver calibrate`: its flags, its questions and its file.
class DriverCalibrate {
 public:
  void add_to(CLI::App& app);
  /// @param driver  without a calibration
  /// @param out     the calibration's file
  int run(const ArmDescription& arm, const ProcessDriverSettings& driver, const std::string& out,
          const CommonFlags& flags) const;

 private:
  OperatorAnswer answer(int channel) const;

  bool yes_ = false;
  std::string handedness_;
  std::vector<double> base_marker_m_;
  CalibrationTolerance tolerance_;
};

}  // namespace limber
