#include "limber/world/obstacle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cross.hpp"

namespace limber {

namespace {

using Eigen::Vector2d;

constexpr double kDepthToleranceM = 1e-4;
constexpr double kRounding = 1e-12;  // relative, and in m²: of two ways to work out one distance
constexpr double kNoDistance = std::numeric_limits<double>::infinity();

/// Whether a box may hold something nearer than `best`, both squared; also if they are equal but
/// for rounding, so that boxes change no distance by a bit.
bool may_be_nearer(double to_box, double best) {
  return to_box <= best * (1.0 + kRounding) + kRounding * kRounding;
}

/// Calls visit(a, b) for the edges a–b of those boxes that `is_of_interest`, until it returns
/// false.
/// @return whether it never did
template <class IsOfInterest, class Visit>
bool visit_edges(const ObstacleShape& shape, IsOfInterest&& is_of_interest, Visit&& visit) {
  const std::vector<Vector2d>& corners = shape.vertices;
  for (std::size_t k = 0; k < shape.edge_boxes.size(); ++k) {
    if (!is_of_interest(shape.edge_boxes[k])) {
      continue;
    }
    const std::size_t first = k * ObstacleShape::kEdgesPerBox;
    const std::size_t end = std::min(first + ObstacleShape::kEdgesPerBox, corners.size());
    const Vector2d* previous = first == 0 ? &corners.back() : &corners[first - 1];
    for (std::size_t i = first; i < end; ++i) {
      if (!visit(*previous, corners[i])) {
        return false;
      }
      previous = &corners[i];
    }
  }
  return true;
}

/// Even–odd rule; points on the outline may count as inside or outside.
bool is_inside(const ObstacleShape& shape, const Vector2d& p) {
  bool inside = false;
  visit_edges(
      shape, [&](const Box& box) { return box.low.y() <= p.y() && p.y() < box.high.y(); },
      [&](const Vector2d& a, const Vector2d& b) {
        if ((b.y() > p.y()) != (a.y() > p.y()) &&
            p.x() < b.x() + (a.x() - b.x()) * (p.y() - b.y()) / (a.y() - b.y())) {
          inside = !inside;
        }
        return true;
      });
  return inside;
}

/// Open segments that cross at one point. Touching ends are caught by the distances.
bool cross_properly(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const Vector2d ab = b - a;
  const Vector2d cd = d - c;
  return cross(ab, c - a) * cross(ab, d - a) < 0.0 && cross(cd, a - c) * cross(cd, b - c) < 0.0;
}

double distance_to_outline(const ObstacleShape& shape, const Vector2d& p) {
  double best = kNoDistance;
  visit_edges(
      shape,
      [&](const Box& box) {
        return may_be_nearer(squared_distance(box, {p, p}), best);
      },
      [&](const Vector2d& a, const Vector2d& b) {
        best = std::min(best, squared_distance(p, a, b));
        return true;
      });
  return std::sqrt(best);
}

std::vector<Box> edge_boxes_of(const std::vector<Vector2d>& corners) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d& before = i == 0 ? corners.back() : corners[i - 1];
    if (i % ObstacleShape::kEdgesPerBox == 0) {
      boxes.push_back({before, before});
    }
    boxes.back().include(before);
    boxes.back().include(corners[i]);
  }
  return boxes;
}

/// Lowest signed distance on a–b: it changes by no more than the distance along the segment, which
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
    shape.edge_boxes = edge_boxes_of(shape.vertices);
  }
  shape.base_distance_m = std::max(0.0, signed_distance(shape, Vector2d::Zero()));
  return shape;
}

double signed_distance(const ObstacleShape& shape, const Vector2d& p) {
  if (shape.is_circle()) {
    return (p - shape.centre).norm() - shape.radius_m;
  }
  const double distance = distance_to_outline(shape, p);
  return is_inside(shape, p) ? -distance : distance;
}

double outside_distance(const ObstacleShape& shape, const Vector2d& a, const Vector2d& b) {
  if (shape.is_circle()) {
    return std::max(0.0, std::sqrt(squared_distance(shape.centre, a, b)) - shape.radius_m);
  }
  if (is_inside(shape, a) || is_inside(shape, b)) {
    return 0.0;
  }
  double best = kNoDistance;
  const Box around = Box::around(a, b);
  const bool is_apart = visit_edges(
      shape, [&](const Box& box) { return may_be_nearer(squared_distance(box, around), best); },
      [&](const Vector2d& c, const Vector2d& d) {
        best = std::min({best, squared_distance(a, c, d), squared_distance(b, c, d),
                         squared_distance(d, a, b)});
        return !cross_properly(a, b, c, d);
      });
  return is_apart ? std::sqrt(best) : 0.0;
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
