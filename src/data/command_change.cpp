#include "command_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limber {

bool command_changes(const ArmDescription& arm, const std::vector<Episode>& episodes, int channel) {
  constexpr double kMinChange = 0.02;     // of half the range
  constexpr double kMinDeviation = 0.05;  // the same, of commands that swing within the means
  constexpr double kMeans_s = 0.5;
  const int window = std::max(arm.frames_in(kMeans_s), 1);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  double deviation = 0.0;
  for (const Episode& episode : episodes) {
    const auto commands = episode.pressure_kpa.col(channel).cast<double>();
    const int frames = episode.frame_count();
    const int mean_of = std::min(window, frames);
    deviation =
        std::max(deviation, std::sqrt((commands.array() - commands.mean()).square().mean()));
    double sum = commands.head(mean_of).sum();
    for (int end = mean_of; end <= frames; ++end) {
      lowest = std::min(lowest, sum / mean_of);
      highest = std::max(highest, sum / mean_of);
      if (end < frames) {
        sum += commands[end] - commands[end - mean_of];
      }
    }
  }
  const double half_kpa = arm.limits_of_channel(channel).half_width_kpa();
  return highest - lowest > kMinChange * half_kpa || deviation > kMinDeviation * half_kpa;
}

}  // namespace limber
