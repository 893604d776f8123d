#include "limber/arm/valve_parameters.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/content_hash.hpp"

namespace limber {

namespace {

constexpr double kLongestTimeConstantS = 100.0;

bool within(double value, double low, double high) {
  return value >= low && value <= high;  // false for NaN
}

std::string fault_of(const ValveDirection& direction, const char* name) {
  if (!within(direction.time_constant_s, 0.0, kLongestTimeConstantS)) {
    return fmt::format("{}.time_constant_s = {}; expected 0 to {} s", name,
                       direction.time_constant_s, kLongestTimeConstantS);
  }
  if (!(direction.rate_limit_kpa_per_s > 0.0)) {
    return fmt::format("{}.rate_limit_kpa_per_s = {}; expected a rate > 0, or infinity for none",
                       name, direction.rate_limit_kpa_per_s);
  }
  return {};
}

std::string fault_of(const SegmentValves& valves) {
  for (const std::string& fault :
       {fault_of(valves.inflating, "inflating"), fault_of(valves.venting, "venting")}) {
    if (!fault.empty()) {
      return fault;
    }
  }
  if (!within(valves.dead_time_s, 0.0, kLongestDeadTimeS)) {
    return fmt::format("dead_time_s = {}; expected 0 to {} s", valves.dead_time_s,
                       kLongestDeadTimeS);
  }
  if (!(valves.dead_band_kpa >= 0.0) || !std::isfinite(valves.dead_band_kpa)) {
    return fmt::format("dead_band_kpa = {}; expected a finite number >= 0", valves.dead_band_kpa);
  }
  return {};
}

}  // namespace

std::string ValveParameters::hash() const {
  if (is_ideal()) {
    return {};
  }
  std::string text = has_sides ? "sides" : "no sides";
  for (const SegmentValves& s : segments) {
    text += fmt::format(" {} {} {} {} {} {}", s.inflating.time_constant_s,
                        s.inflating.rate_limit_kpa_per_s, s.venting.time_constant_s,
                        s.venting.rate_limit_kpa_per_s, s.dead_time_s, s.dead_band_kpa);
  }
  return content_hash(text);
}

std::string why_unusable(const ValveParameters& parameters, const ArmDescription& arm) {
  // A chamber has one side: what has none says the same of it.
  if (!arm.is_spatial() && !parameters.is_ideal() &&
      parameters.has_sides != arm.command.is_pressure_kpa()) {
    return fmt::format("has_sides = {}; arm '{}' is driven by '{}' in {}, which has {}",
                       parameters.has_sides, arm.name, arm.command.name, arm.command.unit,
                       arm.command.is_pressure_kpa() ? "two sides" : "no sides");
  }
  return why_unusable(parameters, arm.channel_count());
}

std::string why_unusable(const ValveParameters& parameters, int segment_count) {
  if (parameters.is_ideal()) {
    return {};
  }
  if (int(parameters.segments.size()) != segment_count) {
    return fmt::format("{} segments found; the arm has {}", parameters.segments.size(),
                       segment_count);
  }
  for (std::size_t i = 0; i < parameters.segments.size(); ++i) {
    const std::string fault = fault_of(parameters.segments[i]);
    if (!fault.empty()) {
      return fmt::format("{}: {}", segment_name(i), fault);
    }
  }
  return {};
}

}  // namespace limber
