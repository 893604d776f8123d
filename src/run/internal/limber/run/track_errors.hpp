#pragma once

#include <optional>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/run/tip_path.hpp"

namespace limber {

/// How far the tip was from where the path had it at the same time.
struct TrackError {
  double rms_m = 0.0;
  double max_m = 0.0;
  int frames = 0;
};

struct TrackErrors {
  std::optional<TrackError> first_lap;   ///< none if no frame of it was tracked
  std::optional<TrackError> later_laps;  ///< all but the first; none of a single lap
};

/// Of a run whose frame `start_frame` is the path's time 0. Frames that were not tracked do not
/// count.
TrackErrors track_errors(const TipPath& path, const Episode& episode, int start_frame);

}  // namespace limber
