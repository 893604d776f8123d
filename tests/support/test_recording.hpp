#pragma once

#include <cmath>

#include "limber/data/recording.hpp"

namespace limber {

/// A small valid recording with distinct numbers everywhere: `episodes` runs of `frames` frames.
inline Recording test_recording(int episodes = 2, int frames = 5, int segments = 2,
                                int points = 4) {
  Recording recording;
  recording.arm_name = "test arm";
  recording.arm_hash = "0123456789abcdef";
  recording.segment_count = segments;
  recording.point_count = points;
  recording.rate_hz = 20.0;
  recording.seed = 18446744073709551615ULL;
  recording.source = "test";
  recording.settings = "schedule random";
  for (int e = 0; e < episodes; ++e) {
    Episode episode;
    episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) / recording.rate_hz);
    episode.pressure_kpa = FrameMatrix::NullaryExpr(frames, segments, [&](auto t, auto i) {
      return static_cast<float>(std::sin(1.0 + e + 0.3 * double(t) + double(i)) * 90.0);
    });
    episode.setpoint_kpa = episode.pressure_kpa.array() + 0.5F;
    episode.backbone = FrameMatrix::NullaryExpr(frames, 3 * points, [&](auto t, auto i) {
      return static_cast<float>(std::cos(0.1 * double(t) + 0.7 * double(i) + e));
    });
    for (int t = 0; t < frames; ++t) {
      episode.motion_index.push_back(t / 2);
      episode.tracked.push_back(t == 1 ? 0 : 1);
    }
    recording.episodes.push_back(episode);
  }
  return recording;
}

}  // namespace limber
