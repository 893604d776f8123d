#include "limber/forward/motion_model.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/network/arm_family.hpp"

namespace limber {

namespace {

/// Size n without a heap.
using SmallPressures = Eigen::Matrix<float, Eigen::Dynamic, 1, 0, kMaxSegments, 1>;

/// What a segment's bending by `turn_rad` and growing by `grown_m` about its middle does to `tip`.
void turn_about(const Pose& middle, double turn_rad, double grown_m, Pose& tip) {
  const double along = middle.theta_rad + 0.5 * turn_rad;
  const Pose from_middle{tip.x_m - middle.x_m, tip.y_m - middle.y_m, tip.theta_rad};
  tip = compose(Pose{middle.x_m, middle.y_m, turn_rad}, from_middle);
  tip.x_m += grown_m * std::cos(along);
  tip.y_m += grown_m * std::sin(along);
}

}  // namespace

MotionModel::MotionModel(const ForwardModel& forward)
    : MotionModel(forward, ValveModel::ideal(forward.channel_count())) {}

MotionModel::MotionModel(const ForwardModel& forward, ValveModel valves)
    : forward_(&forward), valves_(std::move(valves)) {
  if (valves_.segment_count() != forward.channel_count()) {
    throw InputError(fmt::format(
        "motion model: valves of {} channels; the model of arm '{}' has {}",
        valves_.segment_count(), forward.no_load().arm_name(), forward.channel_count()));
  }
  if (forward.has_network()) {
    require_one_arm(forward.compensation(), "motion model");
    require_no_valves_before(forward.compensation(), valves_.parameters(), "motion model");
  }
}

MotionState MotionModel::settled_state(const Eigen::Ref<const Pressures>& kpa,
                                       const Eigen::Ref<const Backbone>& backbone) const {
  return moving_state(valves_.settled_state(kpa), backbone, backbone);
}

MotionState MotionModel::moving_state(Eigen::VectorXf valves,
                                      const Eigen::Ref<const Backbone>& backbone,
                                      const Eigen::Ref<const Backbone>& before) const {
  MotionState state{channel_count(), std::move(valves), backbone};
  if (reads_velocity()) {
    state.before = before;
  }
  return state;
}

void MotionModel::step(const Eigen::Ref<const Pressures>& setpoint_kpa, MotionState& state,
                       Workspace& workspace) const {
  const SmallPressures before_kpa = state.pressure_kpa();
  valves_.step(setpoint_kpa, state.valves);
  step_shape(before_kpa, state.pressure_kpa(), state.before, state.backbone, workspace);
}

void MotionModel::step_shape(const Eigen::Ref<const Pressures>& before_kpa,
                             const Eigen::Ref<const Pressures>& pressure_kpa, Backbone& before,
                             Backbone& backbone, Workspace& workspace) const {
  if (!reads_velocity()) {
    forward_->step(before_kpa, pressure_kpa, backbone, backbone, workspace);
    return;
  }
  forward_->step(before_kpa, pressure_kpa, before, backbone, before, workspace);
  before.swap(backbone);
}

Pose MotionModel::settled_tip(const Eigen::Ref<const Eigen::VectorXf>& valves,
                              const Eigen::Ref<const Backbone>& backbone) const {
  Pose tip = tip_pose(backbone);
  const int n = segment_count();
  Eigen::Index end = backbone.rows() - 1;
  // From the tip's side: what lies beyond a segment has turned already.
  for (int i = n - 1; i >= 0; --i) {
    const int gaps = no_load().segment(i).gaps;
    const Eigen::Index begin = end - gaps;
    const double now_kpa = double(valves[i]);
    const double then_kpa = double(valves[n + i]);
    if (now_kpa != then_kpa) {
      const SegmentShape now = no_load().segment_shape(i, now_kpa);
      const SegmentShape then = no_load().segment_shape(i, then_kpa);
      const double turn = then.curvature_per_m * then.length_m - now.curvature_per_m * now.length_m;
      const Pose middle = pose_of(
          0.5 * (backbone.row(begin + gaps / 2) + backbone.row(end - gaps / 2)).cast<double>());
      turn_about(middle, turn, then.length_m - now.length_m, tip);
    }
    end = begin;
  }
  return tip;
}

void require_model_of_arm(const ArmDescription& arm, const MotionModel& model,
                          const std::string& where) {
  const auto modelled =
      mapped<int>(model.segment_count(), [&](int i) { return model.no_load().segment(i).gaps; });
  const auto own = mapped<int>(arm.segments, [&](const Segment& segment) { return segment.gaps; });
  if (modelled != own || model.channel_count() != arm.channel_count()) {
    throw InputError(fmt::format(
        "{}: the model is of arm '{}', with {} channels and segments of {} gaps; arm "
        "'{}' has {} and {}",
        where, model.no_load().arm_name(), model.channel_count(), fmt::join(modelled, ", "),
        arm.name, arm.channel_count(), fmt::join(own, ", ")));
  }
}

std::string why_valves_are_missing(const MotionModel& model) {
  if (!model.valves().is_ideal() ||
      (model.has_network() && model.compensation().learnt_from_setpoints)) {
    return "";
  }
  const std::string reason =
      model.has_network() ? model.compensation().valve_findings.reason : std::string();
  return "no valve model" + (reason.empty() ? reason : " (" + reason + ")") +
         ": the set points are taken for the " + followed_name(model.no_load().command()) +
         "s, but an arm whose valves lag is elsewhere while it moves";
}

}  // namespace limber
