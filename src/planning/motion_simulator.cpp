#include "limber/planning/motion_simulator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

void motion_setpoint(const PressuresRef& from_kpa, const PressuresRef& to_kpa, int k, int count,
                     Eigen::Ref<Pressures> setpoint_kpa) {
  if (k == count) {
    setpoint_kpa = to_kpa;
  } else {
    setpoint_kpa = from_kpa + (to_kpa - from_kpa) * (static_cast<float>(k) / float(count));
  }
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

void MotionBatch::run(MotionSimulator& simulator, const Eigen::Ref<const Eigen::MatrixXf>& from_kpa,
                      const Eigen::Ref<const Eigen::MatrixXf>& from,
                      const Eigen::Ref<const Eigen::MatrixXf>& to_kpa) {
  const int motions = static_cast<int>(from_kpa.cols());
  point_count_ = static_cast<int>(from.rows()) / 3;
  frame_counts_.resize(static_cast<std::size_t>(motions));
  for (int j = 0; j < motions; ++j) {
    frame_counts_[static_cast<std::size_t>(j)] = motion_frame_count(
        from_kpa.col(j), to_kpa.col(j), simulator.arm().pressure_step_limit_kpa());
  }
  std::vector<int> order(static_cast<std::size_t>(motions));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return frame_count(a) > frame_count(b); });
  columns_.resize(order.size());
  const int longest = motions == 0 ? 0 : frame_count(order.front());
  frames_.resize(static_cast<std::size_t>(longest) + 1);
  for (Eigen::MatrixXf& frame : frames_) {
    frame.resize(from.rows(), motions);
  }
  previous_kpa_.resize(from_kpa.rows(), motions);
  current_kpa_.resize(from_kpa.rows(), motions);
  for (int c = 0; c < motions; ++c) {
    const int j = order[static_cast<std::size_t>(c)];
    columns_[static_cast<std::size_t>(j)] = c;
    frames_[0].col(c) = from.col(j);
    previous_kpa_.col(c) = from_kpa.col(j);
  }
  int moving = motions;
  for (int k = 1; k <= longest; ++k) {
    while (frame_count(order[static_cast<std::size_t>(moving - 1)]) < k) {
      --moving;
    }
    for (int c = 0; c < moving; ++c) {
      const int j = order[static_cast<std::size_t>(c)];
      motion_setpoint(from_kpa.col(j), to_kpa.col(j), k, frame_count(j), current_kpa_.col(c));
    }
    const auto index = static_cast<std::size_t>(k);
    simulator.model().step_batch(previous_kpa_.leftCols(moving), current_kpa_.leftCols(moving),
                                 frames_[index - 1].leftCols(moving),
                                 frames_[index].leftCols(moving), workspace_);
    simulator.count_queries(static_cast<std::uint64_t>(moving));
    previous_kpa_.leftCols(moving) = current_kpa_.leftCols(moving);
  }
}

Eigen::Map<const Backbone> MotionBatch::frame(int motion, int k) const {
  const int column = columns_[static_cast<std::size_t>(motion)];
  return {frames_[static_cast<std::size_t>(k)].col(column).data(), point_count_, 3};
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
