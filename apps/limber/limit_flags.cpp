#include "limit_flags.hpp"

#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

/// A value of the flag.
struct Narrowing {
  std::string text;
  std::optional<std::size_t> segment;  // none: all of them
  PressureLimits limits;
};

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(fmt::format("--limit {}: {}", shortened(text), why));
}

PressureLimits limits_in(const std::string& text, const std::string& range) {
  const std::size_t comma = range.find(',');
  const std::optional<double> first = number_in(range.substr(0, comma));
  const std::optional<double> second =
      comma == std::string::npos ? first : number_in(range.substr(comma + 1));
  const PressureLimits limits = comma == std::string::npos
                                    ? PressureLimits(first.value_or(0.0))
                                    : PressureLimits(first.value_or(0.0), second.value_or(0.0));
  const bool finite = first && second && std::isfinite(*first) && std::isfinite(*second);
  if (!finite || !(limits.lower_kpa < limits.upper_kpa)) {
    refuse(text,
           "expected LOWER,UPPER, as in -8,10, or SEGMENT:LOWER,UPPER "
           "for one segment, with LOWER less than UPPER");
  }
  return limits;
}

Narrowing narrowing_in(const std::string& text, const ArmDescription& arm) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    return {text, std::nullopt, limits_in(text, text)};
  }
  std::size_t segment = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + colon, segment);
  if (error != std::errc() || end != text.data() + colon || segment >= arm.segments.size()) {
    refuse(text, fmt::format("'{}' is no segment; arm '{}' has segments 0 to {}",
                             text.substr(0, colon), arm.name, arm.segment_count() - 1));
  }
  return {text, segment, limits_in(text, text.substr(colon + 1))};
}

}  // namespace

void LimitFlags::add_to(CLI::App& app) {
  app.add_option("--limit", values_,
                 "LOWER,UPPER: plan with set points from LOWER to UPPER, within the arm's limits, "
                 "in the unit of its command; SEGMENT:LOWER,UPPER for one segment. Can be repeated")
      ->allow_extra_args(false);
  app.add_option(
      "--rate-limit", rate_limit_,
      "Change set points by at most so much per second, less than the arm allows, in the "
      "unit of its command. What runs the plan keeps it too");
}

std::vector<PressureLimits> LimitFlags::limits(const ArmDescription& arm) const {
  if (values_.empty()) {
    return {};
  }
  std::vector<PressureLimits> limits = limits_of(arm);
  const auto narrow = [&](const Narrowing& asked, std::size_t segment) {
    const PressureLimits& own = arm.segments[segment].pressure_limit_kpa;
    if (!own.contains(asked.limits)) {
      refuse(asked.text, fmt::format("beyond the limits of {}, {} {}",
                                     segment_name(static_cast<Eigen::Index>(segment)),
                                     to_string(own), arm.command.unit));
    }
    limits[segment] = asked.limits;
  };
  std::vector<Narrowing> of_one;
  for (const std::string& value : values_) {
    const Narrowing asked = narrowing_in(value, arm);
    if (asked.segment) {
      of_one.push_back(asked);
      continue;
    }
    for (std::size_t s = 0; s < limits.size(); ++s) {
      narrow(asked, s);
    }
  }
  for (const Narrowing& asked : of_one) {
    narrow(asked, *asked.segment);
  }
  return limits;
}

}  // namespace limber
