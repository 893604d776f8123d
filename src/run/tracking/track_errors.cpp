#include "limber/run/track_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limber {

namespace {

constexpr double kTimeRounding_s = 1e-9;  // of differences between times of a long run

std::optional<TrackError> error_of(const std::vector<double>& distances_m) {
  if (distances_m.empty()) {
    return std::nullopt;
  }
  const double squares =
      std::inner_product(distances_m.begin(), distances_m.end(), distances_m.begin(), 0.0);
  const auto frames = int(distances_m.size());
  return TrackError{std::sqrt(squares / frames), std::ranges::max(distances_m), frames};
}

}  // namespace

TrackErrors track_errors(const TipPath& path, const Episode& episode, int start_frame) {
  std::vector<double> first_m;
  std::vector<double> later_m;
  for (int t = start_frame; t < episode.frame_count(); ++t) {
    const double since_s = episode.time_s[t] - episode.time_s[start_frame];
    if (!episode.was_tracked(t)) {
      continue;
    }
    const Eigen::Vector2d tip_m = tip_position_m(backbone_at(episode.backbone, t));
    const double distance_m = (tip_m - path.at(since_s)).norm();
    (since_s <= path.lap_s() + kTimeRounding_s ? first_m : later_m).push_back(distance_m);
  }
  return {error_of(first_m), error_of(later_m)};
}

}  // namespace limber
