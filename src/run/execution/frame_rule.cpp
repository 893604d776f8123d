#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/safety_gate.hpp"

namespace limber {

void require_frame_rule(const ArmDescription& arm, int frame, const Pressures& before_kpa,
                        const Pressures& setpoint_kpa) {
  const double step_kpa = arm.pressure_step_limit_kpa();
  if (setpoint_kpa.size() != arm.channel_count()) {
    throw InputError(fmt::format("controller: {} set points in {}; arm '{}' has {} {}",
                                 setpoint_kpa.size(), frame_name(frame), arm.name,
                                 arm.channel_count(), arm.is_spatial() ? "chambers" : "segments"));
  }
  for (Eigen::Index i = 0; i < arm.channel_count(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(int(i));
    const double value = setpoint_kpa[i];
    if (!limits.contains(value)) {
      throw InputError(fmt::format("controller: set point of {} in {} is {} {}; expected {}",
                                   channel_name(arm, i), frame_name(frame), value, arm.command.unit,
                                   to_string(limits)));
    }
    const double rounding_kpa = kSetpointRoundingShare * limits.largest_kpa();
    if (!(std::abs(value - double(before_kpa[i])) <= step_kpa + rounding_kpa)) {
      throw InputError(fmt::format(
          "controller: set point of {} in {} changes from {} to {} {unit}; a frame allows "
          "{} {unit}",
          channel_name(arm, i), frame_name(frame), before_kpa[i], value, step_kpa,
          fmt::arg("unit", arm.command.unit)));
    }
  }
}

Pressures within_frame_rule(const std::vector<PressureLimits>& limits, double step_limit_kpa,
                            const Pressures& before_kpa,
                            const Eigen::Ref<const Eigen::VectorXd>& wanted_kpa) {
  Pressures result = before_kpa;
  for (std::size_t segment = 0; segment < limits.size(); ++segment) {
    const auto i = Eigen::Index(segment);
    if (std::isfinite(wanted_kpa[i])) {
      const double before = before_kpa[i];
      const double near =
          std::clamp(wanted_kpa[i], before - step_limit_kpa, before + step_limit_kpa);
      result[i] = float(limits[segment].clamped(near));
    }
  }
  return result;
}

Pressures within_frame_rule(const ArmDescription& arm, const Pressures& before_kpa,
                            const Eigen::Ref<const Eigen::VectorXd>& wanted_kpa) {
  return within_frame_rule(limits_of(arm), arm.pressure_step_limit_kpa(), before_kpa, wanted_kpa);
}

}  // namespace limber
