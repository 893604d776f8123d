#include "pictures.hpp"

#include <algorithm>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/planning/planner.hpp"
#include "limber/plot/chart.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/report/training_report.hpp"
#include "limber/run/executor.hpp"
#include "limber/world/obstacle_shape.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"

namespace limber::python {

namespace {

constexpr double kWidthPx = 420.0;  // beside a notebook's text
constexpr double kRoom = 0.1;       // about a picture's content, of its size

/// Grows to hold a square about a point.
void hold(Box& box, const Eigen::Vector2d& point_m, double radius_m) {
  box.include(point_m.array() - radius_m);
  box.include(point_m.array() + radius_m);
}

void hold(Box& box, const Box& other) {
  box.include(other.low);
  box.include(other.high);
}

WorldBox with_room(const Box& box) {
  const double room_m = kRoom * (box.high - box.low).maxCoeff() + 0.01;
  return {box.low.x() - room_m, box.high.x() + room_m, box.low.y() - room_m, box.high.y() + room_m};
}

Box box_of(const ArmDescription& arm, const Backbone& backbone) {
  Box box;
  double width_m = 0.0;
  for (const Segment& segment : arm.segments) {
    width_m = std::max(width_m, segment.width_m);
  }
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    hold(box, {double(backbone(i, 0)), double(backbone(i, 1))}, width_m);
  }
  return box;
}

const ShapeStyle& arm_style() {
  static const ShapeStyle style{.fill = palette_color(kNetworkColor), .stroke = "none"};
  return style;
}

}  // namespace

std::string backbone_picture(const ArmDescription& arm, const Backbone& backbone) {
  SvgDrawing drawing(with_room(box_of(arm, backbone)), kWidthPx, arm.name);
  drawing.axes();
  draw_arm(drawing, arm, backbone, arm_style());
  return drawing.svg();
}

std::optional<std::string> arm_picture(const ArmDescription& arm) {
  if (arm.is_spatial()) {
    return std::nullopt;  // a notebook then shows its repr
  }
  return backbone_picture(arm, start_state(Environment(), arm).backbone);
}

std::string obstacles_picture(const Environment& environment) {
  Box box;  // the arm's base, whatever else there is
  for (const Obstacle& obstacle : environment.obstacles) {
    hold(box, make_obstacle_shape(obstacle, 0).box);
  }
  const PoseGoal& goal = environment.goal;
  hold(box, {goal.x_m, goal.y_m}, goal.position_tolerance_m);
  SvgDrawing drawing(with_room(box), kWidthPx, environment.name);
  drawing.axes();
  draw_environment(drawing, environment);
  return drawing.svg();
}

std::string motion_picture(const Plan& plan) {
  if (plan.arm_description.empty() || plan.frames.empty()) {
    return {};
  }
  const ArmDescription arm = read_arm_keys(plan.arm_description, "plan");
  Box box = box_of(arm, plan.frames.front().backbone);
  for (const PlanFrame& frame : plan.frames) {
    hold(box, box_of(arm, frame.backbone));
  }
  SvgDrawing drawing(with_room(box), kWidthPx, plan.environment_name);
  drawing.axes();
  draw_plan(drawing, arm, plan);
  return drawing.svg();
}

std::string evaluation_picture(const Evaluation& evaluation) {
  std::vector<std::string> categories;
  std::vector<double> position_cm;
  std::vector<double> orientation_rad;
  const auto add = [&](const char* name, const TipErrors& errors) {
    categories.emplace_back(name);
    position_cm.push_back(errors.position_cm.mean);
    orientation_rad.push_back(errors.orientation_rad.mean);
  };
  if (const auto& network = evaluation.network) {
    add("one step", network->one_step);
    add("32 frames", network->window_32);
    add("motion", network->per_motion);
    add("open loop", network->open_loop);
    if (network->open_loop_from_setpoints) {
      add("set points", *network->open_loop_from_setpoints);
    }
  }
  add("no load", evaluation.no_load_open_loop);
  SeriesStyle style;
  style.color = palette_color(kNetworkColor);
  const auto chart = [&](const char* title, const char* label, const std::vector<double>& values) {
    return Chart(title).y_axis(label).without_legend().bars(categories, "mean", values, {}, style);
  };
  return ChartGrid(2)
      .add(chart("Position error of the tip", "mean position error [cm]", position_cm))
      .add(chart("Orientation error of the tip", "mean orientation error [rad]", orientation_rad))
      .svg();
}

void bind_pictures(py::module_& module) {
  module.def("environment_picture",
             of_planar_arms("limber.environment_picture", &environment_picture), "arm"_a,
             "environment"_a, py::call_guard<OthersMayRun>(),
             "The environment with the arm at its start, as an SVG file's text.");
  module.def("plan_picture", of_planar_arms("limber.plan_picture", &plan_picture), "arm"_a,
             "environment"_a, "result"_a, py::call_guard<OthersMayRun>(),
             "Environment, search tree and plan (or the nearest motion, dashed), as SVG text.");
  module.def("plan_animation", of_planar_arms("limber.plan_animation", &plan_animation), "arm"_a,
             "environment"_a, "plan"_a, py::call_guard<OthersMayRun>(),
             "One self-contained HTML page in which the arm moves.");
  module.def(
      "pressure_picture",
      [](const ArmDescription& arm, const Plan& plan) {
        require_planar(arm, "limber.pressure_picture");
        require_plan_of(plan, arm, "plan");
        return pressure_picture(arm, plan);
      },
      "arm"_a, "plan"_a, py::call_guard<OthersMayRun>(),
      "Set points and the pressures predicted from them over time, as SVG text.");
  module.def("execution_picture", of_planar_arms("limber.execution_picture", &execution_picture),
             "arm"_a, "environment"_a, "plan"_a, "result"_a, py::call_guard<OthersMayRun>(),
             "One run beside its prediction, as an SVG file's text.");
  module.def("execution_animation",
             of_planar_arms("limber.execution_animation", &execution_animation), "arm"_a,
             "environment"_a, "plan"_a, "result"_a, py::call_guard<OthersMayRun>(),
             "A page in which the arm moves, as predicted and as measured.");
  module.def("learning_curve_svg", &learning_curve_svg, "curve"_a, py::call_guard<OthersMayRun>(),
             "Loss and validation error over epochs, as SVG text.");
  module.def(
      "arm_svg",
      [](const ArmDescription& arm, const FloatArray& backbone) {
        require_planar(arm, "limber.arm_svg");
        return backbone_picture(arm, backbone_from(backbone, arm.point_count(), "backbone"));
      },
      "arm"_a, "backbone"_a, "The arm with this backbone, float32 (m, 3), as SVG.");
}

}  // namespace limber::python
