#include "limber/world/pressure_box.hpp"

namespace limber {

Pressures PressureBox::sample(RandomStream& random) const {
  Pressures kpa(low_kpa.size());
  for (Eigen::Index i = 0; i < kpa.size(); ++i) {
    kpa[i] = static_cast<float>(random.uniform(double(low_kpa[i]), double(high_kpa[i])));
  }
  return kpa;
}

PressureBox PressureBox::within(const PressureBox& other) const {
  return {low_kpa.cwiseMax(other.low_kpa), high_kpa.cwiseMin(other.high_kpa)};
}

PressureBox pressure_box(const ArmDescription& arm) {
  const Pressures limit_kpa = pressure_limits_kpa(arm);
  return {-limit_kpa, limit_kpa};
}

Pressures pressure_limits_kpa(const ArmDescription& arm) {
  Pressures limits(arm.segment_count());
  for (int i = 0; i < limits.size(); ++i) {
    limits[i] = static_cast<float>(arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa);
  }
  return limits;
}

}  // namespace limber
