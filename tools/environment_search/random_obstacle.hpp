#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/environment.hpp"
#include "styled_environment.hpp"

namespace limber {

/// A plate of the arm at some moment, and how thick the arm is there.
struct PlacedPlate {
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;
  double radius_m = 0.0;
};

/// An obstacle of the style's kinds, centred on the plate give or take a few centimetres.
Obstacle draw_obstacle_at(EnvironmentStyle style, const PlacedPlate& plate, RandomStream& random);

/// One to the left (side 1) or right (side −1) of the plate, about `clearance_m` from the arm's
/// side.
Obstacle draw_obstacle_beside(EnvironmentStyle style, const PlacedPlate& plate, double clearance_m,
                              double side, RandomStream& random);

/// The middle line of a wall: through a point, along `angle_rad`; places on it are counted from the
/// point.
struct WallLine {
  Eigen::Vector2d point_m;
  double angle_rad = 0.0;
};

/// A line through the plate, across the arm give or take 0.4 rad.
WallLine draw_wall_line(const PlacedPlate& plate, RandomStream& random);

/// Widens [low, high] by the places where the thick arm is in a wall along the line, `width_m`
/// thick.
void widen_by_crossing(const WallLine& line, const ArmDescription& arm, const Backbone& backbone,
                       double width_m, double& low, double& high);

/// The wall from place `from_m` to `to_m`.
Obstacle wall_piece(const WallLine& line, double from_m, double to_m, double width_m);

}  // namespace limber
