#include "random_obstacle.hpp"

#include <cmath>
#include <numbers>

namespace limber {

namespace {

constexpr double kJitterM = 0.04;
constexpr double kTiltRad = 0.4;

/// Files read better in millimetres and hundredths of a radian.
double tidy(double length_m) {
  return std::round(1e3 * length_m) / 1e3;
}
double tidy_angle(double angle_rad) {
  return std::round(1e2 * angle_rad) / 1e2;
}

Circle draw_circle(double x_m, double y_m, double size_m) {
  return {tidy(x_m), tidy(y_m), tidy(size_m)};
}

Rectangle draw_rectangle(double x_m, double y_m, double size_m, RandomStream& random) {
  const double stretch = random.uniform(1.0, 2.2);
  return {tidy(x_m), tidy(y_m), tidy(2.0 * size_m * stretch), tidy(2.0 * size_m / stretch),
          tidy_angle(random.uniform(0.0, std::numbers::pi))};
}

/// Corners around the centre, one in each of `corners` equal sectors: simple, and convex or not.
Polygon draw_polygon(double x_m, double y_m, double size_m, int corners, bool concave,
                     RandomStream& random) {
  Polygon polygon;
  const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / corners;
    const double radius = size_m * (concave && i % 2 == 0 ? 0.45 : 1.3);
    polygon.points_m.emplace_back(tidy(x_m + radius * std::cos(angle)),
                                  tidy(y_m + radius * std::sin(angle)));
  }
  return polygon;
}

Obstacle draw_shape(EnvironmentStyle style, double x_m, double y_m, double size_m,
                    RandomStream& random) {
  switch (style) {
    case EnvironmentStyle::pillars:
    case EnvironmentStyle::gap_in_a_wall:
      return draw_circle(x_m, y_m, size_m);
    case EnvironmentStyle::reach_behind:
      if (random.uniform() < 0.6) {
        return draw_rectangle(x_m, y_m, size_m, random);
      }
      return draw_polygon(x_m, y_m, size_m, 3, false, random);
    default:
      break;
  }
  switch (random.index(4)) {
    case 0:
      return draw_circle(x_m, y_m, size_m);
    case 1:
      return draw_rectangle(x_m, y_m, size_m, random);
    case 2:
      return draw_polygon(x_m, y_m, size_m, 5, false, random);
    default:
      return draw_polygon(x_m, y_m, size_m, 8, true, random);
  }
}

double draw_size(RandomStream& random) {
  return random.uniform(0.02, 0.06);
}

}  // namespace

Obstacle draw_obstacle_at(EnvironmentStyle style, const PlacedPlate& plate, RandomStream& random) {
  const double x = plate.x_m + random.uniform(-kJitterM, kJitterM);
  const double y = plate.y_m + random.uniform(-kJitterM, kJitterM);
  return draw_shape(style, x, y, draw_size(random), random);
}

Obstacle draw_obstacle_beside(EnvironmentStyle style, const PlacedPlate& plate, double clearance_m,
                              double side, RandomStream& random) {
  const double size = draw_size(random);
  const double distance = side * (plate.radius_m + clearance_m + size);
  return draw_shape(style, plate.x_m - distance * std::sin(plate.theta_rad),
                    plate.y_m + distance * std::cos(plate.theta_rad), size, random);
}

WallLine draw_wall_line(const PlacedPlate& plate, RandomStream& random) {
  const double across = plate.theta_rad + 0.5 * std::numbers::pi;
  return {{plate.x_m, plate.y_m}, tidy_angle(across + random.uniform(-kTiltRad, kTiltRad))};
}

void widen_by_crossing(const WallLine& line, const ArmDescription& arm, const Backbone& backbone,
                       double width_m, double& low, double& high) {
  constexpr int kSamples = 8;  // along a gap between two plates
  const Eigen::Vector2d along(std::cos(line.angle_rad), std::sin(line.angle_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  for (int gap = 0; gap + 1 < backbone.rows(); ++gap) {
    const Segment& segment = arm.segments[static_cast<std::size_t>(arm.segment_of_gap(gap))];
    const double radius = 0.5 * segment.width_m + arm.actuator_radius_m;
    const Eigen::Vector2d a = backbone.row(gap).head<2>().cast<double>().transpose();
    const Eigen::Vector2d b = backbone.row(gap + 1).head<2>().cast<double>().transpose();
    for (int k = 0; k <= kSamples; ++k) {
      const Eigen::Vector2d offset = a + (b - a) * k / kSamples - line.point_m;
      if (std::abs(offset.dot(across)) < 0.5 * width_m + radius) {
        low = std::min(low, offset.dot(along) - radius);
        high = std::max(high, offset.dot(along) + radius);
      }
    }
  }
}

Obstacle wall_piece(const WallLine& line, double from_m, double to_m, double width_m) {
  const double middle = 0.5 * (from_m + to_m);
  return Rectangle{tidy(line.point_m.x() + middle * std::cos(line.angle_rad)),
                   tidy(line.point_m.y() + middle * std::sin(line.angle_rad)), tidy(to_m - from_m),
                   tidy(width_m), line.angle_rad};
}

}  // namespace limber
