#include "limber/report/execution_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "animation.hpp"
#include "limber/common/units.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/report/scene_json.hpp"

namespace limber {

namespace {

constexpr int kShapes = 6;  // drawn along the motion
constexpr const char* kCollisionColor = "#b2182b";

Backbone recorded_backbone(const Episode& episode, Eigen::Index frame) {
  return backbone_at(episode.backbone, frame);
}

WorldPoint tip_of(const Backbone& backbone) {
  const Pose tip = tip_pose(backbone);
  return {tip.x_m, tip.y_m};
}

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
    tips.push_back(tip_of(recorded_backbone(episode, t)));
  }
  for (int k = 0; k < std::min(kShapes, frames); ++k) {
    const auto frame = static_cast<Eigen::Index>(std::lround(k * (frames - 1.0) / kShapes));
    draw_arm(drawing, arm, recorded_backbone(episode, frame),
             {.fill = color, .stroke = "none", .opacity = 0.08 + 0.03 * k});
  }
  drawing.polyline(tips, {.stroke = color, .width_px = 1.5});
}

void draw_prediction(SvgDrawing& drawing, const ArmDescription& arm, const Plan& plan) {
  const bool network = plan.model == "network";
  const std::string color = palette_color(network ? kNetworkColor : kNoLoadColor);
  std::vector<WorldPoint> tips;
  for (const PlanFrame& frame : plan.frames) {
    tips.push_back(tip_of(frame.backbone));
  }
  const ShapeStyle end{.fill = color, .stroke = "none", .opacity = 0.4};
  draw_arm(drawing, arm, plan.frames.back().backbone, end);
  drawing.polyline(tips, {.stroke = color, .width_px = 2.0, .dashed = true});
  drawing.legend(fmt::format("end that the {} model predicts; dashed: its tip's path",
                             network ? "network" : "no-load"),
                 end);
}

void draw_collision(SvgDrawing& drawing, const ArmDescription& arm, const Episode& episode,
                    const Contact& contact) {
  const auto later = std::lower_bound(episode.time_s.begin(), episode.time_s.end(), contact.time_s);
  const Eigen::Index frame =
      std::min<Eigen::Index>(later - episode.time_s.begin(), episode.time_s.size() - 1);
  const ShapeStyle style{.fill = kCollisionColor, .stroke = kCollisionColor, .opacity = 0.5};
  draw_arm(drawing, arm, recorded_backbone(episode, frame), style);
  drawing.legend(fmt::format("first collision, {:.2f} s", contact.time_s), style);
}

}  // namespace

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
  nlohmann::ordered_json motion = {{"frame_rate_hz", plan.frame_rate_hz},
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
