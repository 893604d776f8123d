#pragma once

#include <Eigen/QR>

#include "limber/common/random_stream.hpp"
#include "limber/network/learnt_region.hpp"

namespace limber {

/// A region with `axes` orthonormal axes drawn by chance, ranges that are not symmetric, and
/// numbers of an arm whose gaps are about 4.7 cm long.
inline LearntRegion sample_region(int segments, int points, int axes) {
  RandomStream random(9, 0);
  const int joint = segments + 3 * (points - 1);
  axes = std::min(axes, joint);
  const auto drawn = [&](Eigen::Index size, double low, double high) {
    Eigen::VectorXf values(size);
    for (float& value : values) {
      value = static_cast<float>(random.uniform(low, high));
    }
    return values;
  };
  LearntRegion region;
  region.low_kpa = drawn(segments, -100.0, -80.0);
  region.high_kpa = drawn(segments, 60.0, 100.0);
  region.steepest_fall_kpa_per_s = drawn(segments, 80.0, 120.0);
  region.steepest_rise_kpa_per_s = drawn(segments, 80.0, 120.0);
  region.joint_offset = drawn(joint, -0.05, 0.05);
  region.joint_scale = drawn(joint, 10.0, 100.0);
  region.joint_scale.head(segments) = drawn(segments, 0.01, 0.03);
  const Eigen::MatrixXf any = drawn(Eigen::Index{joint} * axes, -1.0, 1.0).reshaped(joint, axes);
  region.axes = (Eigen::HouseholderQR<Eigen::MatrixXf>(any).householderQ() *
                 Eigen::MatrixXf::Identity(joint, axes))
                    .transpose();
  region.axis_low = drawn(axes, -4.0, -2.0);
  region.axis_high = drawn(axes, 2.0, 5.0);
  region.joint_change = drawn(joint, 0.005, 0.02);
  region.joint_change.head(segments) = drawn(segments, 3.0, 8.0);
  return region;
}

}  // namespace limber
