#include "plan_chain.hpp"

#include <algorithm>
#include <utility>

#include "limber/common/interrupt.hpp"
#include "limber/run/collision_watch.hpp"

namespace limber {

namespace {

/// So long an arm is held under pressure while the next plan is searched for.
constexpr double kLongestSearchS = 3.0;

}  // namespace

PlanChain::PlanChain(const ArmDescription& arm, int first, int count, double max_s, PlanIn plan_in)
    : arm_(arm), next_(first), end_(first + count), max_s_(max_s), plan_in_(std::move(plan_in)) {
  tried_.reserve(static_cast<std::size_t>(count));  // so that none moves
}

const PlannedRun* PlanChain::first_plan() {
  const PlannedRun* begun = plan_from(std::nullopt);
  if (begun != nullptr) {
    executed_.push_back({tried_.size() - 1});
  }
  return begun;
}

const PlannedRun* PlanChain::plan_from(const std::optional<ArmStart>& start) {
  while (next_ < end_ && !interrupt_requested() && !has_held_for_long()) {
    tried_.push_back(plan_in_(next_++, start));
    if (tried_.back().plan) {
      return &tried_.back();
    }
  }
  return nullptr;
}

bool PlanChain::has_held_for_long() const {
  return !executed_.empty() &&
         (seen_ - 1 - executed_.back().last_frame) * arm_.frame_period_s() > kLongestSearchS;
}

FrameSetpoint PlanChain::setpoint(const PlanProgress& at, std::size_t next,
                                  const ArmEstimate& arm) {
  if (at.frame == 0) {
    executed_.back().first_frame = seen_ - 1;  // an arm whose plan was searched for held meanwhile
  }
  return PlanController::setpoint(at, next, arm);
}

/// The question throws Interrupted.
PlanController::NextPlan PlanChain::next(const PlanProgress& at, const ArmEstimate& arm) {
  executed_.back().last_frame = seen_ - 1;
  const std::optional<Backbone>& rest = arm.measured().backbone;
  if (!rest || executed_.back().last_frame * arm_.frame_period_s() >= max_s_) {
    return {};
  }
  return [this, start = ArmStart{at.sent_kpa, *rest}]() -> std::optional<Plan> {
    const PlannedRun* found = plan_from(start);
    throw_if_interrupted();
    if (found == nullptr) {
      return std::nullopt;
    }
    executed_.push_back({tried_.size() - 1});
    return found->plan;
  };
}

PlanRuns PlanChain::ended(const ExecutionResult& run) const {
  PlanRuns result;
  for (const PlannedRun& one : tried_) {
    result.runs.push_back(one.run);
  }
  const bool is_recorded = run.episode.frame_count() > run.frames;
  if (is_recorded && !executed_.empty()) {
    result.episodes.push_back(run.episode);
  }
  for (std::size_t k = 0; k < executed_.size(); ++k) {
    const bool is_last = k + 1 == executed_.size();
    const int first = executed_[k].first_frame;
    const int end = is_last ? run.frames : executed_[k + 1].first_frame;
    PlanRun& one = result.runs[executed_[k].planned];
    one.executed = true;
    one.was_vented = k == 0;
    one.recorded = is_recorded;
    one.duration_s = (end - first) * arm_.frame_period_s();
    result.arm_time_s += one.duration_s;
    if (executed_.size() == 1) {
      one.collided = run.collided;
      one.arrived = has_arrived(run);
      one.distance_m = run.final_backbone ? std::optional(run.goal_error.position_m) : std::nullopt;
    } else if (is_recorded) {
      judge(run.episode, executed_[k], tried_[executed_[k].planned].environment, one);
    }
    if (is_recorded) {
      std::vector<int>& motions = result.episodes.front().motion_index;
      std::fill(motions.begin() + (k == 0 ? 0 : first + 1), motions.begin() + end + 1,
                static_cast<int>(k));
    }
  }
  return result;
}

void PlanChain::judge(const Episode& episode, const Executed& frames,
                      const Environment& environment, PlanRun& run) const {
  CollisionWatch watch(arm_, environment);
  BackboneD shape;
  for (int t = frames.first_frame; t <= frames.last_frame; ++t) {
    if (episode.was_tracked(t)) {
      shape = backbone_at(episode.backbone, t).cast<double>();
      watch.observe(episode.time_s[t], shape);
    }
  }
  run.collided = watch.first_collision().has_value();
  if (episode.was_tracked(frames.last_frame)) {
    const PoseError error = pose_error(environment.goal, tip_pose(shape));
    run.distance_m = error.position_m;
    run.arrived = is_within(environment.goal, error) && !run.collided;
  }
}

}  // namespace limber
