#include "plan_chain.hpp"

#include <utility>

#include "limber/common/interrupt.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/hardware/collision_watch.hpp"

namespace limber {

PlanChain::PlanChain(const ArmDescription& arm, int first, int count, double max_s, PlanIn plan_in)
    : arm_(arm), next_(first), end_(first + count), max_s_(max_s), plan_in_(std::move(plan_in)) {
  tried_.reserve(static_cast<std::size_t>(count));  // so that none moves
}

const PlannedRun* PlanChain::begin() {
  const PlannedRun* begun = plan_from(std::nullopt);
  if (begun != nullptr) {
    executed_.push_back({tried_.size() - 1});
  }
  return begun;
}

const PlannedRun* PlanChain::plan_from(const std::optional<ArmStart>& start) {
  while (next_ < end_ && !interrupt_requested()) {
    tried_.push_back(plan_in_(next_++, start));
    if (tried_.back().plan) {
      return &tried_.back();
    }
  }
  return nullptr;
}

void PlanChain::observe(const Pressures& /*setpoint_kpa*/, const ArmState& /*state*/) {
  ++seen_;
}

Pressures PlanChain::setpoint(const Plan& plan, std::size_t frame, std::size_t next) {
  if (frame == 0) {
    executed_.back().first_frame = seen_ - 1;  // an arm whose plan was searched for held meanwhile
  }
  return plan.frames[next].setpoint_kpa;
}

std::optional<Plan> PlanChain::next(const Plan& plan, std::size_t frame, const ArmState& state) {
  executed_.back().last_frame = seen_ - 1;
  if (!state.backbone || executed_.back().last_frame * arm_.frame_period_s() >= max_s_) {
    return std::nullopt;
  }
  const PlannedRun* found = plan_from(ArmStart{plan.frames[frame].setpoint_kpa, *state.backbone});
  throw_if_interrupted();
  if (found == nullptr) {
    return std::nullopt;
  }
  executed_.push_back({tried_.size() - 1});
  return found->plan;
}

PlanRuns PlanChain::ended(const ExecutionResult& run) const {
  PlanRuns result;
  std::size_t done = 0;
  for (std::size_t k = 0; k < tried_.size(); ++k) {
    PlanRun one = tried_[k].run;
    if (done < executed_.size() && executed_[done].planned == k) {
      const bool is_alone = executed_.size() == 1;
      const int first = is_alone ? 0 : executed_[done].first_frame;
      const int last = is_alone ? run.frames : executed_[done].last_frame;
      one.executed = true;
      one.was_vented = done == 0;
      one.duration_s = (last - first) * arm_.frame_period_s();
      if (is_alone) {
        one.collided = run.collided;
        one.arrived = run.goal_reached && !run.collided;
        one.distance_m =
            run.final_backbone ? std::optional(run.goal_error.position_m) : std::nullopt;
      }
      if (run.episode.frame_count() > last) {
        Episode episode = slice(run.episode, first, last - first + 1);
        if (!is_alone) {
          judge(episode, tried_[k].environment, one);
        }
        one.recorded = true;
        result.episodes.push_back(std::move(episode));
      }
      ++done;
    }
    result.arm_time_s += one.duration_s;
    result.runs.push_back(std::move(one));
  }
  return result;
}

void PlanChain::judge(const Episode& episode, const Environment& environment, PlanRun& run) const {
  CollisionWatch watch(arm_, environment);
  BackboneD shape;
  for (int t = 0; t < episode.frame_count(); ++t) {
    if (episode.was_tracked(t)) {
      shape =
          episode.backbone.row(t).reshaped<Eigen::RowMajor>(arm_.point_count(), 3).cast<double>();
      watch.observe(episode.time_s[t], shape);
    }
  }
  run.collided = watch.first_collision().has_value();
  if (episode.was_tracked(episode.frame_count() - 1)) {
    const PoseError error = pose_error(environment.goal, tip_pose(shape));
    run.distance_m = error.position_m;
    run.arrived = is_within(environment.goal, error) && !run.collided;
  }
}

}  // namespace limber
