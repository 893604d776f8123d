#include "limber/driver/dry_run_driver.hpp"

#include "limber/arm/no_load_model.hpp"
#include "limber/driver/driver_protocol.hpp"

namespace limber {

DryRunDriver::DryRunDriver(const ArmDescription& arm,
                           std::function<void(const std::string& line)> print)
    : period_s_(arm.frame_period_s()), print_(std::move(print)) {
  state_.pressure_kpa = Pressures::Zero(arm.channel_count());
  Backbone straight(arm.point_count(), kPoseSize);
  NoLoadModel(arm).backbone(Eigen::Ref<const Eigen::VectorXf>(state_.pressure_kpa),
                            Eigen::Ref<Backbone>(straight));
  state_.backbone = straight;
  print_(to_line(host_hello(arm)));
}

DryRunDriver::~DryRunDriver() {
  print_(bye_line());
}

const ArmState& DryRunDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  state_.time_s = static_cast<double>(seq_) * period_s_;
  print_(set_line(seq_, state_.time_s, setpoint_kpa));
  ++seq_;
  state_.pressure_kpa = setpoint_kpa;
  resting_ = false;
  return state_;
}

void DryRunDriver::vent() noexcept {
  if (!resting_) {
    print_(vent_line(seq_, static_cast<double>(seq_) * period_s_));
    ++seq_;
    resting_ = true;
  }
}

}  // namespace limber
