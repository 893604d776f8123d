#include "limber/run/gated_driver.hpp"

#include <string>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/run/episode_recorder.hpp"

namespace limber {

GatedDriver::GatedDriver(const ArmDescription& arm, ArmDriver& driver, bool check_rate)
    : arm_(arm), driver_(driver), gate_(arm, limits_of(arm), check_rate, SafetySettings()) {}

const ArmState& GatedDriver::state() const {
  require_state_of(arm_, driver_.state());
  return driver_.state();
}

const ArmState& GatedDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  if (const std::string wrong = gate_.check_command(setpoint_kpa); !wrong.empty()) {
    throw SystemFault(wrong);
  }
  driver_.command(setpoint_kpa);
  return state();
}

}  // namespace limber
