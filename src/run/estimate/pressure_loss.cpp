#include "pressure_loss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kKeptOfSums = 0.85;  // per frame: a third of a second back it is a third
constexpr double kMinShare = 0.04;    // less may be the valve model's own error
constexpr double kClear = 3.0;        // times what a share leaves unexplained, and the dead band
constexpr int kShortFrames = 5;       // in a row

}  // namespace

std::string to_text(const PressureLoss& loss) {
  return fmt::format("{} lost {:.0f} % of its pressure, noticed after {:.1f} s: a leak, or a valve",
                     segment_name(loss.segment), 100.0 * loss.share, loss.time_s);
}

PressureLossWatch::PressureLossWatch(const ValveModel& valves, double frame_period_s)
    : valves_(valves),
      frame_period_s_(frame_period_s),
      segments_(valves.parameters().segments.size()) {}

double PressureLossWatch::dead_band_kpa(std::size_t segment) const {
  return valves_.parameters().segments[segment].dead_band_kpa;
}

void PressureLossWatch::observe(const Pressures& expected_kpa, const Pressures& measured_kpa) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    Segment& sums = segments_[i];
    const auto at = static_cast<Eigen::Index>(i);
    const double expected = double(expected_kpa[at]);
    const double measured = double(measured_kpa[at]);
    sums.frames = kKeptOfSums * sums.frames + 1.0;
    sums.expected2 = kKeptOfSums * sums.expected2 + expected * expected;
    sums.expected_measured = kKeptOfSums * sums.expected_measured + expected * measured;
    sums.measured2 = kKeptOfSums * sums.measured2 + measured * measured;
    if (!(sums.expected2 > 0.0)) {
      continue;
    }
    const double kept = sums.expected_measured / sums.expected2;
    const double unexplained_kpa =
        std::sqrt(std::max(0.0, sums.measured2 - kept * sums.expected_measured) / sums.frames);
    const double short_kpa = (1.0 - kept) * std::sqrt(sums.expected2 / sums.frames);
    const bool is_short =
        1.0 - kept > kMinShare && short_kpa > kClear * (unexplained_kpa + dead_band_kpa(i));
    sums.short_for = is_short ? sums.short_for + 1 : 0;
    if (sums.short_for < kShortFrames) {
      continue;
    }
    if (!std::exchange(sums.is_noticed, true)) {
      found_.push_back({static_cast<int>(i), 0.0, frames_ * frame_period_s_});
    }
    std::ranges::find(found_, static_cast<int>(i), &PressureLoss::segment)->share = 1.0 - kept;
  }
  ++frames_;  // the first one is the start
}

}  // namespace limber
