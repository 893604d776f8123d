#include "limber/report/plan_picture.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "animation_page.hpp"
#include "limber/common/units.hpp"
#include "limber/plot/shape_style.hpp"
#include "limber/plot/svg_text.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

/// Tenths of a millimetre: far below a pixel.
double rounded(double value_m) {
  return std::round(value_m * 1e4) / 1e4;
}

Json point(double x_m, double y_m) {
  return {rounded(x_m), rounded(y_m)};
}

Json to_json(const Obstacle& obstacle) {
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    return {{"x", circle->x_m}, {"y", circle->y_m}, {"radius", circle->radius_m}};
  }
  const auto* rectangle = std::get_if<Rectangle>(&obstacle);
  Json points = Json::array();
  for (const Eigen::Vector2d& p :
       rectangle ? rectangle_corners(*rectangle) : std::get<Polygon>(obstacle).points_m) {
    points.push_back(point(p.x(), p.y()));
  }
  return {{"points", points}};
}

Json to_json(const AnimationTrack& track) {
  Json shapes = Json::array();
  for (const Backbone& shape : track.shapes) {
    Json points = Json::array();
    for (Eigen::Index i = 0; i < shape.rows(); ++i) {
      points.push_back(point(double(shape(i, 0)), double(shape(i, 1))));
    }
    shapes.push_back(std::move(points));
  }
  return {{"label", track.label}, {"color", track.color}, {"shapes", shapes}};
}

Json to_json(const std::vector<Pressures>& rows) {
  Json json = Json::array();
  for (const Pressures& row : rows) {
    json.push_back(std::vector<float>(row.begin(), row.end()));
  }
  return json;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string animation_page(const ArmDescription& arm, const Environment& environment,
                           const std::string& title, const std::vector<AnimationTrack>& tracks,
                           const std::vector<Pressures>& setpoints_kpa,
                           const std::vector<Pressures>& pressures_kpa) {
  const WorldBox box = picture_box(arm, environment);
  const PoseGoal& goal = environment.goal;
  Json data;
  data["box"] = {{"x_min", box.x_min_m},
                 {"x_max", box.x_max_m},
                 {"y_min", box.y_min_m},
                 {"y_max", box.y_max_m}};
  data["rate_hz"] = arm.frame_rate_hz;
  data["goal"] = {{"x", goal.x_m},
                  {"y", goal.y_m},
                  {"tolerance", goal.position_tolerance_m},
                  {"theta", goal.theta_rad ? Json(*goal.theta_rad) : Json(nullptr)}};
  data["radii"] = Json::array();
  for (const Segment& segment : arm.segments) {
    for (int gap = 0; gap < segment.gaps; ++gap) {
      data["radii"].push_back(0.5 * segment.width_m + arm.actuator_radius_m);
    }
  }
  data["obstacles"] = Json::array();
  for (const Obstacle& obstacle : environment.obstacles) {
    data["obstacles"].push_back(to_json(obstacle));
  }
  data["tracks"] = Json::array();
  for (const AnimationTrack& track : tracks) {
    data["tracks"].push_back(to_json(track));
  }
  data["setpoints_kpa"] = to_json(setpoints_kpa);
  data["pressures_kpa"] = to_json(pressures_kpa);
  data["unit"] = arm.command.unit;
  std::string json = data.dump();
  replace_all(json, "<", "\\u003c");  // nothing in the data may end the script element
  std::string page = kAnimationPage;
  replace_all(page, "@TITLE@", escape_xml(title));
  replace_all(page, "@DATA@", json);
  return page;
}

std::string plan_animation(const ArmDescription& arm, const Environment& environment,
                           const Plan& plan) {
  AnimationTrack track{"as the model predicts it",
                       palette_color(plan.model == "network" ? kNetworkColor : kNoLoadColor),
                       {}};
  std::vector<Pressures> setpoints;
  std::vector<Pressures> pressures;
  for (const PlanFrame& frame : plan.frames) {
    track.shapes.push_back(frame.backbone);
    setpoints.push_back(frame.setpoint_kpa);
    pressures.push_back(frame.pressure_kpa);
  }
  return animation_page(
      arm, environment,
      fmt::format("{}: {} model, {:.1f} psi", environment.name,
                  plan.model == "network" ? "network" : "no-load", plan.cost_kpa / kKpaPerPsi),
      {track}, setpoints, pressures);
}

}  // namespace limber
