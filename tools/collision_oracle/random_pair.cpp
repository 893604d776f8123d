#include "random_pair.hpp"

#include <cmath>
#include <numbers>

#include "brute_force.hpp"

namespace limber {

namespace {

constexpr double kCoarseSpacingM = 0.003;  // to place an obstacle; the verdict samples finely
constexpr double kNearM = 0.003;

Pressures random_pressures(const ArmDescription& arm, RandomStream& random) {
  Pressures q(arm.segment_count());
  for (int i = 0; i < q.size(); ++i) {
    const PressureLimits& limits = arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
    q[i] = static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
  }
  return q;
}

/// An unloaded shape whose plates are off by millimetres and hundredths of a radian, as a
/// network's are: gaps are then no part of a longer arc.
Backbone disturbed_shape(const NoLoadModel& model, const Pressures& q,
                         const Eigen::Ref<const Eigen::MatrixXf>& disturbance) {
  Backbone b(model.point_count(), 3);
  model.backbone(q, b);
  return b + disturbance;
}

Obstacle shape_at(double x, double y, RandomStream& random) {
  const double size = std::exp(random.uniform(std::log(0.002), std::log(0.2)));
  switch (random.index(3)) {
    case 0:
      return Circle{x, y, size};
    case 1:
      return Rectangle{x, y, size, size * std::exp(random.uniform(-2.0, 2.0)),
                       random.uniform(-4.0, 4.0)};
    default: {
      Polygon star;
      const int corners = 3 + static_cast<int>(random.index(8));
      for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.0, 0.8)) / corners;
        const double radius = size * random.uniform(0.2, 1.0);
        star.points_m.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
      }
      return star;
    }
  }
}

void shift(Obstacle& obstacle, const Eigen::Vector2d& by) {
  if (auto* polygon = std::get_if<Polygon>(&obstacle)) {
    for (Eigen::Vector2d& p : polygon->points_m) {
      p += by;
    }
  } else if (auto* circle = std::get_if<Circle>(&obstacle)) {
    circle->x_m += by.x();
    circle->y_m += by.y();
  } else {
    std::get<Rectangle>(obstacle).x_m += by.x();
    std::get<Rectangle>(obstacle).y_m += by.y();
  }
}

/// Direction in which the distance at `p` grows.
Eigen::Vector2d outward(const Obstacle& obstacle, const Eigen::Vector2d& p) {
  constexpr double kStep = 1e-6;
  const auto slope = [&](const Eigen::Vector2d& along) {
    return brute_force_distance(obstacle, p + kStep * along) -
           brute_force_distance(obstacle, p - kStep * along);
  };
  const Eigen::Vector2d gradient(slope(Eigen::Vector2d::UnitX()), slope(Eigen::Vector2d::UnitY()));
  return gradient.norm() > 0.0 ? gradient.normalized() : Eigen::Vector2d::UnitX();
}

}  // namespace

RandomPair random_pair(const ArmDescription& arm, const NoLoadModel& model, RandomStream& random) {
  const Pressures q = random_pressures(arm, random);
  Pressures next = q;
  // Up to three frames' way at once: longer than any motion between frames of a plan.
  for (int i = 0; i < next.size(); ++i) {
    next[i] += static_cast<float>(random.uniform(-3.0, 3.0) * arm.pressure_step_limit_kpa());
  }
  Eigen::MatrixXf disturbance(model.point_count(), 3);
  for (Eigen::Index i = 0; i < disturbance.rows(); ++i) {
    disturbance.row(i) << static_cast<float>(random.normal() * 0.002),
        static_cast<float>(random.normal() * 0.002), static_cast<float>(random.normal() * 0.05);
  }
  const Backbone from = disturbed_shape(model, q, disturbance);
  const Backbone to =
      disturbed_shape(model, next, disturbance * static_cast<float>(random.uniform(0.8, 1.2)));
  Obstacle obstacle = shape_at(random.uniform(-0.2, 0.75), random.uniform(-0.6, 0.6), random);
  if (random.uniform() < 0.75) {
    const double wanted = random.uniform(-kNearM, kNearM);
    for (int k = 0; k < 3; ++k) {
      const SampledClearance found =
          brute_force_clearance(arm, from, to, obstacle, kCoarseSpacingM);
      shift(obstacle, (found.value_m - wanted) * outward(obstacle, found.point));
    }
  }
  return {from, to, obstacle};
}

}  // namespace limber
