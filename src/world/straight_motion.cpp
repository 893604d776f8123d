#include "limber/world/straight_motion.hpp"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kRoundingFrames = 1e-6;  // float32 set points of a motion of whole frames

}  // namespace

double motion_cost_kpa(const PressuresRef& from_kpa, const PressuresRef& to_kpa) {
  return (to_kpa.cast<double>() - from_kpa.cast<double>()).lpNorm<1>();
}

int motion_frame_count(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                       double step_limit_kpa) {
  const double largest = double((to_kpa - from_kpa).lpNorm<Eigen::Infinity>());
  return std::max(1, int(std::ceil(largest / step_limit_kpa - kRoundingFrames)));
}

void motion_setpoint(const PressuresRef& from_kpa, const PressuresRef& to_kpa, int k, int count,
                     Eigen::Ref<Pressures> setpoint_kpa) {
  if (k == count) {
    setpoint_kpa = to_kpa;
  } else {
    setpoint_kpa = from_kpa + (to_kpa - from_kpa) * (float(k) / float(count));
  }
}

std::vector<Pressures> straight_setpoints(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                                          double step_limit_kpa) {
  const int count = motion_frame_count(from_kpa, to_kpa, step_limit_kpa);
  std::vector<Pressures> setpoints_kpa(count, Pressures(to_kpa.size()));
  for (int k = 1; k <= count; ++k) {
    motion_setpoint(from_kpa, to_kpa, k, count, setpoints_kpa[std::size_t(k) - 1]);
  }
  return setpoints_kpa;
}

}  // namespace limber
