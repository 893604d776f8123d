#include "log_clock.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/data/log_units.hpp"
#include "limber/data/median_rate.hpp"
#include "log_runs.hpp"

namespace limber {

namespace {

constexpr double kSlowerThanArm = 0.95;  // of the arm's rate
constexpr double kFastestLog_hz = 20000.0;
constexpr double kPlausibleLog_hz = 2000.0;  // of a guess: no logger that we know is faster
constexpr double kShortLog_s = 10.0;         // faster, and this short: 10 Hz in s, read as ms
constexpr double kSlowArm_hz = 1.0;          // an arm file may say as little
// Of a log's length: loggers pause, but one that is silent nine tenths of its time has no clock.
constexpr double kMaxSilence = 0.9;
constexpr double kSilenceAllowed_s = 60.0;  // however short the log
constexpr double kMinOfMotion = 0.1;        // of the motion log's length
constexpr double kLongestLog_s = 86400.0;   // clocks are compared over the whole of it, at 100 Hz

/// The unit in which the times would be those of a log of this arm; empty if there is none.
std::string unit_guess(const TimeColumn& time, double rate_hz, double lowest_hz) {
  std::string guess;
  double guessed_hz = kPlausibleLog_hz;
  for (const char* unit : {"min", "s", "ms", "us", "ns"}) {
    const double other_hz = rate_hz * time.seconds_per_unit / *unit_factor(unit, "s");
    if (unit != time.unit && other_hz >= lowest_hz && other_hz < guessed_hz) {
      guess = unit;
      guessed_hz = other_hz;
    }
  }
  return guess;
}

/// What to do about a rate that is no log's.
std::string advice(const TimeColumn& time, double rate_hz, double lowest_hz) {
  if (time.column.empty()) {
    return "Is 'rate_hz' right? It may be the log's or the arm file's frame_rate_hz that is not";
  }
  if (time.unit == "frame") {
    return "Is it the column of frame numbers, and is 'rate_hz' right?";
  }
  const std::string guess = unit_guess(time, rate_hz, lowest_hz);
  if (!guess.empty()) {
    return fmt::format(
        "Are its times in {0}? Then say so in the mapping: '{{column: {1}, unit: {0}}}'", guess,
        time.column);
  }
  return rate_hz < kSlowArm_hz || rate_hz > kFastestLog_hz
             ? std::string("Is it the column of times?")
             : fmt::format(
                   "Is it the column of times? If the log is that slow, set frame_rate_hz of the "
                   "arm file to at most {:.4g}",
                   rate_hz);
}

std::string found(const std::string& log, const TimeColumn& time, double rate_hz) {
  if (time.column.empty()) {
    return fmt::format("{}: 'time: {{rate_hz}}' gives {:.4g} rows per second", log, rate_hz);
  }
  return fmt::format("{}: column '{}', read in {}, gives {:.4g} rows per second", log, time.column,
                     time.unit, rate_hz);
}

/// The rate is that of most rows; single times may still be anything.
void check_silence(const std::string& log, const TimeColumn& time,
                   const std::vector<double>& time_s, double rate_hz) {
  const double span_s = time_s.back() - time_s.front();
  const double filled_s = double(time_s.size()) / rate_hz;
  if (span_s <= kSilenceAllowed_s + filled_s / (1.0 - kMaxSilence)) {
    return;
  }
  std::size_t longest = 1;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] - time_s[i - 1] > time_s[longest] - time_s[longest - 1]) {
      longest = i;
    }
  }
  throw InputError(fmt::format(
      "{}, so its {} rows are {:.4g} s long, but they reach over {:.4g} s: {:.12g} s is followed "
      "by {:.12g} s. Did the clock jump? Take out the rows that don't belong to this recording",
      found(log, time, rate_hz), time_s.size(), filled_s, span_s, time_s[longest - 1],
      time_s[longest]));
}

}  // namespace

void check_clock(const std::string& log, const TimeColumn& time, const std::vector<double>& time_s,
                 const ArmDescription& arm) {
  const double rate_hz = median_rate_hz(time_s);
  const double lowest_hz = kSlowerThanArm * arm.frame_rate_hz;
  if (!(rate_hz >= lowest_hz)) {
    const std::string message = fmt::format(
        "{}; expected {:.4g} to {}: arm '{}' works at {} frames per second, and what lies between "
        "rows is not invented. {}",
        found(log, time, rate_hz), lowest_hz, kFastestLog_hz, arm.name, arm.frame_rate_hz,
        advice(time, rate_hz, lowest_hz));
    if (rate_hz >= kSlowArm_hz && unit_guess(time, rate_hz, lowest_hz).empty()) {
      throw SlowLog(message);
    }
    throw InputError(message);
  }
  const double span_s = time_s.back() - time_s.front();
  const bool implausible = rate_hz > kPlausibleLog_hz && span_s < kShortLog_s &&
                           !unit_guess(time, rate_hz, lowest_hz).empty();
  if (rate_hz > kFastestLog_hz || implausible) {
    throw InputError(fmt::format(
        "{}; expected {:.4g} to {}, and more than {} only in logs of {} s or more; this is {:.4g} "
        "s long. {}",
        found(log, time, rate_hz), lowest_hz, kFastestLog_hz, kPlausibleLog_hz, kShortLog_s, span_s,
        advice(time, rate_hz, lowest_hz)));
  }
  check_silence(log, time, time_s, rate_hz);
}

void refuse_slow_logs(const std::vector<std::string>& logs, const std::vector<double>& rates_hz,
                      const ArmDescription& arm) {
  const double lowest_hz = kSlowerThanArm * arm.frame_rate_hz;
  const auto slow = std::count_if(rates_hz.begin(), rates_hz.end(),
                                  [&](double rate_hz) { return rate_hz < lowest_hz; });
  const auto slowest = std::min_element(rates_hz.begin(), rates_hz.end());
  // Rounded down: what the message says must be enough.
  const double enough_hz = std::floor(*slowest / kSlowerThanArm * 100.0) / 100.0;
  throw InputError(
      fmt::format("{} of {} logs are slower than arm '{}', which works at {} frames per "
                  "second; what lies between rows is not invented. The slowest is {} with "
                  "{:.4g} rows per second, the fastest has {:.4g}. How many frames per second "
                  "a model steps by is yours to choose (docs/importing.md): with frame_rate_hz "
                  "of the arm file at most {:.4g} all of them fit; or leave the slowest out",
                  slow, logs.size(), arm.name, arm.frame_rate_hz, logs[slowest - rates_hz.begin()],
                  *slowest, *std::max_element(rates_hz.begin(), rates_hz.end()), enough_hz));
}

void check_span(const std::string& log, const TimeColumn& time, const std::vector<double>& time_s,
                const std::string& motion_log, const std::vector<double>& motion_time_s) {
  const double span_s = time_s.back() - time_s.front();
  const double motion_s = motion_time_s.back() - motion_time_s.front();
  if (span_s >= kMinOfMotion * motion_s && span_s <= kLongestLog_s) {
    return;
  }
  throw InputError(fmt::format(
      "{}, {:.4g} s in all; {} is {:.4g} s long: expected {:.4g} s to {:.4g} s. Is the unit of the "
      "time right, and do the logs belong together?",
      found(log, time, median_rate_hz(time_s)), span_s, motion_log, motion_s,
      kMinOfMotion * motion_s, kLongestLog_s));
}

}  // namespace limber
