#include "limber/run/gated_driver.hpp"

#include "limber/arm/pressure_limits.hpp"
#include "limber/run/episode_recorder.hpp"

namespace limber {

GatedDriver::GatedDriver(const ArmDescription& arm, ArmDriver& driver, bool check_rate)
    : arm_(arm), driver_(driver), gate_(arm, limits_of(arm), check_rate, SafetySettings()) {}

const ArmState& GatedDriver::state() const {
  require_state_of(arm_, driver_.state());
  return driver_.state();
}

const ArmState& GatedDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  throw_if_wrong(gate_.check_command(setpoint_kpa));
  driver_.command(setpoint_kpa);
  return state();
}

}  // namespace limber
