#include "limber/data/valve_identification.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/valve_simulation.hpp"
#include "valve_fit.hpp"

namespace limber {

namespace {

constexpr double kChangedWithinS = 0.5;
constexpr double kChange = 1e-3;          // of the limit, from one frame to the next
constexpr int kMinChanges = 20;           // frames with one
constexpr double kCopy = 1e-4;            // of the largest pressure
constexpr double kSuspiciousMean = 0.02;  // of the limit

bool changes_at(const Episode& episode, int segment, int frame, double limit) {
  return frame > 0 && std::abs(episode.setpoint_kpa(frame, segment) -
                               episode.setpoint_kpa(frame - 1, segment)) > kChange * limit;
}

std::vector<double> max_setpoints(const Recording& recording) {
  std::vector<double> limits(std::size_t(recording.channel_count()), 0.0);
  for (const Episode& episode : recording.episodes) {
    for (int i = 0; i < recording.channel_count(); ++i) {
      limits[std::size_t(i)] = std::max<double>(limits[std::size_t(i)],
                                                episode.setpoint_kpa.col(i).cwiseAbs().maxCoeff());
    }
  }
  return limits;
}

int change_count(const Recording& recording, const std::vector<FrameRange>& ranges, int segment,
                 double limit) {
  int count = 0;
  for (const FrameRange& range : ranges) {
    const Episode& episode = recording.episodes[std::size_t(range.episode)];
    for (int t = range.first; t < range.first + range.count; ++t) {
      count += changes_at(episode, segment, t, limit) ? 1 : 0;
    }
  }
  return count;
}

/// Where all but the last of `parts` of an episode's frames lie; of one that rests for most of that
/// time, of its changes.
int frames_before_the_last(const Episode& episode, int parts) {
  const int frames = episode.frame_count();
  const int usual = frames - frames / parts;
  std::vector<int> changes(frames, 0);  // so many up to each frame
  for (int t = 1; t < frames; ++t) {
    const bool changed = episode.setpoint_kpa.row(t) != episode.setpoint_kpa.row(t - 1);
    changes[std::size_t(t)] = changes[std::size_t(t) - 1] + (changed ? 1 : 0);
  }
  if (usual == 0 || 2 * changes[std::size_t(usual) - 1] >= changes.back()) {
    return usual;
  }
  const int wanted = changes.back() - changes.back() / parts;
  return int(std::ranges::lower_bound(changes, wanted) - changes.begin()) + 1;
}

/// Fitted ranges as runs of one segment, of 600 frames each, evenly picked from what there is.
std::vector<ValveRun> runs_of(const std::vector<Episode>& episodes,
                              const std::vector<FrameRange>& ranges, int segment) {
  constexpr int kRunFrames = 600;
  constexpr int kMaxFrames = 20000;
  std::vector<ValveRun> runs;
  int frames = 0;
  for (const FrameRange& range : ranges) {
    for (int at = 0; at + 1 < range.count; at += kRunFrames) {
      const int count = std::min(kRunFrames, range.count - at);
      if (count > 1) {
        runs.push_back({&episodes[std::size_t(range.episode)], segment, range.first + at, count});
        frames += count;
      }
    }
  }
  std::vector<ValveRun> chosen;
  const std::size_t wanted = frames <= kMaxFrames
                                 ? runs.size()
                                 : runs.size() * std::size_t(kMaxFrames) / std::size_t(frames);
  for (std::size_t k = 0; k < wanted; ++k) {
    chosen.push_back(runs[k * runs.size() / wanted]);
  }
  return chosen;
}

/// Whether it moves, and its set points are merely what was measured.
bool is_without_setpoints(const Episode& episode) {
  return setpoints_are_measured(episode) &&
         (episode.pressure_kpa.rowwise() - episode.pressure_kpa.row(0)).any();
}

void add_errors(const Recording& recording, const std::vector<double>& limits,
                const ValveParameters& valves, const FrameRange& range, int early,
                std::vector<double>& sizes) {
  const Episode* episode = &recording.episodes[std::size_t(range.episode)];
  Episode moved;
  if (early > 0) {
    moved = *episode;
    for (int t = 0; t < moved.frame_count(); ++t) {
      moved.setpoint_kpa.row(t) =
          episode->setpoint_kpa.row(std::min(t + early, moved.frame_count() - 1));
    }
    episode = &moved;
  }
  const FrameMatrix simulated =
      simulate_valves(valves, recording.rate_hz, *episode, range.first, range.count);
  const int within = int(std::lround(kChangedWithinS * recording.rate_hz));
  for (int i = 0; i < recording.channel_count(); ++i) {
    int changed = -within - 1;
    for (int t = std::max(range.first - within, 0); t < range.first + range.count; ++t) {
      if (changes_at(*episode, i, t, limits[std::size_t(i)])) {
        changed = t;
      }
      if (t > range.first && t - changed <= within) {
        sizes.push_back(
            std::abs(double(simulated(t - range.first, i)) - episode->pressure_kpa(t, i)));
      }
    }
  }
}

/// @param early  frames that set points are moved up: what if they were logged late?
ValveErrors errors_of(const Recording& recording, const std::vector<double>& limits,
                      const ValveParameters& valves, const std::vector<FrameRange>& ranges,
                      int early = 0) {
  std::vector<double> sizes;
  for (const FrameRange& range : ranges) {
    add_errors(recording, limits, valves, range, early, sizes);
  }
  ValveErrors errors;
  errors.frames = std::int64_t(sizes.size());
  if (!sizes.empty()) {
    errors.mean_kpa = mean(sizes);
    errors.max_kpa = *std::max_element(sizes.begin(), sizes.end());
    errors.p95_kpa = quantile(std::move(sizes), 0.95);
  }
  return errors;
}

/// Fits and chooses.
class Identification {
 public:
  Identification(const Recording& recording, std::vector<double> limits)
      : recording_(recording),
        limits_(std::move(limits)),
        split_(split_for_valves(recording.episodes)) {}

  IdentifiedValves run() {
    IdentifiedValves result;
    result.parameters.has_sides = recording_.command.is_pressure_kpa();
    result.findings.source = recording_.source;
    result.findings.reason = why_impossible();
    if (!result.findings.reason.empty()) {
      return result;
    }
    result.parameters.segments = choose();
    result.findings.held_back = held_back_errors(result.parameters);
    result.findings.from_setpoints = held_back_errors({result.parameters.has_sides, {}});
    look_for_causes(result);
    if (result.findings.held_back.mean_kpa >
        result.findings.from_setpoints.mean_kpa + kChange * scale()) {
      result.parameters.segments.clear();
      result.findings.reason = fmt::format(
          "valves that fit one part are {:.3g} {unit} off on the rest, more than none at all "
          "({:.3g} {unit})",
          result.findings.held_back.mean_kpa, result.findings.from_setpoints.mean_kpa,
          fmt::arg("unit", recording_.command.unit));
    }
    return result;
  }

 private:
  bool has_sides() const { return recording_.command.is_pressure_kpa(); }
  ValveErrors held_back_errors(const ValveParameters& valves, int early = 0) const {
    return errors_of(recording_, limits_, valves, split_.held_back, early);
  }
  double scale() const { return *std::ranges::max_element(limits_); }

  std::string why_impossible() {
    const std::string& what = recording_.command.name;
    if (recording_.setpoints_only()) {
      return fmt::format(
          "the recording holds set points only: no {} was measured, and a network that learns from "
          "it learns the valves along with the arm",
          what);
    }
    if (setpoints_are_measured(recording_.episodes)) {
      return fmt::format(
          "the set points equal the measured numbers ({}): an import without a log of set points "
          "writes them so, or the recording holds no lag",
          what);
    }
    if (split_.fitted.empty() || split_.held_back.empty()) {
      return "the episodes are too short to fit valves to one part and check them on the rest";
    }
    const auto whole = mapped<FrameRange>(recording_.episodes.size(), [&](std::size_t e) {
      return FrameRange{int(e), 0, recording_.episodes[e].frame_count()};
    });
    int changes = 0;
    for (int i = 0; i < recording_.channel_count(); ++i) {
      const double limit = limits_[std::size_t(i)];
      // Not all of them in what is held back.
      const int count = std::min(change_count(recording_, whole, i, limit),
                                 4 * change_count(recording_, split_.fitted, i, limit));
      changes = std::max(changes, count);
      if (count >= kMinChanges) {
        told_.push_back(i);
      }
    }
    if (changes == 0) {
      return "the set points never change";
    }
    if (told_.empty()) {
      return fmt::format("set points change in {} frames at most; expected {} or more", changes,
                         kMinChanges);
    }
    return {};
  }

  SegmentValves fit(const std::vector<int>& segments) const {
    std::vector<ValveRun> runs;
    double limit = 0.0;
    for (const int i : segments) {
      std::ranges::copy(runs_of(recording_.episodes, split_.fitted, i), std::back_inserter(runs));
      limit = std::max(limit, limits_[std::size_t(i)]);
    }
    return fit_valves(runs, has_sides(), recording_.rate_hz, limit);
  }

  std::vector<SegmentValves> choose() const {
    constexpr double kAsGood = 1.05;
    constexpr double kNothing = 1e-4;  // of the limit: no error worth own parameters
    const auto segments = std::size_t(recording_.channel_count());
    const std::vector<SegmentValves> pooled(segments, fit(told_));
    if (told_.size() < 2) {
      return pooled;
    }
    const double pooled_mean = held_back_errors({has_sides(), pooled}).mean_kpa;
    if (pooled_mean <= kNothing * scale()) {
      return pooled;  // whatever others have
    }
    std::vector<SegmentValves> own = pooled;
    for (const int i : told_) {
      own[std::size_t(i)] = fit({i});
    }
    const double own_mean = held_back_errors({has_sides(), own}).mean_kpa;
    return pooled_mean <= kAsGood * own_mean + kNothing * scale() ? pooled : own;
  }

  void look_for_causes(IdentifiedValves& result) const {
    const std::string& unit = recording_.command.unit;
    const ValveErrors& held_back = result.findings.held_back;
    if (held_back.frames == 0) {
      result.findings.warnings.push_back(
          "no set point changes in the held-back data: the errors are unknown");
      return;
    }
    if (int(told_.size()) < recording_.channel_count()) {
      result.findings.warnings.push_back(fmt::format(
          "set points of {} of {} {} hardly change: these take the valves of the others",
          recording_.channel_count() - int(told_.size()), recording_.channel_count(),
          recording_.dimension == Dimension::space ? "chambers" : "segments"));
    }
    if (held_back.mean_kpa <= kSuspiciousMean * scale()) {
      return;
    }
    result.findings.warnings.push_back(fmt::format(
        "the valve model's error is {:.3g} {} on average where set points change, more than {:.0f} "
        "% of {:.4g} {}: look for {}a sensor that drifts, set points and measurements whose clocks "
        "are not aligned, or set points logged late",
        held_back.mean_kpa, unit, 100.0 * kSuspiciousMean, scale(), unit,
        recording_.command.is_pressure_kpa() ? "a supply pressure that is too low, a leak, " : ""));
    look_for_late_setpoints(result);
  }

  /// Valves cannot know a set point before it is given.
  void look_for_late_setpoints(IdentifiedValves& result) const {
    constexpr double kMuchBetter = 0.8;
    constexpr int kMaxFrames = 10;
    double best = result.findings.held_back.mean_kpa;
    int best_frames = 0;
    for (int early = 1; early <= kMaxFrames; ++early) {
      const double mean = held_back_errors(result.parameters, early).mean_kpa;
      if (mean < kMuchBetter * result.findings.held_back.mean_kpa && mean < best) {
        best = mean;
        best_frames = early;
      }
    }
    if (best_frames > 0) {
      result.findings.warnings.push_back(fmt::format(
          "{}s move before their set points: with set points {} frames ({:.3g} s) earlier the "
          "error would be {:.3g} {}; align the clocks, or log set points when they are given",
          followed_name(recording_.command), best_frames, best_frames / recording_.rate_hz, best,
          recording_.command.unit));
    }
  }

  const Recording& recording_;
  std::vector<double> limits_;
  ValveSplit split_;
  std::vector<int> told_;  // segments whose set points change enough
};

}  // namespace

bool setpoints_are_measured(const Episode& episode) {
  const double largest = double(episode.pressure_kpa.cwiseAbs().maxCoeff());
  return double((episode.setpoint_kpa - episode.pressure_kpa).cwiseAbs().maxCoeff()) <=
         kCopy * largest;
}

bool setpoints_are_measured(const std::vector<Episode>& episodes) {
  return std::ranges::all_of(
      episodes, [](const Episode& episode) { return setpoints_are_measured(episode); });
}

void leave_out_measured_setpoints(std::vector<Episode>& episodes) {
  std::erase_if(episodes, is_without_setpoints);
}

ValveSplit split_for_valves(const std::vector<Episode>& episodes) {
  constexpr int kHeldBack = 5;  // one in so many
  constexpr int kMinFrames = 20;
  ValveSplit split;
  const bool whole = episodes.size() >= kHeldBack;
  for (int e = 0; e < int(episodes.size()); ++e) {
    const int frames = episodes[std::size_t(e)].frame_count();
    const bool held = e % kHeldBack == kHeldBack - 1;
    const int fitted =
        whole ? (held ? 0 : frames) : frames_before_the_last(episodes[std::size_t(e)], kHeldBack);
    if (fitted >= kMinFrames) {
      split.fitted.push_back({e, 0, fitted});
    }
    if (frames - fitted >= kMinFrames) {
      split.held_back.push_back({e, fitted, frames - fitted});
    }
  }
  return split;
}

ValveErrors valve_errors(const ValveParameters& valves, const Recording& recording,
                         const std::vector<FrameRange>& ranges) {
  const std::vector<double> limits = max_setpoints(recording);
  return errors_of(recording, limits, valves, ranges);
}

IdentifiedValves identify_valves(const Recording& recording, std::vector<double> limits_kpa) {
  if (limits_kpa.empty()) {
    limits_kpa = max_setpoints(recording);
  }
  refuse_if(int(limits_kpa.size()) != recording.channel_count(),
            "valves: {} limits; the recording has {} segments", limits_kpa.size(),
            recording.channel_count());
  if (recording.setpoints_only() || setpoints_are_measured(recording.episodes) ||
      std::ranges::none_of(recording.episodes, is_without_setpoints)) {
    return Identification(recording, std::move(limits_kpa)).run();
  }
  Recording told = recording;
  leave_out_measured_setpoints(told.episodes);
  return Identification(told, std::move(limits_kpa)).run();
}

IdentifiedValves identify_valves(const std::vector<Episode>& episodes, const ArmDescription& arm,
                                 const std::string& source) {
  Recording recording = make_recording(arm, source, 0);
  recording.episodes = episodes;
  validate(recording, source);
  auto limits = mapped<double>(limits_of(arm),
                               [&](const PressureLimits& limit) { return limit.largest_kpa(); });
  return identify_valves(recording, std::move(limits));
}

}  // namespace limber
