#include "row_spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limber {

namespace {

// Of poses: no motion capture resolves less.
constexpr float kMinInputSpread_m = 1e-4F;
constexpr float kMinInputSpread_rad = 2e-3F;

/// Of planar poses (x, y, θ, x, …), and of gaps in space.
bool is_planar_angle(Eigen::Index row) {
  return row % kPoseSize == 2;
}
bool is_space_gap_angle(Eigen::Index row) {
  return row % kSpaceGapSize > 2;
}

}  // namespace

bool is_quaternion(Eigen::Index row) {
  return row % kSpacePoseSize > 2;
}

IsAngle angles_of_states(const NetworkLayout& layout) {
  return layout.dimension() == Dimension::space ? is_space_gap_angle : is_planar_angle;
}

IsAngle angles_of_poses(const NetworkLayout& layout) {
  return layout.dimension() == Dimension::space ? is_quaternion : is_planar_angle;
}

float LeastSpread::of(Eigen::Index row) const {
  return is_angle == nullptr ? 0.0F
                             : share * (is_angle(row) ? kMinInputSpread_rad : kMinInputSpread_m);
}

Normalisation measure(const Eigen::MatrixXf& columns, Scaling scaling, LeastSpread least) {
  Normalisation result{Eigen::VectorXf(columns.rows()), Eigen::VectorXf(columns.rows())};
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const auto row = columns.row(i);
    const float low = row.minCoeff();
    const float range = row.maxCoeff() - low;
    float offset = low;
    float spread = range;
    if (scaling == Scaling::unit_spread) {
      const double mean = row.cast<double>().mean();
      offset = float(mean);
      spread = float(std::sqrt((row.cast<double>().array() - mean).square().mean()));
    }
    result.offset[i] = offset;
    result.scale[i] = range > kConstantSpread ? 1.0F / std::max(spread, least.of(i)) : 1.0F;
  }
  return result;
}

Normalisation joined_by_unit(const Eigen::MatrixXf& poses, IsAngle is_angle) {
  Normalisation result{Eigen::VectorXf(poses.rows()), Eigen::VectorXf(poses.rows())};
  const Eigen::VectorXf low = poses.rowwise().minCoeff();
  const Eigen::VectorXf high = poses.rowwise().maxCoeff();
  for (const bool angles : {false, true}) {
    float least = std::numeric_limits<float>::infinity();
    float most = -least;
    for (Eigen::Index row = 0; row < poses.rows(); ++row) {
      if (is_angle(row) == angles) {
        least = std::min(least, low[row]);
        most = std::max(most, high[row]);
      }
    }
    for (Eigen::Index row = 0; row < poses.rows(); ++row) {
      if (is_angle(row) == angles) {
        result.offset[row] = least;
        result.scale[row] = 1.0F / std::max(most - least, LeastSpread{is_angle}.of(row));
      }
    }
  }
  return result;
}

}  // namespace limber
