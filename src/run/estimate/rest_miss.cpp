#include "limber/run/rest_miss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limber {

namespace {

constexpr double kLearntShare = 0.5;
constexpr double kMaxBiasM = 0.1;

}  // namespace

Eigen::Vector3d difference(const Pose& pose, const Pose& other) {
  return {pose.x_m - other.x_m, pose.y_m - other.y_m,
          std::remainder(pose.theta_rad - other.theta_rad, 2.0 * std::numbers::pi)};
}

void RestMiss::note_creep(const MotionModel& model, const Pressures& held_kpa, int frames,
                          const Backbone& rest) {
  creep_.clear();
  MotionState state = model.settled_state(held_kpa, rest);
  MotionModel::Workspace workspace;
  for (int k = 0; k < frames; ++k) {
    model.step(held_kpa, state, workspace);
    creep_.push_back(difference(tip_pose(state.backbone), tip_pose(rest)));
  }
}

void RestMiss::learn(const Pose& expected, const Pose& measured) {
  bias_ += kLearntShare * (difference(measured, expected) + creep() - bias_);
  bias_ *= std::min(1.0, kMaxBiasM / std::max(bias_.head<2>().norm(), kMaxBiasM));
}

Eigen::Vector3d RestMiss::creep(std::size_t frame) const {
  return creep_.empty() || frame == 0 ? Eigen::Vector3d(0.0, 0.0, 0.0)
                                      : creep_[std::min(frame, creep_.size()) - 1];
}

}  // namespace limber
