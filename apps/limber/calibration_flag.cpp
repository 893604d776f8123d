#include "calibration_flag.hpp"

namespace limber {

void CalibrationFlag::add_to(CLI::App& app) {
  app.add_option("--calibration", file_,
                 "File of limber driver calibrate: channels, "
                 "signs, zeros and the tracker's frame of a driver");
}

std::optional<WireCalibration> CalibrationFlag::read(const ArmDescription& arm) const {
  if (!is_given()) {
    return std::nullopt;
  }
  WireCalibration calibration = read_wire_calibration(file_);
  require_calibration_of(calibration, arm, file_);
  return calibration;
}

}  // namespace limber
