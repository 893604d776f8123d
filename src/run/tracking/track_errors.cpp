#include "limber/run/track_errors.hpp"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

class ErrorSum {
 public:
  void add(double distance_m) {
    squares_ += distance_m * distance_m;
    error_.max_m = std::max(error_.max_m, distance_m);
    ++error_.frames;
  }
  std::optional<TrackError> error() const {
    if (error_.frames == 0) {
      return std::nullopt;
    }
    TrackError result = error_;
    result.rms_m = std::sqrt(squares_ / error_.frames);
    return result;
  }

 private:
  double squares_ = 0.0;
  TrackError error_;
};

}  // namespace

TrackErrors track_errors(const TipPath& path, const Episode& episode, int start_frame) {
  ErrorSum first, later;
  for (int t = start_frame; t < episode.frame_count(); ++t) {
    const double since_s = episode.time_s[t] - episode.time_s[start_frame];
    if (!episode.was_tracked(t)) {
      continue;
    }
    const Eigen::Vector2d tip_m = tip_position_m(backbone_at(episode.backbone, t));
    const double distance_m = (tip_m - path.at(since_s)).norm();
    (since_s <= path.lap_s() ? first : later).add(distance_m);
  }
  return {first.error(), later.error()};
}

}  // namespace limber
