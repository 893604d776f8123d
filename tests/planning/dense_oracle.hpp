#pragma once

// Slow, independent geometry: points sampled along the arcs, distances by ternary search, inside by
// winding number. Shares no code with src/planning.

#include <cmath>
#include <limits>
#include <vector>

#include "limber/arm/backbone.hpp"
#include "limber/world/environment.hpp"

namespace limber::oracle {

using Point = Eigen::Matrix<long double, 2, 1>;

inline long double distance_to_edge(const Point& p, const Point& a, const Point& b) {
  long double low = 0.0L;
  long double high = 1.0L;
  for (int k = 0; k < 80; ++k) {
    const long double left = low + (high - low) / 3.0L;
    const long double right = high - (high - low) / 3.0L;
    if ((p - a - left * (b - a)).norm() < (p - a - right * (b - a)).norm()) {
      high = right;
    } else {
      low = left;
    }
  }
  return (p - a - low * (b - a)).norm();
}

inline bool winds_around(const std::vector<Point>& corners, const Point& p) {
  long double angle = 0.0L;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point u = corners[i] - p;
    const Point v = corners[(i + 1) % corners.size()] - p;
    angle += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  }
  return std::abs(angle) > 3.0L;
}

inline double signed_distance(const Obstacle& obstacle, const Point& p) {
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    return static_cast<double>((p - Point(circle->x_m, circle->y_m)).norm() - circle->radius_m);
  }
  std::vector<Point> corners;
  if (const auto* rectangle = std::get_if<Rectangle>(&obstacle)) {
    const long double c = std::cos(static_cast<long double>(rectangle->angle_rad));
    const long double s = std::sin(static_cast<long double>(rectangle->angle_rad));
    for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const long double x = 0.5L * u * rectangle->width_m;
      const long double y = 0.5L * v * rectangle->height_m;
      corners.emplace_back(rectangle->x_m + c * x - s * y, rectangle->y_m + s * x + c * y);
    }
  } else {
    for (const Eigen::Vector2d& corner : std::get<Polygon>(obstacle).points_m) {
      corners.push_back(corner.cast<long double>());
    }
  }
  long double best = std::numeric_limits<long double>::max();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    best = std::min(best, distance_to_edge(p, corners[i], corners[(i + 1) % corners.size()]));
  }
  return static_cast<double>(winds_around(corners, p) ? -best : best);
}

/// Points of the arc through two plates that turns by the difference of their headings, found by
/// walking along it in equal turns and scaling the walk onto the chord.
inline std::vector<Point> arc_points(const Backbone& b, int gap, int count) {
  const Point start(b(gap, 0), b(gap, 1));
  const Point chord = Point(b(gap + 1, 0), b(gap + 1, 1)) - start;
  const long double turn = static_cast<long double>(b(gap + 1, 2)) - b(gap, 2);
  std::vector<Point> walk{Point(0.0L, 0.0L)};
  constexpr int kSteps = 480;
  for (int k = 0; k < kSteps; ++k) {
    const long double heading = turn * (k + 0.5L) / kSteps;
    walk.push_back(walk.back() + Point(std::cos(heading), std::sin(heading)));
  }
  // Similarity that takes the walk's end to the chord's: multiplication by a complex number.
  const Point w = walk.back();
  const Point ratio =
      Point(chord.x() * w.x() + chord.y() * w.y(), chord.y() * w.x() - chord.x() * w.y()) /
      w.squaredNorm();
  std::vector<Point> points;
  for (int k = 0; k < count; ++k) {
    const Point& p = walk[static_cast<std::size_t>(k * kSteps / (count - 1))];
    points.push_back(start + Point(ratio.x() * p.x() - ratio.y() * p.y(),
                                   ratio.x() * p.y() + ratio.y() * p.x()));
  }
  return points;
}

/// Clearance by sampling; never below the true one, above it by at most half the samples' spacing.
inline double clearance(const ArmDescription& arm, const Backbone& b,
                        const std::vector<Obstacle>& obstacles, int samples_per_gap) {
  double best = std::numeric_limits<double>::max();
  for (int gap = 0; gap + 1 < b.rows(); ++gap) {
    const Segment& segment = arm.segments[static_cast<std::size_t>(arm.segment_of_gap(gap))];
    const double radius = 0.5 * segment.width_m + arm.actuator_radius_m;
    for (const Point& p : arc_points(b, gap, samples_per_gap)) {
      for (const Obstacle& obstacle : obstacles) {
        best = std::min(best, signed_distance(obstacle, p) - radius);
      }
    }
  }
  return best;
}

}  // namespace limber::oracle
