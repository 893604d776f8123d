#include "limber/run/model_arm.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

constexpr float kRounding = 1e-3F;  // of the command's unit: as the virtual arm

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

Pressures ModelArm::within_limits(const Eigen::Ref<const Pressures>& setpoint_kpa) const {
  if (setpoint_kpa.size() != arm_.channel_count()) {
    throw InputError(fmt::format("{} set points; arm '{}' has {} segments", setpoint_kpa.size(),
                                 arm_.name, arm_.channel_count()));
  }
  Pressures result = setpoint_kpa;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const PressureLimits& limits = arm_.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
    const auto lower = static_cast<float>(limits.lower_kpa);
    const auto upper = static_cast<float>(limits.upper_kpa);
    if (!(result[i] >= lower - kRounding && result[i] <= upper + kRounding)) {
      throw InputError(fmt::format("set point of {} is {} {}; expected {} to {}", segment_name(i),
                                   result[i], arm_.command.unit, lower, upper));
    }
    result[i] = std::clamp(result[i], lower, upper);
  }
  return result;
}

const ArmState& ModelArm::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  const Pressures setpoint = within_limits(setpoint_kpa);
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
