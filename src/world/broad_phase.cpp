#include "broad_phase.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace limber {

namespace {

// Above the rounding of coordinates of 10 m in float32, and far below what matters.
constexpr float kRoundingM = 1e-5F;

// Farthest point of an arc from its chord, over half the chord: tan(turn / 4) or a little more.
// Infinite beyond half a turn, where there is no arc.
float bulge_over_half_chord(float turn_rad) {
  const float x = 0.25F * turn_rad;
  return turn_rad > std::numbers::pi_v<float> ? std::numeric_limits<float>::infinity()
                                              : x * (1.0F + 0.4431F * x * x);
}

}  // namespace

BroadPhase::BroadPhase(const std::vector<ObstacleShape>& obstacles,
                       const std::vector<double>& radius_m) {
  for (const ObstacleShape& obstacle : obstacles) {
    const Eigen::Vector2f low = obstacle.box.low.cast<float>();
    const Eigen::Vector2f high = obstacle.box.high.cast<float>();
    obstacles_.push_back({low.x(), low.y(), high.x(), high.y()});
  }
  for (const double radius : radius_m) {
    radius_m_.push_back(float(radius) + kRoundingM);
  }
}

std::uint32_t BroadPhase::may_touch(const Eigen::Ref<const Backbone>& from,
                                    const Eigen::Ref<const Backbone>& to, int first) const {
  const int count = std::min(kGaps, int(radius_m_.size()) - first);
  std::array<FloatBox, kGaps> gaps;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  FloatBox all{kInfinity, kInfinity, -kInfinity, -kInfinity};
  std::uint32_t touching = 0;
  for (int i = 0; i < count; ++i) {
    // This plate and the next, before (a, c) and after (b, d).
    const float* a = from.data() + (first + i) * from.outerStride();
    const float* b = to.data() + (first + i) * to.outerStride();
    const float* c = a + from.outerStride();
    const float* d = b + to.outerStride();
    const float turn = std::max(std::abs(c[2] - a[2]), std::abs(d[2] - b[2]));
    // Of both sides of a triangle the third is never longer.
    const float chord = std::max(std::abs(c[0] - a[0]) + std::abs(c[1] - a[1]),
                                 std::abs(d[0] - b[0]) + std::abs(d[1] - b[1]));
    // Chords lie in the hull of the four points of their ends, arcs no farther than their bulge
    // beside their chords.
    const float reach = radius_m_[first + i] + 0.5F * chord * bulge_over_half_chord(turn);
    FloatBox& box = gaps[i];
    box.low_x = std::min(std::min(a[0], c[0]), std::min(b[0], d[0])) - reach;
    box.high_x = std::max(std::max(a[0], c[0]), std::max(b[0], d[0])) + reach;
    box.low_y = std::min(std::min(a[1], c[1]), std::min(b[1], d[1])) - reach;
    box.high_y = std::max(std::max(a[1], c[1]), std::max(b[1], d[1])) + reach;
    // What is not finite is lost in a minimum, but never in a sum.
    const float sum =
        a[0] + a[1] + a[2] + c[0] + c[1] + c[2] + b[0] + b[1] + b[2] + d[0] + d[1] + d[2] + reach;
    touching |= std::uint32_t{!std::isfinite(sum)} << i;
    all.low_x = std::min(all.low_x, box.low_x);
    all.high_x = std::max(all.high_x, box.high_x);
    all.low_y = std::min(all.low_y, box.low_y);
    all.high_y = std::max(all.high_y, box.high_y);
  }
  const auto apart = [](const FloatBox& a, const FloatBox& b) {
    return a.low_x > b.high_x || b.low_x > a.high_x || a.low_y > b.high_y || b.low_y > a.high_y;
  };
  for (const FloatBox& obstacle : obstacles_) {
    if (apart(obstacle, all)) {
      continue;
    }
    for (int i = 0; i < count; ++i) {
      touching |= std::uint32_t{!apart(obstacle, gaps[i])} << i;
    }
  }
  return touching;
}

}  // namespace limber
