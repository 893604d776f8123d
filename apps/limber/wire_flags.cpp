#include "wire_flags.hpp"

#include "limber/common/error.hpp"

namespace limber {

void WireFlags::add_to(CLI::App& app) {
  app.add_option("--calibration", calibration_,
                 "File of limber driver calibrate: channels, "
                 "signs, zeros and the tracker's frame of a driver");
  app.add_flag("--simulated", simulated_,
               "The driver may be a simulation that runs as fast as it is asked (real_time: false "
               "in its hello); not for an arm");
}

ProcessDriverSettings WireFlags::settings(const std::string& driver, const ArmDescription& arm,
                                          const std::string& arm_file) const {
  if (!driver.starts_with(kExec)) {
    throw InputError(
        fmt::format("driver '{}': expected exec:COMMAND, as in \"exec:python3 my_driver.py\" "
                    "(docs/driver.md)",
                    driver));
  }
  ProcessDriverSettings settings;
  settings.command = driver.substr(kExec.size());
  settings.simulated = simulated_;
  settings.safety = load_safety(arm_file);
  if (is_calibrated()) {
    settings.calibration = read_wire_calibration(calibration_);
    require_calibration_of(*settings.calibration, arm, calibration_);
  }
  return settings;
}

}  // namespace limber
