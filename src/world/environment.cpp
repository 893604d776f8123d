#include "limber/world/environment.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/content_hash.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

std::string to_yaml(const Circle& c) {
  return fmt::format("circle: {{x_m: {}, y_m: {}, radius_m: {}}}", c.x_m, c.y_m, c.radius_m);
}

std::string to_yaml(const Rectangle& r) {
  return fmt::format("rectangle: {{x_m: {}, y_m: {}, width_m: {}, height_m: {}, angle_rad: {}}}",
                     r.x_m, r.y_m, r.width_m, r.height_m, r.angle_rad);
}

std::string to_yaml(const Polygon& polygon) {
  const auto points = mapped<std::string>(polygon.points_m, [&](const Eigen::Vector2d& p) {
    return fmt::format("[{}, {}]", p.x(), p.y());
  });
  return fmt::format("polygon: [{}]", fmt::join(points, ", "));
}

std::string to_yaml(const Backbone& backbone) {
  const auto rows = mapped<std::string>(backbone.rows(), [&](Eigen::Index i) {
    return fmt::format("[{}, {}, {}]", backbone(i, 0), backbone(i, 1), backbone(i, 2));
  });
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

std::string to_yaml(const ArmStart& start) {
  const auto numbers = [](const Pressures& kpa) {
    return fmt::format("[{}]", fmt::join(std::vector<float>(kpa.begin(), kpa.end()), ", "));
  };
  std::string text = fmt::format("\n  pressures_kpa: {}\n  backbone: {}",
                                 numbers(start.pressures_kpa), to_yaml(start.backbone));
  if (start.before.rows() > 0) {
    text += "\n  backbone_before: " + to_yaml(start.before);
  }
  if (!start.setpoints_kpa.empty()) {
    const auto setpoints = mapped<std::string>(start.setpoints_kpa,
                                               [&](const Pressures& kpa) { return numbers(kpa); });
    text += fmt::format("\n  setpoints_kpa: [{}]", fmt::join(setpoints, ", "));
  }
  return text;
}

std::string to_yaml(const PoseGoal& goal) {
  std::string text = fmt::format("{{x_m: {}, y_m: {}", goal.x_m, goal.y_m);
  if (goal.theta_rad) {
    text += fmt::format(", theta_rad: {}", *goal.theta_rad);
  }
  text += fmt::format(", position_tolerance_m: {}", goal.position_tolerance_m);
  if (goal.theta_rad) {
    text += fmt::format(", orientation_tolerance_rad: {}", goal.orientation_tolerance_rad);
  }
  return text + "}";
}

std::string body_to_yaml(const Environment& environment) {
  std::string text = environment.obstacles.empty() ? "obstacles: []\n" : "obstacles:\n";
  for (const Obstacle& obstacle : environment.obstacles) {
    text += "  - " + std::visit([](const auto& o) { return to_yaml(o); }, obstacle) + "\n";
  }
  text += "start: " + (environment.start ? to_yaml(*environment.start) : "rest") + "\n";
  return text + "goal: " + to_yaml(environment.goal) + "\n";
}

bool is_solid(const Obstacle& obstacle) {
  const auto is_size = [](double size_m) { return std::isfinite(size_m) && size_m > 0.0; };
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    return std::isfinite(circle->x_m) && std::isfinite(circle->y_m) && is_size(circle->radius_m);
  }
  if (const auto* rectangle = std::get_if<Rectangle>(&obstacle)) {
    return std::isfinite(rectangle->x_m) && std::isfinite(rectangle->y_m) &&
           std::isfinite(rectangle->angle_rad) && is_size(rectangle->width_m) &&
           is_size(rectangle->height_m);
  }
  const auto& corners_m = std::get<Polygon>(obstacle).points_m;
  return corners_m.size() >= 3 && std::ranges::all_of(corners_m, [](const Eigen::Vector2d& corner) {
           return corner.allFinite();
         });
}

}  // namespace

std::string why_not_solid(const std::vector<Obstacle>& obstacles) {
  const auto wrong = std::ranges::find_if_not(obstacles, is_solid);
  return wrong == obstacles.end()
             ? ""
             : fmt::format(
                   "obstacles[{}]: expected finite numbers, sizes > 0, and 3 corners or more",
                   wrong - obstacles.begin());
}

const char* obstacle_kind(const Obstacle& obstacle) {
  constexpr const char* kKinds[] = {"circle", "rectangle", "polygon"};
  return kKinds[obstacle.index()];
}

std::string obstacle_name(const Environment& environment, int obstacle) {
  return fmt::format("obstacle {} ({})", obstacle, obstacle_kind(environment.obstacles[obstacle]));
}

std::vector<Eigen::Vector2d> rectangle_corners(const Rectangle& rectangle) {
  const Eigen::Vector2d along(std::cos(rectangle.angle_rad), std::sin(rectangle.angle_rad));
  const Eigen::Vector2d u = 0.5 * rectangle.width_m * along;
  const Eigen::Vector2d v = 0.5 * rectangle.height_m * Eigen::Vector2d(-along.y(), along.x());
  const Eigen::Vector2d centre(rectangle.x_m, rectangle.y_m);
  return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

std::string environment_to_yaml(const Environment& environment) {
  return fmt::format("schema: limber/environment/1\nname: {}\n", yaml_text(environment.name)) +
         body_to_yaml(environment);
}

std::string environment_hash(const Environment& environment) {
  return content_hash(body_to_yaml(environment));
}

void require_start_of(const ArmDescription& arm, const Environment& environment) {
  if (!environment.start) {
    return;
  }
  const ArmStart& start = *environment.start;
  const auto require = [&](const char* what, Eigen::Index found, int expected) {
    refuse_if(found != expected, "environment '{}': start.{}: {} found; expected {}, of arm '{}'",
              environment.name, what, found, expected, arm.name);
  };
  require("pressures_kpa", start.pressures_kpa.size(), arm.channel_count());
  for (const Pressures& setpoint_kpa : start.setpoints_kpa) {
    require("setpoints_kpa", setpoint_kpa.size(), arm.channel_count());
  }
  require("backbone", start.backbone.rows(), arm.point_count());
  if (start.before.rows() > 0) {
    require("backbone_before", start.before.rows(), arm.point_count());
  }
}

ArmStart start_state(const Environment& environment, const ArmDescription& arm) {
  require_start_of(arm, environment);
  if (environment.start) {
    return *environment.start;
  }
  ArmStart rest;
  rest.pressures_kpa = Pressures::Zero(arm.channel_count());
  rest.backbone = Backbone::Zero(arm.point_count(), kPoseSize);
  for (int gap = 0; gap + 1 < arm.point_count(); ++gap) {
    const Segment& segment = arm.segments[arm.segment_of_gap(gap)];
    rest.backbone(gap + 1, 0) = rest.backbone(gap, 0) + float(segment.length_m / segment.gaps);
  }
  return rest;
}

}  // namespace limber
