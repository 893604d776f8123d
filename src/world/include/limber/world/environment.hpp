#pragma once
// For everyone.

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

class YamlReader;

// Obstacles lie in the arm's plane, in the base frame B, in metres.

struct Circle {
  double x_m = 0.0;  ///< centre
  double y_m = 0.0;
  double radius_m = 0.0;  ///< > 0
};

struct Rectangle {
  double x_m = 0.0;  ///< centre
  double y_m = 0.0;
  double width_m = 0.0;    ///< along its own x, > 0
  double height_m = 0.0;   ///< along its own y, > 0
  double angle_rad = 0.0;  ///< of its own x about B's x, counter-clockwise
};

/// A simple polygon, convex or not, either way round; the inside is solid.
struct Polygon {
  std::vector<Eigen::Vector2d> points_m;  ///< at least 3
};

using Obstacle = std::variant<Circle, Rectangle, Polygon>;

/// "circle", "rectangle" or "polygon".
const char* obstacle_kind(const Obstacle& obstacle);

/// Corners of a rectangle, counter-clockwise.
std::vector<Eigen::Vector2d> rectangle_corners(const Rectangle& rectangle);

/// State of the arm that a motion starts from.
struct ArmStart {
  Pressures pressures_kpa;  ///< size n
  Backbone backbone;        ///< m×3
  /// Of an arm in motion: the set points in force, then those before them that dead time may still
  /// delay, the newest first; the last one counts for all before it. Empty: the arm is at rest, and
  /// its pressures were the set points for long.
  std::vector<Pressures> setpoints_kpa = {};
  Backbone before = {};  ///< m×3, of an arm in motion: a frame earlier; empty: it stood still

  /// In force.
  const Pressures& setpoint_kpa() const {
    return setpoints_kpa.empty() ? pressures_kpa : setpoints_kpa.front();
  }
};

/// What a plan is made for: obstacles, start and goal (docs/formats.md, schema
/// limber/environment/1).
struct Environment {
  std::string name;
  std::vector<Obstacle> obstacles;
  std::optional<ArmStart> start;  ///< none: at rest, straight, all pressures zero
  PoseGoal goal;                  ///< region of end-effector poses that counts as reached
};

/// "obstacle 2 (circle)", counted from 0 as in the file.
std::string obstacle_name(const Environment& environment, int obstacle);

/// Which of them is no obstacle, in words; empty where all are. Files are read so that all are, but
/// programs can make others: a NaN lies nowhere, and collides with nothing.
std::string why_not_solid(const std::vector<Obstacle>& obstacles);

/// Reads and validates an environment file. @throws InputError naming file, line, field, what was
/// found and what is allowed.
Environment load_environment(const std::filesystem::path& path);
Environment read_environment(const YamlReader& root);

/// The same, and refuses a start that does not fit the arm: sizes, pressure limits, and a backbone
/// that is not a shape of the arm (world/start_shape.hpp).
Environment load_environment(const std::filesystem::path& path, const ArmDescription& arm);
Environment read_environment(const YamlReader& root, const ArmDescription& arm);

/// The environment as YAML, readable by `load_environment`; floating-point values survive exactly.
std::string environment_to_yaml(const Environment& environment);

/// Hash of everything that planning depends on; name, comments and layout of the file excluded.
std::string environment_hash(const Environment& environment);

/// @throws InputError where the environment's start, if it has one, is of another number of
/// commands or plates than the arm.
void require_start_of(const ArmDescription& arm, const Environment& environment);

/// Start of `environment` for `arm`: as given, or the arm at rest. @throws as `require_start_of`
ArmStart start_state(const Environment& environment, const ArmDescription& arm);

}  // namespace limber
