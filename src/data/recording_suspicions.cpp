#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "recorded_backbones.hpp"
#include "suspicions.hpp"

#include "limber/arm/names.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/log_units.hpp"
#include "limber/data/median_rate.hpp"

namespace limber {

namespace {

constexpr double kConstant = 0.02;      // of the limit, over all episodes
constexpr int kShortEpisode = 33;       // frames: a training window and the frame before it
constexpr double kManyUntracked = 0.2;  // of an episode's frames
constexpr double kRateTolerance = 0.02;
constexpr double kMaxGapStretch = 1.2;  // between plates, over the length at rest
constexpr double kMinGapStretch = 0.5;  // an arc of 3.8 rad within one gap
constexpr double kSamePlace_m = 1e-6;

void look_at_arm(const Recording& recording, const ArmDescription& arm, Suspicions& suspicions) {
  const bool other_name = recording.arm_name != arm.name;
  const std::string why = why_another_arm(recording.arm(), arm, "the recording");
  if (!why.empty()) {
    suspicions.add(other_name ? "recorded with another arm: train and evaluate refuse it"
                              : "recorded with this arm before its file was changed",
                   0, 0,
                   fmt::format("'{}' ({}), not '{}' ({}): {}", recording.arm_name,
                               recording.arm_hash, arm.name, arm.hash(), why));
  }
}

/// @param arm  null: pressures beyond the largest set point count for a limit, too
void look_at_constant_commands(const Recording& recording, const ArmDescription* arm,
                               const std::vector<PressureLimits>& limits_kpa,
                               Suspicions& suspicions) {
  for (Eigen::Index i = 0; i < recording.channel_count(); ++i) {
    float lowest = std::numeric_limits<float>::max();
    float highest = std::numeric_limits<float>::lowest();
    for (const Episode& episode : recording.episodes) {
      lowest = std::min(lowest, episode.pressure_kpa.col(i).minCoeff());
      highest = std::max(highest, episode.pressure_kpa.col(i).maxCoeff());
    }
    const double largest = std::max(std::abs(double(lowest)), std::abs(double(highest)));
    const double limit =
        std::max(limits_kpa[std::size_t(i)].half_width_kpa(), arm != nullptr ? 0.0 : largest);
    if (limit == 0.0 || double(highest) - double(lowest) < kConstant * limit) {
      suspicions.add("a segment whose " + recording.command.name +
                         " never changes: nothing can be learnt about it",
                     0, 0,
                     fmt::format("{}: {:.4g} … {:.4g} {}", channel_name(recording.dimension, i),
                                 double(lowest), double(highest), recording.command.unit));
    }
  }
}

/// @param ratio  of a frame's period by the times over that by the file's rate
std::string time_advice(double ratio) {
  const std::string unit = unit_suspicion(ratio, "s");
  if (!unit.empty()) {
    return "; time_s holds seconds: " + unit;
  }
  const std::string read_in = unit_suspicion(1.0 / ratio, "s");
  return read_in.empty() ? "" : "; were seconds taken for another unit: " + read_in;
}

void look_at_episode(const Recording& recording, std::size_t index, Suspicions& suspicions) {
  const Episode& episode = recording.episodes[index];
  const int frames = episode.frame_count();
  const int untracked = episode.untracked_count();
  if (untracked == frames) {
    suspicions.add("an episode in which the arm was never tracked", index, 0,
                   fmt::format("{} frames", frames));
  } else if (double(untracked) > kManyUntracked * frames) {
    suspicions.add("an episode with many frames that were not tracked", index, 0,
                   fmt::format("{} of {}", untracked, frames));
  }
  if (frames > 2) {
    const std::vector<double> time_s(episode.time_s.begin(), episode.time_s.end());
    const double rate_hz = median_rate_hz(time_s);
    if (std::abs(rate_hz - recording.rate_hz) > kRateTolerance * recording.rate_hz) {
      suspicions.add(
          "frames at another rate than the file says", index, 0,
          fmt::format("a frame every {:.4g} s by their times, every {:.4g} s by the file{}",
                      1.0 / rate_hz, 1.0 / recording.rate_hz,
                      time_advice(recording.rate_hz / rate_hz)));
    }
  }
  if (const std::string offset = base_offset(episode); !offset.empty()) {
    suspicions.add(
        "a base that is not the origin of the arm's frame: "
        "import it with 'alignment: base' in the mapping",
        index, 0, offset);
  }
}

/// All in one line: what was tracked in pieces is short many times over.
void look_at_lengths(const std::vector<Episode>& episodes, Suspicions& suspicions) {
  const auto is_short = [](const Episode& episode) {
    return episode.frame_count() < kShortEpisode;
  };
  const auto first = std::ranges::find_if(episodes, is_short);
  if (first != episodes.end()) {
    const auto shortest = std::ranges::min_element(episodes, {}, &Episode::frame_count);
    suspicions.add("an episode shorter than a training window",
                   std::size_t(first - episodes.begin()), 0,
                   fmt::format("the shortest of {} has {} frames; {} make one", episodes.size(),
                               shortest->frame_count(), kShortEpisode),
                   int(std::ranges::count_if(episodes, is_short)));
  }
}

/// None where the arm was never tracked.
std::optional<double> median_distance_m(const Recording& recording, int plate) {
  std::vector<double> distances;
  for (const Episode& episode : recording.episodes) {
    for (const int t : tracked_frames(episode)) {
      distances.push_back((episode.position_m(t, plate + 1) - episode.position_m(t, plate)).norm());
    }
  }
  return distances.empty() ? std::nullopt : std::optional(median(std::move(distances)));
}

void look_at_distances(const Recording& recording, const ArmDescription* arm,
                       Suspicions& suspicions) {
  const std::vector<double> rest = arm != nullptr ? rest_positions_m(*arm) : std::vector<double>();
  for (int plate = 0; plate + 1 < recording.point_count; ++plate) {
    const std::optional<double> found_m = median_distance_m(recording, plate);
    if (!found_m) {
      return;
    }
    const double distance_m = *found_m;
    if (distance_m < kSamePlace_m) {
      suspicions.add("two plates at the same place", 0, 0, plates_of_gap(plate));
    } else if (arm != nullptr && (distance_m > kMaxGapStretch * (rest[plate + 1] - rest[plate]) ||
                                  distance_m < kMinGapStretch * (rest[plate + 1] - rest[plate]))) {
      suspicions.add("plates whose distance is not the arm file's (another unit, order or arm?)", 0,
                     0,
                     fmt::format("{}: {:.4g} m, {:.4g} m by the arm file", plates_of_gap(plate),
                                 distance_m, rest[plate + 1] - rest[plate]));
    }
  }
}

}  // namespace

void look_at_whole(const Recording& recording, const ArmDescription* arm,
                   const std::vector<PressureLimits>& limits_kpa, Suspicions& suspicions) {
  if (arm != nullptr) {
    look_at_arm(recording, *arm, suspicions);
  }
  look_at_constant_commands(recording, arm, limits_kpa, suspicions);
  for (std::size_t i = 0; i < recording.episodes.size(); ++i) {
    look_at_episode(recording, i, suspicions);
  }
  look_at_lengths(recording.episodes, suspicions);
  look_at_distances(recording, arm, suspicions);
}

}  // namespace limber
