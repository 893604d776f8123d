#include "log_tracks.hpp"

namespace limber {

namespace {

void keep(std::vector<double>& values, const std::vector<std::size_t>& order) {
  if (values.empty()) {
    return;
  }
  std::vector<double> kept;
  kept.reserve(order.size());
  for (const std::size_t row : order) {
    kept.push_back(values[row]);
  }
  values = std::move(kept);
}

void keep(Eigen::MatrixXd& matrix, const std::vector<std::size_t>& order) {
  if (matrix.size() == 0) {
    return;
  }
  Eigen::MatrixXd kept(static_cast<Eigen::Index>(order.size()), matrix.cols());
  for (std::size_t i = 0; i < order.size(); ++i) {
    kept.row(static_cast<Eigen::Index>(i)) = matrix.row(static_cast<Eigen::Index>(order[i]));
  }
  matrix = std::move(kept);
}

}  // namespace

void keep_rows(PointTracks& tracks, const std::vector<std::size_t>& order) {
  keep(tracks.time_s, order);
  keep(tracks.x_m, order);
  keep(tracks.y_m, order);
  keep(tracks.theta_rad, order);
}

void keep_rows(CommandTrack& track, const std::vector<std::size_t>& order) {
  keep(track.time_s, order);
  keep(track.values, order);
  keep(track.setpoint, order);
  keep(track.motion, order);
}

}  // namespace limber
