#include "pressure_loss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <Eigen/LU>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kLagMemory = 0.98;  // per frame: what is older counts less
constexpr double kClearlyLess =
    0.5;                             // of what the lag so far misses, so that noise changes nothing
constexpr double kHiddenKpa2 = 4.0;  // less than that per segment may be noise, or the valve model
constexpr double kKeptOfSums = 0.85;  // per frame: a third of a second back it is a third
constexpr double kLeastShare = 0.06;  // less may be the valve model's own error
constexpr double kLeastOfRange =
    0.0125;                      // of the segment's limits: less may be the sensor's offset
constexpr double kClear = 3.0;   // times what a share leaves unexplained
constexpr int kShortFrames = 5;  // in a row

}  // namespace

int PressureLag::note(const Pressures& setpoint_kpa, const Pressures& measured_kpa) {
  if (valves_.is_ideal()) {
    return 0;
  }
  if (state_.size() == 0) {
    state_ = valves_.settled_state(setpoint_kpa);
    predicted_kpa_.assign(kMaxFrames + 1, setpoint_kpa);
  } else {
    valves_.step(setpoint_kpa, state_);
    predicted_kpa_.pop_back();
    predicted_kpa_.emplace_front(state_.head(setpoint_kpa.size()));
  }
  for (std::size_t lag = 0; lag < missed_.size(); ++lag) {
    missed_[lag] =
        kLagMemory * missed_[lag] + double((predicted_kpa_[lag] - measured_kpa).squaredNorm());
  }
  const auto best = std::min_element(missed_.begin(), missed_.end());
  const double now = missed_[frames_];
  if (*best < kClearlyLess * now && now - *best > kHiddenKpa2 * double(setpoint_kpa.size())) {
    frames_ = int(best - missed_.begin());
  }
  return frames_;
}

std::string to_text(const PressureLoss& loss) {
  return fmt::format("{} lost {:.0f} % of its pressure, noticed after {:.1f} s: a leak, or a valve",
                     segment_name(loss.segment), 100.0 * loss.share, loss.noticed_s);
}

PressureLossWatch::PressureLossWatch(const ArmDescription& arm, const ValveModel& valves)
    : frame_period_s_(arm.frame_period_s()) {
  for (std::size_t i = 0; i < valves.parameters().segments.size(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(int(i));
    Segment& segment = segments_.emplace_back();
    segment.least_kpa = std::max(kLeastOfRange * (limits.upper_kpa - limits.lower_kpa),
                                 kClear * valves.parameters().segments[i].dead_band_kpa);
  }
}

void PressureLossWatch::observe(const Pressures& expected_kpa, const Pressures& measured_kpa) {
  if (segments_.empty()) {
    return;
  }
  const Pressures before_kpa = frames_ == 0 ? expected_kpa : before_kpa_;
  before_kpa_ = expected_kpa;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    Segment& sums = segments_[i];
    const auto at = Eigen::Index(i);
    const Eigen::Vector2d expected(expected_kpa[at], expected_kpa[at] - before_kpa[at]);
    const double missed = double(expected_kpa[at]) - double(measured_kpa[at]);
    sums.frames = kKeptOfSums * sums.frames + 1.0;
    sums.expected2 = kKeptOfSums * sums.expected2 + expected * expected.transpose();
    sums.expected_missed = kKeptOfSums * sums.expected_missed + missed * expected;
    sums.missed2 = kKeptOfSums * sums.missed2 + missed * missed;
    const std::optional<double> share = share_missed(sums);
    sums.short_for = share ? sums.short_for + 1 : 0;
    if (sums.short_for < kShortFrames) {
      continue;
    }
    const auto segment = int(i);
    if (!std::exchange(sums.is_noticed, true)) {
      found_.push_back({segment, 0.0, frames_ * frame_period_s_});
    }
    std::ranges::find(found_, segment, &PressureLoss::segment)->share = *share;
  }
  ++frames_;  // the first one is the start
}

std::optional<double> PressureLossWatch::share_missed(const Segment& sums) {
  // A pressure that stands still tells nothing of what goes with its change: that is then 0.
  const Eigen::Matrix2d regular = sums.expected2 + 1e-6 * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d by = regular.inverse() * sums.expected_missed;
  const double unexplained_kpa =
      std::sqrt(std::max(0.0, sums.missed2 - by.dot(sums.expected_missed)) / sums.frames);
  const double short_kpa = by[0] * std::sqrt(sums.expected2(0, 0) / sums.frames);
  const bool is_short =
      by[0] > kLeastShare && short_kpa > sums.least_kpa + kClear * unexplained_kpa;
  return is_short ? std::optional(by[0]) : std::nullopt;
}

}  // namespace limber
