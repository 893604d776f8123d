#pragma once

#include <string>
#include <string_view>

#include "limber/driver/process_driver.hpp"
#include "verb.hpp"

namespace limber {

/// What --driver and its like begin with, before the driver's own command.
inline constexpr std::string_view kExec = "exec:";

/// What limber has to know of a driver that it starts, in every verb that does: --calibration FILE,
/// what `limber driver calibrate` found lies between it and its arm, and --simulated.
class WireFlags {
 public:
  void add_to(CLI::App& app);
  bool is_calibrated() const { return !calibration_.empty(); }

  /// For the program of `exec:COMMAND`. @param driver  that whole text
  /// @param arm_file  its mapping `safety` says what is watched
  /// @throws InputError where the text is another, or the calibration is another arm's.
  ProcessDriverSettings settings(const std::string& driver, const ArmDescription& arm,
                                 const std::string& arm_file) const;

 private:
  std::string calibration_;
  bool simulated_ = false;
};

}  // namespace limber
