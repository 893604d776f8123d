#include "limber/training/tip_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limber/arm/plate_distance.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

/// Largest mean over the values of one motion.
double worst_motion(const std::vector<double>& values, const std::vector<int>& motion) {
  double worst = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t first = 0; first < values.size();) {
    double sum = 0.0;
    int count = 0;
    std::size_t i = first;
    for (; i < values.size() && motion[i] == motion[first]; ++i) {
      sum += std::isnan(values[i]) ? 0.0 : values[i];
      count += std::isnan(values[i]) ? 0 : 1;
    }
    worst = count > 0 ? std::fmax(worst, sum / count) : worst;
    first = i;
  }
  return worst;
}

ErrorStatistics statistics(std::vector<double> values, const std::vector<int>& motion) {
  ErrorStatistics result;
  result.worst_motion = worst_motion(values, motion);
  // Frames in which the arm was not tracked, or nothing was predicted, are marked NaN.
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) {
    result.mean = result.std = result.p95 = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  result.mean = mean(values);
  result.std = standard_deviation(values);
  result.p95 = quantile(std::move(values), 0.95);
  return result;
}

/// Mean distance of the plates, the base left out: it stands still.
double plates_m(const FrameMatrix& predicted, const Episode& recorded, Eigen::Index t) {
  if (recorded.dimension == Dimension::plane) {
    const Eigen::VectorXd apart_m =
        plate_distances_m(backbone_at(predicted, t), backbone_at(recorded.backbone, t));
    return apart_m.tail(apart_m.size() - 1).mean();
  }
  double sum = 0.0;
  for (Eigen::Index plate = 1; plate < recorded.point_count(); ++plate) {
    const Eigen::Index at = kSpacePoseSize * plate;
    sum +=
        double((predicted.row(t).segment<3>(at) - recorded.backbone.row(t).segment<3>(at)).norm());
  }
  return sum / double(recorded.point_count() - 1);
}

}  // namespace

double heading_apart_rad(const FrameMatrix& predicted, const Episode& recorded, Eigen::Index t) {
  if (recorded.dimension == Dimension::plane) {
    const Eigen::Index heading = predicted.cols() - 1;
    return std::abs(double(predicted(t, heading) - recorded.backbone(t, heading)));
  }
  if (recorded.lifted) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const SpacePose a = space_pose_of(predicted.row(t).tail<kSpacePoseSize>().cast<double>());
  const SpacePose b = space_pose_of(recorded.backbone.row(t).tail<kSpacePoseSize>().cast<double>());
  return rotation_vector(between(a, b).rotation).norm();
}

TipErrorSeries tip_errors(const FrameMatrix& predicted, const Episode& episode) {
  TipErrorSeries errors;
  const FrameMatrix& recorded = episode.backbone;
  const Dimension dimension = episode.dimension;
  for (int t = 1; t < episode.frame_count(); ++t) {
    const Eigen::VectorXd difference =
        (tip_place(predicted, t, dimension) - tip_place(recorded, t, dimension))
            .transpose()
            .cast<double>();
    const bool tracked =
        episode.was_tracked(t) && predicted.row(t).tail(pose_size(dimension)).allFinite();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    errors.position_cm.push_back(tracked ? kCmPerM * difference.norm() : nan);
    errors.orientation_rad.push_back(tracked ? heading_apart_rad(predicted, episode, t) : nan);
    errors.plates_cm.push_back(tracked ? kCmPerM * plates_m(predicted, episode, t) : nan);
    errors.motion.push_back(episode.motion_index[t]);
    const auto step =
        (tip_place(recorded, t, dimension) - tip_place(recorded, t - 1, dimension)).cast<double>();
    errors.moving.push_back(episode.was_tracked(t - 1) && step.norm() >= kMovingTip_m);
  }
  return errors;
}

void append(TipErrorSeries& series, const TipErrorSeries& more) {
  const auto add = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(series.position_cm, more.position_cm);
  add(series.orientation_rad, more.orientation_rad);
  add(series.plates_cm, more.plates_cm);
  add(series.moving, more.moving);
  int number = series.motion.empty() ? 0 : series.motion.back() + 1;
  for (std::size_t i = 0; i < more.motion.size(); ++i) {
    number += i > 0 && more.motion[i] != more.motion[i - 1] ? 1 : 0;
    series.motion.push_back(number);
  }
}

TipErrorSeries moving_frames(const TipErrorSeries& series) {
  TipErrorSeries result;
  for (std::size_t i = 0; i < series.moving.size(); ++i) {
    if (series.moving[i]) {
      result.position_cm.push_back(series.position_cm[i]);
      result.orientation_rad.push_back(series.orientation_rad[i]);
      result.plates_cm.push_back(series.plates_cm[i]);
      result.motion.push_back(series.motion[i]);
      result.moving.push_back(true);
    }
  }
  return result;
}

TipErrors summarise(const TipErrorSeries& series) {
  return {statistics(series.position_cm, series.motion),
          statistics(series.orientation_rad, series.motion),
          statistics(series.plates_cm, series.motion)};
}

}  // namespace limber
