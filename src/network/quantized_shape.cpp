#include "limber/network/quantized_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limber/network/backbone_layout.hpp"

namespace limber {

namespace {

constexpr float kMax = 32767.0F;

std::int16_t rounded(float value, float unit) {
  return static_cast<std::int16_t>(std::clamp(std::round(value / unit), -kMax, kMax));
}

float unit_m(double arm_length_m) {
  return float(arm_length_m) / kMax;
}

constexpr float kUnitRad = std::numbers::pi_v<float> / kMax;

}  // namespace

void round_shape(const Eigen::Ref<const Backbone>& backbone, double arm_length_m,
                 Eigen::Ref<Eigen::Matrix<std::int16_t, Eigen::Dynamic, 1>> shape) {
  const Backbone poses = backbone;  // its numbers side by side
  const Eigen::VectorXf gaps =
      gap_poses_of(Eigen::Map<const Eigen::VectorXf>(poses.data(), poses.size()).cast<double>())
          .cast<float>();
  const float unit = unit_m(arm_length_m);
  for (Eigen::Index i = 0; i < gaps.size(); ++i) {
    shape[i] = rounded(gaps[i], i % kPoseSize == 2 ? kUnitRad : unit);
  }
}

// Pose by pose, not by base_poses_of: the filter blends many shapes, and allocates
// nothing.
void blend_shapes(const QuantizedShapeRef& from, const QuantizedShapeRef& to, float fraction,
                  double arm_length_m, Eigen::Ref<Backbone> backbone) {
  const float unit = unit_m(arm_length_m);
  const auto blended = [&](Eigen::Index i) {
    const auto before = float(from[i]);
    return before + fraction * (float(to[i]) - before);
  };
  for (Eigen::Index gap = 0; gap + 1 < backbone.rows(); ++gap) {
    const Eigen::Index at = kPoseSize * gap;
    const PoseOf<float> step{unit * blended(at), unit * blended(at + 1),
                             kUnitRad * blended(at + 2)};
    backbone.row(gap + 1) = numbers_of(compose(pose_of(backbone.row(gap)), step));
  }
}

}  // namespace limber
