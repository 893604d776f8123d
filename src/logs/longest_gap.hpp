#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "limber/logs/import_mapping.hpp"

namespace limber {

/// Of the steps of a clock that may be uneven: so many are no longer than the usual one.
inline constexpr double kUsualSteps = 0.9;

/// How long a point or a command of a log may be missing to be put between its neighbours in time:
/// as given, or else a quarter of a second, and two and a half usual steps of a slower log: a lost
/// row makes a step of two, and clocks jitter.
/// @param time_s  the log's, increasing, at least 2
double longest_gap_in_s(const LongestGap& gap, const std::vector<double>& time_s);

/// The same before any log is read: "0.4", or "2.5 usual steps or 0.25".
std::string in_words(const LongestGap& gap);

}  // namespace limber

/// As in_words() has it, for "up to {} s".
template <>
struct fmt::formatter<limber::LongestGap> : fmt::formatter<std::string> {
  template <class Context>
  auto format(const limber::LongestGap& gap, Context& context) const {
    return fmt::formatter<std::string>::format(limber::in_words(gap), context);
  }
};
