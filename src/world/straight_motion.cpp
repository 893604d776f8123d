#include "limber/world/straight_motion.hpp"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kRoundingFrames = 1e-6;  // float32 set points of a motion of whole frames

}  // namespace

int motion_frame_count(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                       double step_limit_kpa) {
  const double largest = double((to_kpa - from_kpa).lpNorm<Eigen::Infinity>());
  return std::max(1, static_cast<int>(std::ceil(largest / step_limit_kpa - kRoundingFrames)));
}

double motion_cost_kpa(const PressuresRef& from_kpa, const PressuresRef& to_kpa) {
  return (to_kpa.cast<double>() - from_kpa.cast<double>()).lpNorm<1>();
}

double path_cost_kpa(const std::vector<Pressures>& waypoints_kpa) {
  double cost = 0.0;
  for (std::size_t i = 1; i < waypoints_kpa.size(); ++i) {
    cost += motion_cost_kpa(waypoints_kpa[i - 1], waypoints_kpa[i]);
  }
  return cost;
}

void motion_setpoint(const Eigen::Ref<const Pressures>& from_kpa,
                     const Eigen::Ref<const Pressures>& to_kpa, int k, int count,
                     Eigen::Ref<Pressures> setpoint_kpa) {
  if (k == count) {
    setpoint_kpa = to_kpa;
  } else {
    setpoint_kpa = from_kpa + (to_kpa - from_kpa) * (static_cast<float>(k) / float(count));
  }
}

std::vector<Pressures> straight_frames(const ArmDescription& arm, const Pressures& from,
                                       const Pressures& to) {
  const int count = motion_frame_count(from, to, arm.pressure_step_limit_kpa());
  std::vector<Pressures> result;
  for (int k = 1; k <= count; ++k) {
    result.emplace_back(from.size());
    motion_setpoint(from, to, k, count, result.back());
  }
  return result;
}

}  // namespace limber
