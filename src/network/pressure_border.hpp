#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "limber/network/learnt_region.hpp"

namespace limber {

struct MiddleAndHalf {
  Eigen::VectorXd middle;
  Eigen::VectorXd half;  ///< > 0
};

inline MiddleAndHalf middle_and_half(const Eigen::VectorXf& low, const Eigen::VectorXf& high) {
  return {0.5 * (low.cast<double>() + high.cast<double>()),
          0.5 * (high.cast<double>() - low.cast<double>())};
}

/// Where raw pressures are as novel as on the border: kPressureSlack beyond what was recorded. A
/// pressure that never moved counts as having moved by a thousandth of the widest range.
inline MiddleAndHalf pressure_border(const LearntRegion& region) {
  constexpr double kNarrowest = 1e-3;
  MiddleAndHalf border = middle_and_half(region.low_kpa, region.high_kpa);
  const double widest = border.half.maxCoeff();
  const double min_half = widest > 0.0 ? kNarrowest * widest : kNarrowest;
  border.half = (1.0 + kPressureSlack) * border.half.cwiseMax(min_half);
  return border;
}

}  // namespace limber
