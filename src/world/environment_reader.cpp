#ifdef __linux__
#include <malloc.h>
#endif

#include <fmt/format.h>

#include "cross.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/start_shape.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/environment/1";
constexpr const char* kBefore = "backbone_before";
constexpr double kFarthestM = 1000.0;  // keeps squares of coordinates finite, and catches mm
constexpr double kMaxAngleRad = 1000.0;
constexpr std::size_t kMaxObstacles = 10000;
constexpr std::size_t kMaxPolygonPoints = 1000;
// Of all polygons; a polygon's corners are looked at with each other.
constexpr std::size_t kMaxCorners = 100000;

double coordinate(const YamlReader& node) {
  return node.number("a coordinate in metres", -kFarthestM, kFarthestM);
}

double size(const YamlReader& node, const char* what) {
  const double value = node.positive(what);
  return value <= kFarthestM ? value : node.number(what, 0.0, kFarthestM);
}

double angle(const YamlReader& node) {
  return node.number("an angle in radians", -kMaxAngleRad, kMaxAngleRad);
}

Circle read_circle(const YamlReader& node) {
  node.refuse_unknown_keys({"x_m", "y_m", "radius_m"});
  return {coordinate(node.at("x_m")), coordinate(node.at("y_m")),
          size(node.at("radius_m"), "a radius in metres")};
}

Rectangle read_rectangle(const YamlReader& node) {
  node.refuse_unknown_keys({"x_m", "y_m", "width_m", "height_m", "angle_rad"});
  Rectangle result;
  result.x_m = coordinate(node.at("x_m"));
  result.y_m = coordinate(node.at("y_m"));
  result.width_m = size(node.at("width_m"), "a length in metres");
  result.height_m = size(node.at("height_m"), "a length in metres");
  if (node.has("angle_rad")) {
    result.angle_rad = angle(node.at("angle_rad"));
  }
  return result;
}

/// p on the closed segment a–b, which it is known to be in line with.
bool within(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (p - a).dot(p - b) <= 0.0;
}

/// Closed segments a–b and c–d share a point.
bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  if (((c_side > 0.0) != (d_side > 0.0)) && ((a_side > 0.0) != (b_side > 0.0)) && c_side != 0.0 &&
      d_side != 0.0 && a_side != 0.0 && b_side != 0.0) {
    return true;
  }
  return (c_side == 0.0 && within(a, b, c)) || (d_side == 0.0 && within(a, b, d)) ||
         (a_side == 0.0 && within(c, d, a)) || (b_side == 0.0 && within(c, d, b));
}

/// Where an edge turns straight back on the one before it, the two overlap.
bool folds_back(const Eigen::Vector2d& before, const Eigen::Vector2d& corner,
                const Eigen::Vector2d& after) {
  return cross(corner - before, after - corner) == 0.0 &&
         (corner - before).dot(after - corner) < 0.0;
}

void require_simple(const YamlReader& node, const std::vector<Eigen::Vector2d>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (p[i] == p[(i + 1) % n]) {
      node.refuse(fmt::format("points {} and {} are the same, ({}, {}); expected distinct points",
                              i, (i + 1) % n, p[i].x(), p[i].y()));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (folds_back(p[i], p[(i + 1) % n], p[(i + 2) % n])) {
      node.refuse(
          fmt::format("the edge after {} runs back over the one before it; expected "
                      "a polygon with an inside",
                      point_name((i + 1) % n)));
    }
    for (std::size_t j = i + 2; j < n; ++j) {
      const bool neighbours = i == 0 && j == n - 1;
      node.refuse_if(!neighbours && segments_meet(p[i], p[i + 1], p[j], p[(j + 1) % n]),
                     "edges {}–{} and {}–{} cross or touch; expected a simple polygon", i, i + 1, j,
                     (j + 1) % n);
    }
  }
}

Polygon read_polygon(const YamlReader& node) {
  const std::vector<YamlReader> points = node.elements();
  node.refuse_if(points.size() < 3 || points.size() > kMaxPolygonPoints,
                 "{} points found; expected 3 to {} points [x, y]", points.size(),
                 kMaxPolygonPoints);
  Polygon result;
  for (const YamlReader& point : points) {
    const std::vector<YamlReader> xy = point.elements();
    point.refuse_if(xy.size() != 2, "{} numbers found; expected a point [x, y] in metres",
                    xy.size());
    result.points_m.emplace_back(coordinate(xy[0]), coordinate(xy[1]));
  }
  require_simple(node, result.points_m);
  return result;
}

Obstacle read_obstacle(const YamlReader& node) {
  node.refuse_unknown_keys({"circle", "rectangle", "polygon"});
  if (node.keys().size() != 1) {
    node.refuse(fmt::format("{} kinds found; expected exactly one of circle, rectangle, polygon",
                            node.keys().size()));
  }
  if (node.has("circle")) {
    return read_circle(node.at("circle"));
  }
  if (node.has("rectangle")) {
    return read_rectangle(node.at("rectangle"));
  }
  return read_polygon(node.at("polygon"));
}

Pressures read_pressures(const YamlReader& node) {
  const std::vector<double> pressures =
      node.numbers("a signed command, in the unit and with the sign of the arm file");
  return Eigen::Map<const Eigen::VectorXd>(pressures.data(), Eigen::Index(pressures.size()))
      .cast<float>();
}

/// `neutral` is the key for arms driven by anything but pressures, `in_kpa` that for the others.
const char* key_of(const YamlReader& node, const char* neutral, const char* in_kpa) {
  if (node.has(neutral) && node.has(in_kpa)) {
    node.at(neutral).refuse(fmt::format("given beside {}; expected one of both", in_kpa));
  }
  return node.has(neutral) ? neutral : in_kpa;
}

YamlReader commands_of(const YamlReader& start) {
  return start.at(key_of(start, "commands", "pressures_kpa"));
}

std::vector<YamlReader> setpoints_of(const YamlReader& start) {
  const char* key = key_of(start, "setpoints", "setpoints_kpa");
  return start.has(key) ? start.at(key).elements() : std::vector<YamlReader>();
}

Backbone read_backbone(const YamlReader& node) {
  const std::vector<YamlReader> rows = node.elements();
  Backbone backbone(Eigen::Index(rows.size()), kPoseSize);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<YamlReader> pose = rows[i].elements();
    if (pose.size() != kPoseSize) {
      rows[i].refuse(
          fmt::format("{} numbers found; expected a pose [x_m, y_m, theta_rad]", pose.size()));
    }
    // All three first: a row that is begun and left by an exception is an error to Eigen.
    const Eigen::RowVector3d row(coordinate(pose[0]), coordinate(pose[1]), angle(pose[2]));
    backbone.row(Eigen::Index(i)) = row.cast<float>();
  }
  return backbone;
}

ArmStart read_given_start(const YamlReader& node) {
  node.refuse_unknown_keys(
      {"pressures_kpa", "commands", "backbone", kBefore, "setpoints_kpa", "setpoints"});
  ArmStart start;
  start.pressures_kpa = read_pressures(commands_of(node));
  for (const YamlReader& row : setpoints_of(node)) {
    start.setpoints_kpa.push_back(read_pressures(row));
  }
  start.backbone = read_backbone(node.at("backbone"));
  if (node.has(kBefore)) {
    start.before = read_backbone(node.at(kBefore));
  }
  return start;
}

std::optional<ArmStart> read_start(const YamlReader& root) {
  const std::string expected = "expected 'rest' or {pressures_kpa: […], backbone: [[x, y, θ], …]}";
  if (!root.has("start")) {
    root.refuse("the key 'start' is missing; " + expected);
  }
  const YamlReader node = root.at("start");
  if (node.found() == "'rest'") {
    return std::nullopt;
  }
  if (node.found() != "a mapping") {
    node.refuse(node.found() + " found; " + expected);
  }
  return read_given_start(node);
}

PoseGoal read_goal(const YamlReader& node) {
  node.refuse_unknown_keys(
      {"x_m", "y_m", "theta_rad", "position_tolerance_m", "orientation_tolerance_rad"});
  PoseGoal goal;
  goal.x_m = coordinate(node.at("x_m"));
  goal.y_m = coordinate(node.at("y_m"));
  goal.position_tolerance_m = size(node.at("position_tolerance_m"), "a distance in metres");
  if (node.has("theta_rad")) {
    goal.theta_rad = angle(node.at("theta_rad"));
  }
  if (node.has("orientation_tolerance_rad")) {
    const YamlReader tolerance = node.at("orientation_tolerance_rad");
    goal.orientation_tolerance_rad = tolerance.positive("an angle in radians");
    tolerance.refuse_if(!goal.theta_rad, "set without theta_rad; expected both or neither");
  }
  return goal;
}

/// @param are_measured  of an arm in motion, whose valves may overshoot
void require_pressures_fit(const YamlReader& node, const Pressures& kpa, const ArmDescription& arm,
                           bool are_measured = false) {
  node.refuse_if(kpa.size() != arm.channel_count(),
                 "{} {}s found; expected {}, one per segment of arm '{}'", kpa.size(),
                 arm.command.name, arm.channel_count(), arm.name);
  const std::string more = are_measured ? fmt::format(" and {:g} % of their range for overshoot",
                                                      100.0 * kOvershootOfRange)
                                        : "";
  for (int i = 0; i < arm.channel_count(); ++i) {
    const PressureLimits& limits = arm.segments[i].pressure_limit_kpa;
    const PressureLimits allowed = are_measured ? measured_limits(limits) : limits;
    if (!allowed.contains(kpa[i])) {
      node.elements()[i].refuse(
          fmt::format("{} {unit} found; expected {} {unit}, the limits of that segment{}", kpa[i],
                      to_string(allowed), more, fmt::arg("unit", arm.command.unit)));
    }
  }
}

/// That the arm can have: one pose per plate, near enough to each other.
void require_shape(const YamlReader& node, const Backbone& backbone, const ArmDescription& arm) {
  node.refuse_if(backbone.rows() != arm.point_count(),
                 "{} poses found; expected {}, one per plate of arm '{}'", backbone.rows(),
                 arm.point_count(), arm.name);
  if (const std::optional<StartFault> fault = find_start_fault(backbone, arm)) {
    node.elements()[fault->row].refuse(fault->message);
  }
}

void require_start_fits(const YamlReader& root, const ArmStart& start, const ArmDescription& arm) {
  const YamlReader backbone = root.at("start").at("backbone");
  const std::vector<YamlReader> setpoints = setpoints_of(root.at("start"));
  // Of an arm in motion pressures are measured, set points are not.
  require_pressures_fit(commands_of(root.at("start")), start.pressures_kpa, arm,
                        !setpoints.empty());
  for (std::size_t k = 0; k < setpoints.size(); ++k) {
    require_pressures_fit(setpoints[k], start.setpoints_kpa[k], arm);
  }
  require_shape(backbone, start.backbone, arm);
  if (root.at("start").has(kBefore)) {
    require_shape(root.at("start").at(kBefore), start.before, arm);
  }
}

/// A parsed file leaves hundreds of small blocks per number. The C library joins them when it next
/// wants a large one, which for 100 000 corners takes 0.1 s: of the reading here, else of a plan.
void tidy_memory([[maybe_unused]] const Environment& environment) {
#ifdef __GLIBC__
  constexpr std::size_t kManyPoints = 1000;
  std::size_t points = environment.obstacles.size();
  for (const Obstacle& obstacle : environment.obstacles) {
    const auto* polygon = std::get_if<Polygon>(&obstacle);
    points += polygon != nullptr ? polygon->points_m.size() : 0;
  }
  if (points > kManyPoints) {
    malloc_trim(0);
  }
#endif
}

void read_obstacles(const YamlReader& node, std::vector<Obstacle>& obstacles) {
  const std::vector<YamlReader> found = node.elements();
  node.refuse_if(found.size() > kMaxObstacles, "{} obstacles found; expected at most {}",
                 found.size(), kMaxObstacles);
  std::size_t corners = 0;
  for (const YamlReader& one : found) {
    obstacles.push_back(read_obstacle(one));
    const auto* polygon = std::get_if<Polygon>(&obstacles.back());
    corners += polygon != nullptr ? polygon->points_m.size() : 0;
    one.refuse_if(corners > kMaxCorners,
                  "more than {} corners up to here; expected at most that many in all "
                  "polygons together",
                  kMaxCorners);
  }
}

}  // namespace

Environment read_environment(const YamlReader& root) {
  root.require_schema(kSchema);
  root.refuse_unknown_keys({"schema", "name", "obstacles", "start", "goal"});
  Environment environment;
  environment.name = root.at("name").text();
  read_obstacles(root.at("obstacles"), environment.obstacles);
  environment.start = read_start(root);
  environment.goal = read_goal(root.at("goal"));
  return environment;
}

Environment read_environment(const YamlReader& root, const ArmDescription& arm) {
  require_planar(arm, "an environment");
  Environment environment = read_environment(root);
  if (environment.start) {
    require_start_fits(root, *environment.start, arm);
  }
  return environment;
}

Environment load_environment(const fs::path& path) {
  Environment environment = read_environment(YamlReader::from_file(path));
  tidy_memory(environment);
  return environment;
}

Environment load_environment(const fs::path& path, const ArmDescription& arm) {
  Environment environment = read_environment(YamlReader::from_file(path), arm);
  tidy_memory(environment);
  return environment;
}

}  // namespace limber
