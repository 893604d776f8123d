#include "limber/world/obstacle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limber {

namespace {

using Eigen::Vector2d;

constexpr double kDepthToleranceM = 1e-4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Even–odd rule; points on the outline may fall either way.
bool is_inside(const std::vector<Vector2d>& vertices, const Vector2d& p) {
  bool inside = false;
  const Vector2d* previous = &vertices.back();
  for (const Vector2d& corner : vertices) {
    if ((corner.y() > p.y()) != (previous->y() > p.y()) &&
        p.x() < corner.x() + (previous->x() - corner.x()) * (p.y() - corner.y()) /
                                 (previous->y() - corner.y())) {
      inside = !inside;
    }
    previous = &corner;
  }
  return inside;
}

/// Open segments that cross at one point. Touching ends are caught by the distances.
bool cross_properly(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const Vector2d ab = b - a;
  const Vector2d cd = d - c;
  return cross(ab, c - a) * cross(ab, d - a) < 0.0 && cross(cd, a - c) * cross(cd, b - c) < 0.0;
}

double distance_to_outline(const std::vector<Vector2d>& vertices, const Vector2d& p) {
  double best = kInfinity;
  const Vector2d* previous = &vertices.back();
  for (const Vector2d& corner : vertices) {
    best = std::min(best, squared_distance(p, *previous, corner));
    previous = &corner;
  }
  return std::sqrt(best);
}

/// Lowest signed distance on a–b: it changes by no more than the way along the segment, which
/// bounds it on every half.
double lowest_signed_distance(const ObstacleShape& shape, const Vector2d& a, const Vector2d& b,
                              double best) {
  const Vector2d middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a).norm();
  const double value = signed_distance(shape, middle);
  best = std::min(best, value);
  if (value - half >= best - kDepthToleranceM) {
    return best;
  }
  best = lowest_signed_distance(shape, a, middle, best);
  return lowest_signed_distance(shape, middle, b, best);
}

}  // namespace

double squared_distance(const Box& a, const Box& b) {
  const Vector2d apart = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0);
  return apart.squaredNorm();
}

double squared_distance(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a;
  const double length = ab.squaredNorm();
  const double along = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (p - a - along * ab).squaredNorm();
}

ObstacleShape make_obstacle_shape(const Obstacle& obstacle, int index) {
  ObstacleShape shape;
  shape.index = index;
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    shape.centre = {circle->x_m, circle->y_m};
    shape.radius_m = circle->radius_m;
    shape.box = {shape.centre.array() - circle->radius_m, shape.centre.array() + circle->radius_m};
  } else {
    const auto* rectangle = std::get_if<Rectangle>(&obstacle);
    shape.vertices =
        rectangle ? rectangle_corners(*rectangle) : std::get<Polygon>(obstacle).points_m;
    shape.box = {shape.vertices.front(), shape.vertices.front()};
    for (const Vector2d& corner : shape.vertices) {
      shape.box.include(corner);
    }
  }
  shape.base_distance_m = std::max(0.0, signed_distance(shape, Vector2d::Zero()));
  return shape;
}

double signed_distance(const ObstacleShape& shape, const Vector2d& p) {
  if (shape.is_circle()) {
    return (p - shape.centre).norm() - shape.radius_m;
  }
  const double distance = distance_to_outline(shape.vertices, p);
  return is_inside(shape.vertices, p) ? -distance : distance;
}

double outside_distance(const ObstacleShape& shape, const Vector2d& a, const Vector2d& b) {
  if (shape.is_circle()) {
    return std::max(0.0, std::sqrt(squared_distance(shape.centre, a, b)) - shape.radius_m);
  }
  if (is_inside(shape.vertices, a) || is_inside(shape.vertices, b)) {
    return 0.0;
  }
  double best = kInfinity;
  const Vector2d* previous = &shape.vertices.back();
  for (const Vector2d& corner : shape.vertices) {
    if (cross_properly(a, b, *previous, corner)) {
      return 0.0;
    }
    best = std::min({best, squared_distance(a, *previous, corner),
                     squared_distance(b, *previous, corner), squared_distance(corner, a, b)});
    previous = &corner;
  }
  return std::sqrt(best);
}

double signed_distance(const ObstacleShape& shape, const Vector2d& a, const Vector2d& b) {
  if (shape.is_circle()) {
    return std::sqrt(squared_distance(shape.centre, a, b)) - shape.radius_m;
  }
  const double outside = outside_distance(shape, a, b);
  if (outside > 0.0) {
    return outside;
  }
  const double ends = std::min(signed_distance(shape, a), signed_distance(shape, b));
  return lowest_signed_distance(shape, a, b, ends) - kDepthToleranceM;
}

}  // namespace limber
