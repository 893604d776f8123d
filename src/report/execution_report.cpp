#include "limber/report/execution_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "animation.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"
#include "limber/network/physical_traits.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/report/driver_report.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/report/scene_json.hpp"
#include "limber/report/training_report.hpp"

namespace limber {

namespace {

std::string contact_text(const Contact& contact, const Environment& environment) {
  const int obstacle = contact.clearance.obstacle;
  return fmt::format("{}, {}, {:.2f} s", obstacle_name(environment, obstacle),
                     plates_of_gap(contact.clearance.gap), contact.time_s);
}

Json to_json(const std::optional<Contact>& contact, const Environment& environment) {
  if (!contact) {
    return nullptr;
  }
  const auto obstacle = std::size_t(contact->clearance.obstacle);
  return {{"time_s", contact->time_s},
          {"clearance_cm", kCmPerM * contact->clearance.value_m},
          {"obstacle", obstacle},
          {"kind", obstacle_kind(environment.obstacles[obstacle])},
          {"plates", {contact->clearance.gap, contact->clearance.gap + 1}}};
}

constexpr int kShapes = 6;  // drawn along the motion
constexpr const char* kCollisionColor = "#b2182b";

std::string title_of(const Environment& environment, const ExecutionResult& result) {
  std::string title = environment.name + ": " + to_string(result.status);
  if (result.final_backbone) {
    title += fmt::format(", {:.1f} cm from the goal", kCmPerM * result.goal_error.position_m);
  }
  return title + (result.collided ? ", collided" : "");
}

void draw_tip_path(SvgDrawing& drawing, const ArmDescription& arm, const Episode& episode,
                   const std::string& color) {
  const int frames = episode.frame_count();
  std::vector<WorldPoint> tips;
  for (int t = 0; t < frames; ++t) {
    const Eigen::Vector2d tip = tip_position_m(backbone_at(episode.backbone, t));
    tips.push_back({tip.x(), tip.y()});
  }
  for (int k = 0; k < std::min(kShapes, frames); ++k) {
    const auto frame = Eigen::Index(std::lround(k * (frames - 1.0) / kShapes));
    draw_arm(drawing, arm, backbone_at(episode.backbone, frame),
             {.fill = color, .stroke = "none", .opacity = 0.08 + 0.03 * k});
  }
  drawing.polyline(tips, {.stroke = color, .width_px = 1.5});
}

void draw_prediction(SvgDrawing& drawing, const ArmDescription& arm, const Plan& plan) {
  const std::string color = model_color(plan.model);
  const ShapeStyle end{.fill = color, .stroke = "none", .opacity = 0.4};
  draw_arm(drawing, arm, plan.frames.back().backbone, end);
  draw_tip_path(drawing, plan, {.stroke = color, .width_px = 2.0, .dashed = true});
  drawing.legend(fmt::format("end that the {} model predicts; dashed: its tip's path",
                             plan.model == "network" ? "network" : "no-load"),
                 end);
}

void draw_collision(SvgDrawing& drawing, const ArmDescription& arm, const Episode& episode,
                    const Contact& contact) {
  const auto later = std::lower_bound(episode.time_s.begin(), episode.time_s.end(), contact.time_s);
  const Eigen::Index frame =
      std::min<Eigen::Index>(later - episode.time_s.begin(), episode.time_s.size() - 1);
  const ShapeStyle style{.fill = kCollisionColor, .stroke = kCollisionColor, .opacity = 0.5};
  draw_arm(drawing, arm, backbone_at(episode.backbone, frame), style);
  drawing.legend(fmt::format("first collision, {:.2f} s", contact.time_s), style);
}

}  // namespace

Json to_json(const ExecutionResult& result, const Environment& before) {
  const Environment environment = with_appeared(before, result);
  const bool is_seen = result.final_backbone.has_value();
  Json json;
  json["status"] = to_string(result.status);
  json["collided"] = is_seen || result.collided ? Json(result.collided) : Json(nullptr);
  json["min_clearance_cm"] =
      result.closest ? Json(kCmPerM * result.closest->clearance.value_m) : Json(nullptr);
  json["distance_to_goal_cm"] =
      is_seen ? Json(kCmPerM * result.goal_error.position_m) : Json(nullptr);
  json["orientation_to_goal_rad"] = is_seen && environment.goal.theta_rad
                                        ? Json(result.goal_error.orientation_rad)
                                        : Json(nullptr);
  json["replans"] = result.replans;
  json["switches"] = result.switches;
  json["waits"] = result.waits;
  json["halts"] = result.halts;
  json["frames_not_certified"] = result.frames_not_certified;
  json["advice_ms"] = times_in_ms(result.advice.all_s);
  json["searches_ms"] = Json::array();
  for (const double took_s : result.advice.searches_s) {
    json["searches_ms"].push_back(kMsPerS * took_s);
  }
  json["late_advice"] = result.advice.late;
  json["goal_time_s"] = optional_json(result.goal_time_s);
  json["planned_goal_time_s"] = optional_json(result.planned_goal_time_s);
  json["open_loop_distance_to_goal_cm"] =
      result.open_loop_goal_error ? Json(kCmPerM * result.open_loop_goal_error->position_m)
                                  : Json(nullptr);
  if (result.arm) {
    const Eigen::VectorXf deviation = result.arm->deviation();
    json["arm"] = {{"e", std::vector<float>(result.arm->e.begin(), result.arm->e.end())},
                   {"sd", std::vector<float>(deviation.begin(), deviation.end())},
                   {"distance_from_family", result.arm->distance()},
                   {"changed_s", optional_json(result.arm_changed_s)},
                   {"changes", to_json(result.arm_changes)},
                   {"largest_window_error_cm", kCmPerM * result.largest_window_error_m},
                   {"last_window_error_cm", kCmPerM * result.last_window_error_m}};
  }
  json["pressure_losses"] = Json::array();
  for (const PressureLoss& loss : result.pressure_losses) {
    json["pressure_losses"].push_back(
        {{"segment", loss.segment}, {"share", loss.share}, {"noticed_s", loss.noticed_s}});
  }
  json["frames"] = result.frames;
  json["frames_not_seen"] = result.frames_not_seen;
  json["goal_reached"] = is_seen ? Json(result.goal_reached) : Json(nullptr);
  json["message"] = result.message;
  json["closest"] = to_json(result.closest, environment);
  json["first_collision"] = to_json(result.first_collision, environment);
  json["start_error_cm"] = kCmPerM * result.start_error_m;
  json["stopped_ahead"] = result.stopped_ahead;
  json["obstacle_appeared"] = nullptr;
  if (result.appeared) {
    const Circle& circle = result.appeared->circle;
    json["obstacle_appeared"] = {{"time_s", result.appeared->time_s},
                                 {"x_m", circle.x_m},
                                 {"y_m", circle.y_m},
                                 {"radius_m", circle.radius_m}};
  }
  json["prediction_error_cm"] = nullptr;
  if (result.prediction) {
    json["prediction_error_cm"] = {{"mean", kCmPerM * result.prediction->mean_m},
                                   {"before_hold", kCmPerM * result.prediction->before_hold_m},
                                   {"largest", kCmPerM * result.prediction->max_m},
                                   {"final", kCmPerM * result.prediction->final_m}};
  }
  json["final_backbone"] =
      result.final_backbone ? exact_backbone(*result.final_backbone) : Json(nullptr);
  return json;
}

std::string to_text(const ExecutionResult& result, const Environment& before) {
  const Environment environment = with_appeared(before, result);
  std::string text = fmt::format("{}, {} frames", to_string(result.status), result.frames);
  if (result.final_backbone) {
    text += fmt::format("\n  {:.1f} cm", kCmPerM * result.goal_error.position_m);
    if (environment.goal.theta_rad) {
      text += fmt::format(" and {:.2f} rad", result.goal_error.orientation_rad);
    }
    text += fmt::format(" from the goal: {}", result.goal_reached ? "reached" : "not reached");
    if (result.open_loop_goal_error) {
      text += fmt::format("; {:.1f} cm off before {} more plans",
                          kCmPerM * result.open_loop_goal_error->position_m, result.replans);
    }
    if (result.switches + result.waits > 0) {
      text += fmt::format("\n  in motion: {} other plans, {} frames of waiting", result.switches,
                          result.waits);
    }
  } else {
    text += fmt::format("\n  the arm was not seen {}: distance to the goal and {} unknown",
                        result.frames_not_seen < result.frames ? "at the end" : "at all",
                        result.collided ? "later collisions are" : "collisions are");
  }
  if (result.frames_not_certified > 0) {
    text += fmt::format(
        "\n  in {} frames nothing was certified from where the arm was: it kept to what was "
        "certified last",
        result.frames_not_certified);
  }
  if (result.arm && result.largest_window_error_m > 0.0) {
    text += fmt::format(
        "\n  which arm it is was fitted while it moved: short predictions were off by {:.1f} cm "
        "at most, {:.1f} in the end{}",
        kCmPerM * result.largest_window_error_m, kCmPerM * result.last_window_error_m,
        result.arm->distance() >= FamilyMember::kFar ? "; no arm of the family is like this one"
                                                     : "");
    if (result.arm_changed_s) {
      text += fmt::format(
          "\n  after {:.1f} s it did not move as it was known to: {}", *result.arm_changed_s,
          result.arm_changes.empty() ? "what has changed, can't be told"
                                     : changes_text(result.arm_changes) + " (in brackets, before)");
    }
  }
  for (const PressureLoss& loss : result.pressure_losses) {
    text += "\n  " + to_text(loss);
  }
  if (result.frames_not_seen > 0 && result.final_backbone) {
    text += fmt::format("\n  not tracked in {} frames", result.frames_not_seen);
  }
  if (result.appeared) {
    const Circle& circle = result.appeared->circle;
    text += fmt::format("\n  an obstacle appeared after {:.2f} s at ({:.3f}, {:.3f}) m{}",
                        result.appeared->time_s, circle.x_m, circle.y_m,
                        result.stopped_ahead ? "; no plan leads past it: the arm stopped" : "");
  }
  if (result.first_collision) {
    text += "\n  collided with " + contact_text(*result.first_collision, environment);
  }
  if (result.closest) {
    text += fmt::format("\n  {} {:.1f} cm at {}",
                        result.closest->clearance.value_m < 0.0 ? "deepest" : "closest",
                        kCmPerM * std::abs(result.closest->clearance.value_m),
                        contact_text(*result.closest, environment));
  }
  if (result.prediction) {
    text += fmt::format("\n  tip off its prediction by {:.1f} cm on average, at most {:.1f}",
                        kCmPerM * result.prediction->mean_m, kCmPerM * result.prediction->max_m);
  }
  constexpr double kNotableStartError_m = 0.005;
  if (result.start_error_m > kNotableStartError_m) {
    text += fmt::format("\n  the arm started {:.1f} cm from where the plan starts",
                        kCmPerM * result.start_error_m);
  }
  return text;
}

std::string execution_picture(const ArmDescription& arm, const Environment& before,
                              const Plan& plan, const ExecutionResult& result) {
  const Environment environment = with_appeared(before, result);
  SvgDrawing drawing(picture_box(arm, environment), kPictureWidthPx, title_of(environment, result));
  drawing.axes();
  draw_environment(drawing, environment);
  const std::string truth = palette_color(kTrueArmColor);
  draw_prediction(drawing, arm, plan);
  if (result.episode.frame_count() > 0) {
    draw_tip_path(drawing, arm, result.episode, truth);
  }
  if (result.first_collision && result.episode.frame_count() > 0) {
    draw_collision(drawing, arm, result.episode, *result.first_collision);
  }
  if (result.final_backbone) {
    const ShapeStyle executed{.fill = truth, .stroke = truth, .width_px = 1.5, .opacity = 0.6};
    draw_arm(drawing, arm, *result.final_backbone, executed);
    drawing.legend("the arm's end, and the path of its tip", executed);
  }
  return drawing.svg();
}

std::string execution_animation(const ArmDescription& arm, const Environment& before,
                                const Plan& plan, const ExecutionResult& result) {
  Json motion = {{"frame_rate_hz", plan.frame_rate_hz},
                 {"appeared", appeared_to_json(result.appeared)},
                 {"setpoints_kpa", setpoints_to_json(plan)},
                 {"tracks", {predicted_track(arm, before, plan).json()}}};
  if (result.episode.frame_count() > 0) {
    motion["setpoints_kpa"] = rows_to_json(result.episode.setpoint_kpa);
    motion["tracks"].push_back(executed_track("arm", arm, before, result).json());
  }
  return animation_page(arm, before, title_of(before, result), std::move(motion),
                        execution_picture(arm, before, plan, result));
}

}  // namespace limber
