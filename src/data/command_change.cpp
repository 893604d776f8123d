#include "command_change.hpp"

#include <algorithm>
#include <limits>

namespace limber {

bool command_changes(const ArmDescription& arm, const std::vector<Episode>& episodes, int channel) {
  constexpr double kMinChange = 0.02;  // of half the range
  constexpr double kMeans_s = 0.5;
  const int window = std::max(arm.frames_in(kMeans_s), 1);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const Episode& episode : episodes) {
    const auto commands = episode.pressure_kpa.col(channel).cast<double>();
    const int frames = episode.frame_count();
    const int mean_of = std::min(window, frames);
    double sum = commands.head(mean_of).sum();
    for (int end = mean_of; end <= frames; ++end) {
      lowest = std::min(lowest, sum / mean_of);
      highest = std::max(highest, sum / mean_of);
      if (end < frames) {
        sum += commands[end] - commands[end - mean_of];
      }
    }
  }
  return highest - lowest > kMinChange * arm.limits_of_channel(channel).half_width_kpa();
}

}  // namespace limber
