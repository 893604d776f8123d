#pragma once

#include <optional>
#include <string>

#include "limber/hardware/wire_calibration.hpp"
#include "verb.hpp"

namespace limber {

/// --calibration FILE: what `limber driver calibrate` found lies between a driver and its arm.
class CalibrationFlag {
 public:
  void add_to(CLI::App& app);
  bool is_given() const { return !file_.empty(); }
  /// None where it was not given. @throws InputError where the file is another arm's.
  std::optional<WireCalibration> read(const ArmDescription& arm) const;

 private:
  std::string file_;
};

}  // namespace limber
