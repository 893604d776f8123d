#include "limber/arm/pressure_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

bool PressureLimits::contains(double kpa) const {
  return kpa >= std::min(lower_kpa, double(float(lower_kpa))) &&
         kpa <= std::max(upper_kpa, double(float(upper_kpa)));
}

PressureLimits PressureLimits::widened(double factor) const {
  // In this order symmetric limits become exactly ± factor · limit.
  const double largest = largest_kpa();
  const double size = factor * largest;
  return {(lower_kpa + largest) - size, size - (largest - upper_kpa)};
}

PressureLimits& PressureLimits::operator*=(double factor) {
  lower_kpa *= factor;
  upper_kpa *= factor;
  return *this;
}

PressureLimits PressureLimits::within(const PressureLimits& other) const {
  return {std::max(lower_kpa, other.lower_kpa), std::min(upper_kpa, other.upper_kpa)};
}

std::string to_string(const PressureLimits& limits) {
  return limits.is_symmetric()
             ? fmt::format("± {:.6g}", limits.upper_kpa)
             : fmt::format("{:.6g} to {:.6g}", limits.lower_kpa, limits.upper_kpa);
}

PressureLimits read_limits(const YamlReader& node, const std::string& meaning) {
  if (!node.is_sequence()) {
    return node.positive(meaning);
  }
  const std::vector<double> ends = node.numbers(meaning);
  if (ends.size() != 2 || !(ends[0] < ends[1])) {
    node.refuse(fmt::format("[{}] found; expected [lower, upper] with lower < upper, each {}",
                            fmt::join(ends, ", "), meaning));
  }
  if (ends[0] > 0.0 || ends[1] < 0.0) {
    node.refuse(fmt::format("[{}, {}] found; expected 0 within them: a vented segment is at 0",
                            ends[0], ends[1]));
  }
  return {ends[0], ends[1]};
}

std::string limits_to_yaml(const PressureLimits& limits) {
  return limits.is_symmetric() ? fmt::format("{}", limits.upper_kpa)
                               : fmt::format("[{}, {}]", limits.lower_kpa, limits.upper_kpa);
}

Json to_json(const PressureLimits& limits) {
  if (limits.is_symmetric()) {
    return limits.upper_kpa;
  }
  return {limits.lower_kpa, limits.upper_kpa};
}

double corner_kpa(const PressureLimits& limits, int state) {
  if (state == 0) {
    return 0.0;
  }
  const double sign = state == 1 ? 1.0 : -1.0;
  const double side = limits.side_kpa(sign);
  return side != 0.0 ? side : 0.5 * limits.side_kpa(-sign);
}

PressureLimits measured_limits(const PressureLimits& limits) {
  const double more_kpa = kOvershootOfRange * (limits.upper_kpa - limits.lower_kpa);
  return {limits.lower_kpa - more_kpa, limits.upper_kpa + more_kpa};
}

std::vector<PressureLimits> limits_of(const ArmDescription& arm) {
  return mapped<PressureLimits>(arm.channel_count(),
                                [&](int channel) { return arm.limits_of_channel(channel); });
}

ArmDescription with_limits(ArmDescription arm, const std::vector<PressureLimits>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    Segment& segment = arm.segments[i];
    segment.pressure_limit_kpa = segment.pressure_limit_kpa.within(limits[i]);
  }
  return arm;
}

}  // namespace limber
