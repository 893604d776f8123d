#include "episode_mistakes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/statistics.hpp"

namespace limber {

namespace {

constexpr double kExplained = 0.7;   // of the error is left, or less
constexpr double kSuspicious = 1.5;  // times the middle error; others are not looked at
constexpr double kMaxLate_s = 3.0;   // of commands behind the motion, or before it
constexpr double kLateStep_s = 0.5;  // a slow arm's lag would explain less

/// Root of the mean square of what the segments' turns are off by [rad]; none tracked: 0.
double turn_error(const SimpleModel& model, const ArmDescription& arm, const Episode& episode) {
  const Eigen::MatrixXd told = lagged_turns(arm, episode, model.lag_s);
  double squares = 0.0;
  int count = 0;
  for (int t = 0; t < episode.frame_count(); ++t) {
    if (!episode.was_tracked(t)) {
      continue;
    }
    Eigen::Index column = 2;
    for (int i = 0; i < arm.segment_count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Eigen::Index end = column + kPoseSize * arm.segments[at].gaps;
      const double seen = double(episode.backbone(t, end) - episode.backbone(t, column));
      const SimpleSegment& segment = model.segments[at];
      squares += std::pow(seen - segment.gain * told(t, i) - segment.offset_rad, 2);
      column = end;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

/// The best explanation so far.
struct Explanation {
  double error;
  std::string what;
  void offer(double other, const std::string& words) {
    if (other < error) {
      error = other;
      what = words;
    }
  }
};

void exchange_columns(const SimpleModel& model, const ArmDescription& arm, Episode episode,
                      Explanation& best) {
  for (int a = 0; a < arm.segment_count(); ++a) {
    for (int b = a + 1; b < arm.segment_count(); ++b) {
      episode.pressure_kpa.col(a).swap(episode.pressure_kpa.col(b));
      best.offer(
          turn_error(model, arm, episode),
          fmt::format("the columns of {} and {} were exchanged", segment_name(a), segment_name(b)));
      episode.pressure_kpa.col(a).swap(episode.pressure_kpa.col(b));
    }
  }
}

void turn_signs(const SimpleModel& model, const ArmDescription& arm, Episode episode,
                Explanation& best) {
  for (int i = 0; i < arm.segment_count(); ++i) {
    episode.pressure_kpa.col(i) *= -1.0F;
    best.offer(turn_error(model, arm, episode),
               fmt::format("{}'s column had the other sign", segment_name(i)));
    episode.pressure_kpa.col(i) *= -1.0F;
  }
}

void shift_clock(const SimpleModel& model, const ArmDescription& arm, const Episode& episode,
                 Explanation& best) {
  const int last = episode.frame_count() - 1;
  Episode shifted = episode;
  for (double late_s = kLateStep_s; late_s <= kMaxLate_s; late_s += kLateStep_s) {
    const int frames = arm.frames_in(late_s);
    for (const int by : {frames, -frames}) {
      for (int t = 0; t <= last; ++t) {
        shifted.pressure_kpa.row(t) = episode.pressure_kpa.row(std::clamp(t + by, 0, last));
      }
      best.offer(turn_error(model, arm, shifted),
                 fmt::format("its commands were logged about {:.1f} s too {}", late_s,
                             by > 0 ? "late" : "early"));
    }
  }
}

}  // namespace

std::vector<std::string> likely_mistakes(const SimpleModel& model, const ArmDescription& arm,
                                         const std::vector<Episode>& episodes,
                                         const std::vector<bool>& judged) {
  std::vector<std::string> found(episodes.size());
  std::vector<double> errors(episodes.size(), 0.0);
  std::vector<double> known;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (judged[i]) {
      errors[i] = turn_error(model, arm, episodes[i]);
      known.push_back(errors[i]);
    }
  }
  if (known.empty()) {
    return found;
  }
  const double suspicious = kSuspicious * median(std::move(known));
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (!judged[i] || !(errors[i] > suspicious)) {
      continue;
    }
    Explanation best{kExplained * errors[i], {}};
    exchange_columns(model, arm, episodes[i], best);
    turn_signs(model, arm, episodes[i], best);
    shift_clock(model, arm, episodes[i], best);
    if (!best.what.empty()) {
      found[i] = "moves as if " + best.what;
    }
  }
  return found;
}

}  // namespace limber
