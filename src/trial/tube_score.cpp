#include "limber/trial/tube_score.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

namespace limber {

namespace {

using Eigen::Vector2d;

constexpr double kShare = 0.9;         // of the runs, below the shape
constexpr double kMinScaleM = 1e-4;    // as the certificate's deviation: nothing is known better
constexpr double kMinScaleRad = 1e-3;  // the same

Vector2d at(const Eigen::Ref<const Backbone>& backbone, Eigen::Index plate) {
  return {double(backbone(plate, 0)), double(backbone(plate, 1))};
}

/// Middle of the arc through two plates that turns by the difference of their headings.
Vector2d middle(const Eigen::Ref<const Backbone>& backbone, Eigen::Index gap) {
  const Vector2d from = at(backbone, gap);
  const Vector2d chord = at(backbone, gap + 1) - from;
  const double turn = double(backbone(gap + 1, 2)) - double(backbone(gap, 2));
  const double bulge = 0.5 * std::tan(0.25 * std::clamp(turn, -std::numbers::pi, std::numbers::pi));
  return from + 0.5 * chord - bulge * Vector2d(-chord.y(), chord.x());
}

Backbone shape_in(const Episode& run, int frame) {
  return Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>(
      run.backbone.row(frame).data(), run.backbone.cols() / 3, 3);
}

double turned(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
}

/// Calls visit(predicted, true shape) where the arm was tracked.
template <class Visit>
void visit_frames(const Plan& plan, const Episode& run, Visit&& visit) {
  const int last = plan.frame_count() - 1;
  for (int t = 0; t < run.frame_count(); ++t) {
    if (run.was_tracked(t)) {
      const int k = std::min(t, last);
      visit(plan.frames[static_cast<std::size_t>(k)].backbone, shape_in(run, t));
    }
  }
}

double quantile(std::vector<double> values) {
  return conformal_quantile(std::move(values), kShare);
}

}  // namespace

MotionErrors motion_errors(const Plan& plan, const Episode& run) {
  MotionErrors errors;
  errors.plate_m.assign(static_cast<std::size_t>(plan.frames.front().backbone.rows()), 0.0);
  visit_frames(plan, run, [&](const Backbone& predicted, const Backbone& seen) {
    const Eigen::Index tip = predicted.rows() - 1;
    for (Eigen::Index plate = 0; plate <= tip; ++plate) {
      double& largest = errors.plate_m[static_cast<std::size_t>(plate)];
      largest = std::max(largest, (at(predicted, plate) - at(seen, plate)).norm());
    }
    errors.end_m = (at(predicted, tip) - at(seen, tip)).norm();
    errors.end_heading_rad = turned(double(predicted(tip, 2)), double(seen(tip, 2)));
  });
  return errors;
}

double tube_score(const Plan& plan, const Episode& run, const Tube& shape) {
  const std::vector<double>& scale = shape.plate_scale_m;
  double score = 0.0;
  double end_score = 0.0;
  visit_frames(plan, run, [&](const Backbone& predicted, const Backbone& seen) {
    const Eigen::Index tip = predicted.rows() - 1;
    for (Eigen::Index plate = 0; plate <= tip; ++plate) {
      const auto i = static_cast<std::size_t>(plate);
      score = std::max(score, (at(predicted, plate) - at(seen, plate)).norm() / scale[i]);
      if (plate < tip) {
        score = std::max(score, (middle(predicted, plate) - middle(seen, plate)).norm() /
                                    std::max(scale[i], scale[i + 1]));
      }
    }
    end_score = std::max(
        (at(predicted, tip) - at(seen, tip)).norm() / shape.end_scale_m,
        turned(double(predicted(tip, 2)), double(seen(tip, 2))) / shape.end_heading_scale_rad);
  });
  return std::max(score, end_score);
}

Tube tube_shape(const std::vector<MotionErrors>& runs) {
  assert(!runs.empty());
  Tube tube;
  const auto below = [&](auto&& value) {
    std::vector<double> values;
    for (const MotionErrors& run : runs) {
      values.push_back(value(run));
    }
    return quantile(std::move(values));
  };
  for (std::size_t plate = 0; plate < runs.front().plate_m.size(); ++plate) {
    tube.plate_scale_m.push_back(
        std::max(kMinScaleM, below([&](const MotionErrors& run) { return run.plate_m[plate]; })));
  }
  tube.end_scale_m = std::max(kMinScaleM, below([](const MotionErrors& r) { return r.end_m; }));
  tube.end_heading_scale_rad =
      std::max(kMinScaleRad, below([](const MotionErrors& r) { return r.end_heading_rad; }));
  return tube;
}

}  // namespace limber
