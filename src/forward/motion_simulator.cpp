#include "limber/forward/motion_simulator.hpp"

#include <algorithm>

namespace limber {

namespace {

/// Set points that were commanded `back` ≥ 0 frames before an arm's start.
const Pressures& setpoint_before(const ArmStart& start, std::size_t back) {
  const std::vector<Pressures>& known = start.setpoints_kpa;
  return known.empty() ? start.pressures_kpa : known[std::min(back, known.size() - 1)];
}

}  // namespace

MotionState state_of(const ArmStart& start, const MotionModel& model) {
  MotionState state = model.settled_state(start.pressures_kpa, start.backbone);
  if (model.reads_velocity() && start.before.rows() > 0) {
    state.before = start.before;
  }
  const Eigen::Index n = state.segments;
  for (int back = 0; back < model.valves().setpoint_count(); ++back) {
    state.valves.segment((1 + back) * n, n) = setpoint_before(start, std::size_t(back));
  }
  return state;
}

MotionState state_after(const std::vector<PlanFrame>& frames, const MotionModel& model,
                        const ArmStart* start) {
  const PlanFrame& last = frames.back();
  const Eigen::Index n = last.setpoint_kpa.size();
  const bool is_first = frames.size() == 1;
  const bool moved = is_first && start != nullptr && start->before.rows() > 0;
  MotionState state =
      model.moving_state(Eigen::VectorXf(model.valves().state_size()), last.backbone,
                         moved      ? start->before
                         : is_first ? last.backbone
                                    : frames[frames.size() - 2].backbone);
  state.valves.head(n) = last.pressure_kpa;
  const std::size_t newest = frames.size() - 1;
  for (std::size_t back = 0; back < std::size_t(model.valves().setpoint_count()); ++back) {
    const bool is_of_plan = back <= newest || start == nullptr;
    state.valves.segment(Eigen::Index(1 + back) * n, n) =
        is_of_plan ? frames[newest - std::min(newest, back)].setpoint_kpa
                   : setpoint_before(*start, back - newest);
  }
  return state;
}

MotionSimulator::MotionSimulator(const ArmDescription& arm, const MotionModel& model,
                                 const CollisionChecker& checker)
    : arm_(arm),
      model_(model),
      checker_(checker),
      setpoint_kpa_(arm.channel_count()),
      before_(arm.point_count(), kPoseSize) {}

void MotionSimulator::step(const PressuresRef& setpoint_kpa) {
  before_ = state_.backbone;
  model_.step(setpoint_kpa, state_, workspace_);
  ++queries_;
}

bool MotionSimulator::move(const MotionState& from, const PressuresRef& to_kpa, MotionState& end) {
  const Pressures from_kpa = from.setpoint_kpa();
  const int count = motion_frame_count(from_kpa, to_kpa, arm_.pressure_step_limit_kpa());
  state_ = from;
  bool is_free = true;
  for (int k = 1; k <= count && is_free; ++k) {
    motion_setpoint(from_kpa, to_kpa, k, count, setpoint_kpa_);
    step(setpoint_kpa_);
    is_free = checker_.is_motion_free(before_, state_.backbone);
  }
  end = state_;
  return is_free;
}

void MotionSimulator::move_unchecked(const MotionState& from, const PressuresRef& to_kpa,
                                     MotionState& end) {
  const Pressures from_kpa = from.setpoint_kpa();
  const int count = motion_frame_count(from_kpa, to_kpa, arm_.pressure_step_limit_kpa());
  state_ = from;
  for (int k = 1; k <= count; ++k) {
    motion_setpoint(from_kpa, to_kpa, k, count, setpoint_kpa_);
    step(setpoint_kpa_);
  }
  end = state_;
}

bool MotionSimulator::hold(const MotionState& from, int frames, MotionState& end) {
  state_ = from;
  setpoint_kpa_ = from.setpoint_kpa();
  bool is_free = true;
  for (int k = 0; k < frames && is_free; ++k) {
    step(setpoint_kpa_);
    is_free = checker_.is_motion_free(before_, state_.backbone);
  }
  end = state_;
  return is_free;
}

bool MotionSimulator::hold(const MotionState& from, MotionState& end) {
  return hold(from, hold_frame_count(arm_, model_.valves(), from.valves), end);
}

void MotionSimulator::append_frame(const PressuresRef& setpoint_kpa,
                                   std::vector<PlanFrame>& frames) {
  step(setpoint_kpa);
  frames.push_back({setpoint_kpa, state_.pressure_kpa(), state_.backbone});
}

void MotionSimulator::append_motion(const PressuresRef& to_kpa, std::vector<PlanFrame>& frames,
                                    const ArmStart* start) {
  const Pressures from_kpa = frames.back().setpoint_kpa;
  const int count = motion_frame_count(from_kpa, to_kpa, arm_.pressure_step_limit_kpa());
  state_ = state_after(frames, model_, start);
  for (int k = 1; k <= count; ++k) {
    motion_setpoint(from_kpa, to_kpa, k, count, setpoint_kpa_);
    append_frame(setpoint_kpa_, frames);
  }
}

int MotionSimulator::append_hold(std::vector<PlanFrame>& frames, const ArmStart* start) {
  state_ = state_after(frames, model_, start);
  setpoint_kpa_ = frames.back().setpoint_kpa;
  const int count = hold_frame_count(arm_, model_.valves(), state_.valves);
  for (int k = 0; k < count; ++k) {
    append_frame(setpoint_kpa_, frames);
  }
  return count;
}

void MotionBatch::run(const std::vector<MotionState>& from,
                      const Eigen::Ref<const Eigen::MatrixXf>& to_kpa) {
  const auto motions = int(from.size());
  frames_.resize(from.size());
  ends_.resize(from.size());
  rollouts_.clear();
  for (int j = 0; j < motions; ++j) {
    const MotionState& start = from[j];
    const int frames = motion_frame_count(start.setpoint_kpa(), to_kpa.col(j),
                                          simulator_.arm().pressure_step_limit_kpa());
    Eigen::MatrixXf& kept = frames_[j];
    kept.resize(start.backbone.size(), frames + 1);
    kept.col(0) = Eigen::Map<const Eigen::VectorXf>(start.backbone.data(), kept.rows());
    rollouts_.add(j, start, to_kpa.col(j), frames);
  }
  while (rollouts_.size() > 0) {
    simulator_.count_queries(std::uint64_t(rollouts_.size()));
    rollouts_.step();
    for (int column = rollouts_.size() - 1; column >= 0; --column) {
      const auto motion = std::size_t(rollouts_.label(column));
      frames_[motion].col(rollouts_.frame(column)) =
          Eigen::Map<const Eigen::VectorXf>(rollouts_.now(column).data(), frames_[motion].rows());
      if (rollouts_.has_ended(column)) {
        ends_[motion] = rollouts_.state(column);
        rollouts_.remove(column);
      }
    }
  }
}

Eigen::Map<const Backbone> MotionBatch::frame(int motion, int k) const {
  const Eigen::MatrixXf& kept = frames_[motion];
  return {kept.col(k).data(), kept.rows() / kPoseSize, kPoseSize};
}

bool MotionBatch::is_free(int motion, const CollisionChecker& checker) const {
  for (int k = 1; k <= frame_count(motion); ++k) {
    if (!checker.is_motion_free(frame(motion, k - 1), frame(motion, k))) {
      return false;
    }
  }
  return true;
}

}  // namespace limber
