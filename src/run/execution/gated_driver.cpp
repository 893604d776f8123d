#include "limber/run/gated_driver.hpp"

#include <string>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"

namespace limber {

GatedDriver::GatedDriver(const ArmDescription& arm, ArmDriver& driver, bool check_rate)
    : driver_(driver), gate_(arm, limits_of(arm), check_rate, SafetySettings()) {}

const ArmState& GatedDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  if (const std::string wrong = gate_.check_command(setpoint_kpa); !wrong.empty()) {
    throw SystemFault(wrong);
  }
  return driver_.command(setpoint_kpa);
}

}  // namespace limber
