#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "limber/network/compensation_model.hpp"

namespace limber {

/// Bounds that many of an arm's shapes violate: gaps a little shorter than at rest, small turns.
inline GapBounds narrow_bounds(const ArmDescription& arm) {
  const int gaps = arm.point_count() - 1;
  GapBounds bounds{Eigen::VectorXf(gaps), Eigen::VectorXf(gaps),
                   Eigen::VectorXf::Constant(gaps, -0.25F), Eigen::VectorXf::Constant(gaps, 0.3F)};
  for (int g = 0; g < gaps; ++g) {
    const Segment& segment = arm.segments[static_cast<std::size_t>(arm.segment_of_gap(g))];
    const auto rest = static_cast<float>(segment.length_m / segment.gaps);
    bounds.min_length_m[g] = 0.93F * rest;
    bounds.max_length_m[g] = 0.985F * rest;
  }
  return bounds;
}

/// (20) as it is written, for columns of gap poses, or of base poses.
inline Eigen::MatrixXd within_bounds(const GapBounds& bounds, Eigen::MatrixXd columns,
                                     BackboneLayout layout) {
  const bool of_base = layout == BackboneLayout::base_poses;
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    Eigen::Vector3d given = Eigen::Vector3d::Zero();
    Eigen::Vector3d now = Eigen::Vector3d::Zero();
    if (of_base) {
      columns.col(j).head<3>().setZero();
    }
    for (Eigen::Index g = 0; g < bounds.min_length_m.size(); ++g) {
      auto number = columns.col(j).segment<3>(3 * (of_base ? g + 1 : g));
      Eigen::Vector3d step = number;
      if (of_base) {
        step -= given;
        given = number;
      }
      step.head<2>() *= std::clamp(step.head<2>().norm(), double(bounds.min_length_m[g]),
                                   double(bounds.max_length_m[g])) /
                        step.head<2>().norm();
      step[2] = std::clamp(step[2], double(bounds.min_turn_rad[g]), double(bounds.max_turn_rad[g]));
      now += step;
      number = of_base ? now : step;
    }
  }
  return columns;
}

}  // namespace limber
