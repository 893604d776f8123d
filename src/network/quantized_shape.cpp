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
  return static_cast<float>(arm_length_m) / kMax;
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
    shape[i] = rounded(gaps[i], i % 3 == 2 ? kUnitRad : unit);
  }
}

// By loops of its own, not base_poses_of: the filter blends many shapes, and allocates
// nothing.
void blend_shapes(const QuantizedShapeRef& from, const QuantizedShapeRef& to, float fraction,
                  double arm_length_m, Eigen::Ref<Backbone> backbone) {
  const float unit = unit_m(arm_length_m);
  const auto blended = [&](Eigen::Index i) {
    const auto before = static_cast<float>(from[i]);
    return before + fraction * (static_cast<float>(to[i]) - before);
  };
  for (Eigen::Index gap = 0; gap + 1 < backbone.rows(); ++gap) {
    const float along = unit * blended(3 * gap);
    const float across = unit * blended(3 * gap + 1);
    const float cosine = std::cos(backbone(gap, 2));
    const float sine = std::sin(backbone(gap, 2));
    backbone(gap + 1, 0) = backbone(gap, 0) + cosine * along - sine * across;
    backbone(gap + 1, 1) = backbone(gap, 1) + sine * along + cosine * across;
    backbone(gap + 1, 2) = backbone(gap, 2) + kUnitRad * blended(3 * gap + 2);
  }
}

}  // namespace limber
