#include "limber/report/scene_json.hpp"

#include <cmath>

#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"

namespace limber {

namespace {

Json exact_pressures(const Pressures& kpa) {
  return std::vector<float>(kpa.begin(), kpa.end());
}

Json start_to_json(const ArmStart& start) {
  Json json = {{"pressures_kpa", exact_pressures(start.pressures_kpa)},
               {"backbone", exact_backbone(start.backbone)}};
  if (start.before.rows() > 0) {
    json["backbone_before"] = exact_backbone(start.before);
  }
  for (const Pressures& kpa : start.setpoints_kpa) {
    json["setpoints_kpa"].push_back(exact_pressures(kpa));
  }
  return json;
}

}  // namespace

Json exact_backbone(const Backbone& backbone) {
  return mapped<Json>(backbone.rows(), [&](Eigen::Index i) {
    return Json{backbone(i, 0), backbone(i, 1), backbone(i, 2)};
  });
}

double rounded_to(double value, double parts) {
  return std::round(value * parts) / parts;
}

Json arm_to_json(const ArmDescription& arm) {
  Json json = {{"name", arm.name},
               {"command", {{"name", arm.command.name}, {"unit", arm.command.unit}}},
               {"frame_rate_hz", arm.frame_rate_hz},
               {"rate_limit_kpa_per_s", arm.pressure_rate_limit_kpa_per_s},
               {"length_m", arm.length_m()},
               {"actuator_radius_m", arm.actuator_radius_m}};
  json["segments"] = Json::array();
  for (const Segment& segment : arm.segments) {
    json["segments"].push_back({{"length_m", segment.length_m},
                                {"width_m", segment.width_m},
                                {"gaps", segment.gaps},
                                {"lower_kpa", segment.pressure_limit_kpa.lower_kpa},
                                {"upper_kpa", segment.pressure_limit_kpa.upper_kpa}});
  }
  json["rest"] = shape_to_json(start_state(Environment(), arm).backbone);
  return json;
}

Json obstacle_to_json(const Obstacle& obstacle) {
  if (const auto* c = std::get_if<Circle>(&obstacle)) {
    return {{"circle", {{"x_m", c->x_m}, {"y_m", c->y_m}, {"radius_m", c->radius_m}}}};
  }
  if (const auto* r = std::get_if<Rectangle>(&obstacle)) {
    return {{"rectangle",
             {{"x_m", r->x_m},
              {"y_m", r->y_m},
              {"width_m", r->width_m},
              {"height_m", r->height_m},
              {"angle_rad", r->angle_rad}}}};
  }
  const auto points =
      mapped<Json>(std::get<Polygon>(obstacle).points_m, [&](const Eigen::Vector2d& p) {
        return Json{p.x(), p.y()};
      });
  return {{"polygon", points}};
}

Json environment_to_json(const Environment& environment) {
  Json json = {{"name", environment.name}, {"obstacles", Json::array()}};
  for (const Obstacle& obstacle : environment.obstacles) {
    json["obstacles"].push_back(obstacle_to_json(obstacle));
  }
  json["start"] = environment.start ? start_to_json(*environment.start) : Json("rest");
  const PoseGoal& goal = environment.goal;
  json["goal"] = {{"x_m", goal.x_m}, {"y_m", goal.y_m}};
  if (goal.theta_rad) {
    json["goal"]["theta_rad"] = *goal.theta_rad;
  }
  json["goal"]["position_tolerance_m"] = goal.position_tolerance_m;
  if (goal.theta_rad) {
    json["goal"]["orientation_tolerance_rad"] = goal.orientation_tolerance_rad;
  }
  return json;
}

Json shape_to_json(const Eigen::Ref<const Backbone>& backbone) {
  Json numbers = Json::array();
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    numbers.push_back(rounded_to(double(backbone(i, 0)), 1e5));
    numbers.push_back(rounded_to(double(backbone(i, 1)), 1e5));
    numbers.push_back(rounded_to(double(backbone(i, 2)), 1e4));
  }
  return numbers;
}

Json length_to_json(double length_m) {
  return std::isfinite(length_m) ? Json(rounded_to(length_m, 1e5)) : Json(nullptr);
}

Json pressures_to_json(const Eigen::Ref<const Pressures>& kpa) {
  return mapped<Json>(kpa, [&](const float value) { return rounded_to(double(value), 1e3); });
}

Json rows_to_json(const FrameMatrix& rows) {
  return mapped<Json>(rows.rows(),
                      [&](Eigen::Index k) { return pressures_to_json(rows.row(k).transpose()); });
}

Json setpoints_to_json(const Plan& plan) {
  return mapped<Json>(
      plan.frames, [&](const PlanFrame& frame) { return pressures_to_json(frame.setpoint_kpa); });
}

}  // namespace limber
