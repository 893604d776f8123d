#include "limber/world/pressure_box.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

#include "limber/arm/pressure_limits.hpp"

namespace limber {

namespace {

constexpr double kUsualScaleKpa = 100.0;  // of the arms that steps in kPa were chosen on

/// @param number  a member of the limits, or a function of them
template <class Number>
Pressures of_each(const std::vector<PressureLimits>& limits, Number number) {
  Pressures result(std::ssize(limits));
  std::ranges::transform(limits, result.begin(), [&](const PressureLimits& one) {
    return float(std::invoke(number, one));
  });
  return result;
}

}  // namespace

Pressures PressureBox::sample(RandomStream& random) const {
  Pressures kpa(low_kpa.size());
  for (Eigen::Index i = 0; i < kpa.size(); ++i) {
    kpa[i] = float(random.uniform(double(low_kpa[i]), double(high_kpa[i])));
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
  return {of_each(limits, &PressureLimits::lower_kpa), of_each(limits, &PressureLimits::upper_kpa)};
}

Pressures pressure_limits_kpa(const ArmDescription& arm) {
  return of_each(limits_of(arm), &PressureLimits::largest_kpa);
}

Pressures pressure_scales_kpa(const ArmDescription& arm) {
  return of_each(limits_of(arm), &PressureLimits::half_width_kpa);
}

double command_per_kpa(const ArmDescription& arm) {
  return arm.command.is_pressure_kpa() ? 1.0
                                       : double(pressure_scales_kpa(arm).mean()) / kUsualScaleKpa;
}

}  // namespace limber
