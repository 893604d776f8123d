#include "limber/report/plan_picture.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "animation.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/mapped.hpp"
#include "limber/plot/chart.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/world/obstacle_shape.hpp"

namespace limber {

namespace {

constexpr int kPlanShapes = 9;      // of the arm along the plan, the last one included
constexpr double kFaintest = 0.10;  // opacity of the first of them
constexpr double kStarRadiusM = 0.016;

const ShapeStyle kObstacleStyle{.fill = "#9a9a9a", .stroke = "#555555", .width_px = 1.0};
const ShapeStyle kGoalStyle{.fill = "#009e73", .stroke = "#00523c", .width_px = 1.0};
const ShapeStyle kStartStyle{.fill = "#dddddd", .stroke = "#222222", .width_px = 1.0};
const ShapeStyle kTreeStyle{.stroke = "#cc79a7", .width_px = 0.6, .opacity = 0.35};

WorldPoint world(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

void draw(SvgDrawing& drawing, const Circle& c) {
  drawing.circle({c.x_m, c.y_m}, c.radius_m, kObstacleStyle);
}

void draw(SvgDrawing& drawing, const Rectangle& r) {
  drawing.rectangle({r.x_m, r.y_m}, r.width_m, r.height_m, r.angle_rad, kObstacleStyle);
}

void draw(SvgDrawing& drawing, const Polygon& polygon) {
  const auto points =
      mapped<WorldPoint>(polygon.points_m, [&](const Eigen::Vector2d& p) { return world(p); });
  drawing.polygon(points, kObstacleStyle);
}

}  // namespace

std::string model_color(const std::string& model) {
  return palette_color(model == "network" ? kNetworkColor : kNoLoadColor);
}

std::vector<WorldPoint> center_line(const Backbone& backbone) {
  return mapped<WorldPoint>(backbone.rows(), [&](Eigen::Index i) {
    return WorldPoint{backbone(i, 0), backbone(i, 1)};
  });
}

void draw_tip_path(SvgDrawing& drawing, const Plan& plan, const ShapeStyle& style) {
  const auto tips = mapped<WorldPoint>(
      plan.frames, [&](const PlanFrame& frame) { return world(tip_position_m(frame.backbone)); });
  drawing.polyline(tips, style);
}

WorldBox picture_box(const ArmDescription& arm, const Environment& environment) {
  const double reach = arm.length_m();
  WorldBox box{-0.2 * reach, 1.1 * reach, -0.8 * reach, 0.8 * reach};
  const double room = 0.1 * reach;
  const PoseGoal& goal = environment.goal;
  const auto include = [&](double x, double y) {
    box.x_min_m = std::min(box.x_min_m, x - room);
    box.x_max_m = std::max(box.x_max_m, x + room);
    box.y_min_m = std::min(box.y_min_m, y - room);
    box.y_max_m = std::max(box.y_max_m, y + room);
  };
  include(goal.x_m, goal.y_m);
  for (std::size_t i = 0; i < environment.obstacles.size(); ++i) {
    const Box around = make_obstacle_shape(environment.obstacles[i], int(i)).box;
    // What lies beyond the arm's reach is cut off.
    const auto within = [&](double v) { return std::clamp(v, -1.2 * reach, 1.2 * reach); };
    include(within(around.low.x()), within(around.low.y()));
    include(within(around.high.x()), within(around.high.y()));
  }
  return box;
}

void draw_environment(SvgDrawing& drawing, const Environment& environment) {
  for (const Obstacle& obstacle : environment.obstacles) {
    std::visit([&](const auto& o) { draw(drawing, o); }, obstacle);
  }
  const PoseGoal& goal = environment.goal;
  const WorldPoint centre{goal.x_m, goal.y_m};
  drawing.circle(centre, goal.position_tolerance_m,
                 {.fill = kGoalStyle.fill,
                  .stroke = kGoalStyle.stroke,
                  .width_px = 1.0,
                  .opacity = 0.35,
                  .dashed = true});
  drawing.star(centre, kStarRadiusM, kGoalStyle);
  if (goal.theta_rad) {
    constexpr double kArrowM = 0.07;
    drawing.arrow(centre,
                  {goal.x_m + kArrowM * std::cos(*goal.theta_rad),
                   goal.y_m + kArrowM * std::sin(*goal.theta_rad)},
                  {.stroke = kGoalStyle.stroke, .width_px = 2.0});
  }
}

void draw_arm(SvgDrawing& drawing, const ArmDescription& arm, const Backbone& backbone,
              const ShapeStyle& style) {
  std::vector<double> radii;
  for (const Segment& segment : arm.segments) {
    radii.insert(radii.end(), std::size_t(segment.gaps),
                 0.5 * segment.width_m + arm.actuator_radius_m);
  }
  drawing.capsule_chain(center_line(backbone), radii, style);
}

void draw_tree(SvgDrawing& drawing, const std::vector<TreeEdge>& tree) {
  std::vector<WorldPoint> ends;
  ends.reserve(2 * tree.size());
  for (const TreeEdge& edge : tree) {
    ends.push_back({edge.from_m.x(), edge.from_m.y()});
    ends.push_back({edge.to_m.x(), edge.to_m.y()});
  }
  drawing.segments(ends, kTreeStyle);
}

void draw_plan(SvgDrawing& drawing, const ArmDescription& arm, const Plan& plan) {
  const int moving = plan.frame_count() - plan.hold_frame_count;
  const int shapes = std::min(kPlanShapes, moving);
  const std::string color = model_color(plan.model);
  for (int k = 0; k < shapes; ++k) {
    const bool last = k + 1 == shapes;
    const int frame =
        last ? plan.frame_count() - 1 : int(std::lround(k * (moving - 1.0) / (shapes - 1)));
    const ShapeStyle style =
        last ? ShapeStyle{.fill = color, .stroke = "#222222", .width_px = 1.0, .opacity = 0.85}
             : ShapeStyle{.fill = color,
                          .stroke = "none",
                          .opacity = kFaintest + (0.45 - kFaintest) * k / std::max(1, shapes - 1)};
    draw_arm(drawing, arm, plan.frames[frame].backbone, style);
  }
  draw_tip_path(drawing, plan, {.stroke = "#222222", .width_px = 1.5});
}

std::string pressure_picture(const ArmDescription& arm, const Plan& plan) {
  const auto time_s =
      mapped<double>(plan.frame_count(), [&](int k) { return k * arm.frame_period_s(); });
  Chart chart(fmt::format("Set points and {}s", followed_name(arm.command)));
  chart.x_axis("time [s]").y_axis(fmt::format("{} [{}]", arm.command.name, arm.command.unit));
  for (Eigen::Index i = 0; i < arm.segment_count(); ++i) {
    std::vector<double> setpoints, predicted;
    for (const PlanFrame& frame : plan.frames) {
      setpoints.push_back(double(frame.setpoint_kpa[i]));
      predicted.push_back(double(frame.pressure_kpa[i]));
    }
    const SeriesStyle style{.color = palette_color(int(i) + 3)};
    chart.line(fmt::format("{}: set point", segment_name(i)), time_s, std::move(setpoints),
               {.color = style.color, .width_px = 1.0, .dashed = true});
    chart.line(fmt::format("{}: predicted", segment_name(i)), time_s, std::move(predicted), style);
  }
  return chart.svg();
}

std::string environment_picture(const ArmDescription& arm, const Environment& environment) {
  SvgDrawing drawing(picture_box(arm, environment), kPictureWidthPx, environment.name);
  drawing.axes();
  draw_arm(drawing, arm, start_state(environment, arm).backbone, kStartStyle);
  draw_environment(drawing, environment);
  drawing.legend("the arm at its start", kStartStyle);
  drawing.legend("goal and its tolerance", kGoalStyle);
  drawing.legend("obstacle", kObstacleStyle);
  return drawing.svg();
}

std::string plan_picture(const ArmDescription& arm, const Environment& environment,
                         const PlanResult& result) {
  std::string title = environment.name;
  if (result.plan) {
    title += fmt::format(", {} model: {}, {:.1f} s",
                         result.plan->model == "network" ? "network" : "no-load",
                         cost_text(*result.plan), result.plan->duration_s());
  } else {
    title += fmt::format(": {}", to_string(result.status));
  }
  SvgDrawing drawing(picture_box(arm, environment), kPictureWidthPx, title);
  drawing.axes();
  draw_tree(drawing, result.tree);
  if (result.plan) {
    draw_plan(drawing, arm, *result.plan);
    drawing.legend("the plan's last shape, as predicted",
                   {.fill = model_color(result.plan->model), .stroke = "#222222", .width_px = 1.0});
    drawing.legend("path of its tip", {.stroke = "#222222", .width_px = 1.5});
  } else if (result.best_partial) {
    const ShapeStyle nearest{
        .fill = model_color(result.best_partial->model), .stroke = "none", .opacity = 0.4};
    draw_arm(drawing, arm, result.best_partial->frames.back().backbone, nearest);
    draw_tip_path(drawing, *result.best_partial, {.stroke = "#222222", .dashed = true});
    drawing.legend("no plan; the nearest motion found", nearest);
  } else {
    draw_arm(drawing, arm, start_state(environment, arm).backbone, kStartStyle);
  }
  draw_environment(drawing, environment);
  if (!result.tree.empty()) {
    drawing.legend("tips of the search tree", {.stroke = kTreeStyle.stroke, .width_px = 2.0});
  }
  drawing.legend("goal and its tolerance", kGoalStyle);
  drawing.legend("obstacle", kObstacleStyle);
  return drawing.svg();
}

}  // namespace limber
