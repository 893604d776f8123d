#include "limber/run/model_arm.hpp"

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/run/safety_gate.hpp"

namespace limber {

namespace {

Backbone straight_backbone(const ForwardModel& forward) {
  Backbone backbone(forward.point_count(), kPoseSize);
  const Pressures none = Pressures::Zero(forward.channel_count());
  forward.no_load().backbone(none, backbone);
  return backbone;
}

}  // namespace

ModelArm::ModelArm(const ArmDescription& arm, CompensationModel network,
                   const ValveParameters& valves)
    : arm_(arm),
      forward_(arm, std::move(network)),
      motion_(forward_, ValveModel(arm, valves)),
      motion_state_(motion_.settled_state(Pressures::Zero(arm.channel_count()),
                                          straight_backbone(forward_))) {
  look();
}

const ArmState& ModelArm::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  const Pressures setpoint = checked_setpoints(arm_, setpoint_kpa).cast<float>();
  motion_.step(setpoint, motion_state_, workspace_);
  ++frame_;
  if (!motion_state_.backbone.allFinite()) {
    throw SystemFault(fmt::format("the model's prediction is not finite after {:.2f} s",
                                  double(frame_) * arm_.frame_period_s()));
  }
  look();
  return state_;
}

void ModelArm::look() {
  state_.time_s = double(frame_) * arm_.frame_period_s();
  state_.pressure_kpa = motion_state_.pressure_kpa();
  state_.backbone = motion_state_.backbone;
}

}  // namespace limber
