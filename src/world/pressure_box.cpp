#include "limber/world/pressure_box.hpp"

#include "limber/arm/pressure_limits.hpp"

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
  return pressure_box(limits_of(arm));
}

PressureBox pressure_box(const std::vector<PressureLimits>& limits) {
  const auto n = static_cast<Eigen::Index>(limits.size());
  PressureBox box{Pressures(n), Pressures(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const PressureLimits& limit = limits[static_cast<std::size_t>(i)];
    box.low_kpa[i] = static_cast<float>(limit.lower_kpa);
    box.high_kpa[i] = static_cast<float>(limit.upper_kpa);
  }
  return box;
}

Pressures pressure_limits_kpa(const ArmDescription& arm) {
  Pressures limits(arm.channel_count());
  for (int i = 0; i < limits.size(); ++i) {
    limits[i] = static_cast<float>(
        arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.largest_kpa());
  }
  return limits;
}

Pressures pressure_scales_kpa(const ArmDescription& arm) {
  Pressures scales(arm.channel_count());
  for (int i = 0; i < scales.size(); ++i) {
    scales[i] = static_cast<float>(
        arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.half_width_kpa());
  }
  return scales;
}

}  // namespace limber
