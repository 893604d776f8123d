#include "limber/planning/motion_simulator.hpp"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kRoundingFrames = 1e-6;  // float32 set points of a motion of whole frames

}  // namespace

Pressures pressure_limits_kpa(const ArmDescription& arm) {
  Pressures limits(arm.segment_count());
  for (int i = 0; i < limits.size(); ++i) {
    limits[i] = static_cast<float>(arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa);
  }
  return limits;
}

int motion_frame_count(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                       double step_limit_kpa) {
  const double largest = double((to_kpa - from_kpa).lpNorm<Eigen::Infinity>());
  return std::max(1, static_cast<int>(std::ceil(largest / step_limit_kpa - kRoundingFrames)));
}

double motion_cost_kpa(const PressuresRef& from_kpa, const PressuresRef& to_kpa) {
  return (to_kpa.cast<double>() - from_kpa.cast<double>()).lpNorm<1>();
}

MotionSimulator::MotionSimulator(const ArmDescription& arm, const ForwardModel& model,
                                 const CollisionChecker& checker)
    : arm_(arm),
      model_(model),
      checker_(checker),
      previous_kpa_(arm.segment_count()),
      current_kpa_(arm.segment_count()),
      previous_(arm.point_count(), 3),
      current_(arm.point_count(), 3) {}

void MotionSimulator::step(const PressuresRef& previous_kpa, const PressuresRef& current_kpa,
                           const BackboneRef& previous, Eigen::Ref<Backbone> next) {
  model_.step(previous_kpa, current_kpa, previous, next, workspace_);
  ++queries_;
}

bool MotionSimulator::move(const PressuresRef& from_kpa, const BackboneRef& from,
                           const PressuresRef& to_kpa, Eigen::Ref<Backbone> end) {
  const int count = motion_frame_count(from_kpa, to_kpa, arm_.pressure_step_limit_kpa());
  previous_kpa_ = from_kpa;
  previous_ = from;
  bool is_free = true;
  for (int k = 1; k <= count && is_free; ++k) {
    motion_setpoint(from_kpa, to_kpa, k, count, current_kpa_);
    step(previous_kpa_, current_kpa_, previous_, current_);
    is_free = checker_.is_motion_free(previous_, current_);
    previous_kpa_.swap(current_kpa_);
    previous_.swap(current_);
  }
  end = previous_;
  return is_free;
}

void MotionSimulator::move_unchecked(const PressuresRef& from_kpa, const BackboneRef& from,
                                     const PressuresRef& to_kpa, Eigen::Ref<Backbone> end) {
  const int count = motion_frame_count(from_kpa, to_kpa, arm_.pressure_step_limit_kpa());
  previous_kpa_ = from_kpa;
  previous_ = from;
  for (int k = 1; k <= count; ++k) {
    motion_setpoint(from_kpa, to_kpa, k, count, current_kpa_);
    step(previous_kpa_, current_kpa_, previous_, current_);
    previous_kpa_.swap(current_kpa_);
    previous_.swap(current_);
  }
  end = previous_;
}

bool MotionSimulator::hold(const PressuresRef& kpa, const BackboneRef& from, int frames,
                           Eigen::Ref<Backbone> end) {
  previous_ = from;
  bool is_free = true;
  for (int k = 0; k < frames && is_free; ++k) {
    step(kpa, kpa, previous_, current_);
    is_free = checker_.is_motion_free(previous_, current_);
    previous_.swap(current_);
  }
  end = previous_;
  return is_free;
}

void MotionSimulator::append_motion(const PressuresRef& to_kpa, std::vector<PlanFrame>& frames) {
  const Pressures from_kpa = frames.back().setpoint_kpa;
  const int count = motion_frame_count(from_kpa, to_kpa, arm_.pressure_step_limit_kpa());
  for (int k = 1; k <= count; ++k) {
    PlanFrame next{Pressures(from_kpa.size()), Backbone(arm_.point_count(), 3)};
    motion_setpoint(from_kpa, to_kpa, k, count, next.setpoint_kpa);
    step(frames.back().setpoint_kpa, next.setpoint_kpa, frames.back().backbone, next.backbone);
    frames.push_back(std::move(next));
  }
}

void MotionSimulator::append_hold(int count, std::vector<PlanFrame>& frames) {
  for (int k = 0; k < count; ++k) {
    PlanFrame next{frames.back().setpoint_kpa, Backbone(arm_.point_count(), 3)};
    step(next.setpoint_kpa, next.setpoint_kpa, frames.back().backbone, next.backbone);
    frames.push_back(std::move(next));
  }
}

void MotionBatch::run(const Eigen::Ref<const Eigen::MatrixXf>& from_kpa,
                      const Eigen::Ref<const Eigen::MatrixXf>& from,
                      const Eigen::Ref<const Eigen::MatrixXf>& to_kpa) {
  const auto motions = static_cast<int>(from_kpa.cols());
  frames_.resize(static_cast<std::size_t>(motions));
  rollouts_.clear();
  for (int j = 0; j < motions; ++j) {
    const int frames = motion_frame_count(from_kpa.col(j), to_kpa.col(j),
                                          simulator_.arm().pressure_step_limit_kpa());
    Eigen::MatrixXf& kept = frames_[static_cast<std::size_t>(j)];
    kept.resize(from.rows(), frames + 1);
    kept.col(0) = from.col(j);
    rollouts_.add(j, from_kpa.col(j), frame(j, 0), to_kpa.col(j), frames);
  }
  while (rollouts_.size() > 0) {
    simulator_.count_queries(static_cast<std::uint64_t>(rollouts_.size()));
    rollouts_.step();
    for (int column = rollouts_.size() - 1; column >= 0; --column) {
      frames_[static_cast<std::size_t>(rollouts_.label(column))].col(rollouts_.frame(column)) =
          Eigen::Map<const Eigen::VectorXf>(rollouts_.now(column).data(), from.rows());
      if (rollouts_.has_ended(column)) {
        rollouts_.remove(column);
      }
    }
  }
}

Eigen::Map<const Backbone> MotionBatch::frame(int motion, int k) const {
  const Eigen::MatrixXf& kept = frames_[static_cast<std::size_t>(motion)];
  return {kept.col(k).data(), kept.rows() / 3, 3};
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
