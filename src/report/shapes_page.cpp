#include "limber/report/shapes_page.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "animation.hpp"
#include "limber/common/json.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/report/plan_picture.hpp"

namespace limber {

namespace {

ShapeStyle body_style(const std::string& model) {
  return {.fill = model_color(model), .stroke = "none", .opacity = 0.35};
}

constexpr double kPlaceUnitM = 1e-4;  // below a pixel
constexpr Eigen::Index kMaxShownFrames = 2000;

Json places_of(const FrameMatrix& backbones, const Episode& recorded, Eigen::Index frames) {
  Json all = Json::array();
  for (Eigen::Index t = 0; t < frames; ++t) {
    if (!backbones.row(t).allFinite()) {
      all.push_back(t > 0 ? all.back() : places_of(recorded.backbone, recorded, 1).front());
      continue;
    }
    const FrameMatrix places = places_at(backbones, t, Dimension::space);
    all.push_back(std::vector<float>(places.data(), places.data() + places.size()));
  }
  return all;
}

/// Frames of which nothing is known: not seen, or not predicted.
Json unknown_frames(const FrameMatrix& backbones, const Episode& recorded, Eigen::Index frames) {
  Json unknown = Json::array();
  for (Eigen::Index t = 0; t < frames; ++t) {
    const bool is_seen = &backbones != &recorded.backbone || recorded.was_tracked(int(t));
    if (!is_seen || !backbones.row(t).allFinite()) {
      unknown.push_back(t);
    }
  }
  return unknown;
}

}  // namespace

std::string final_shapes_picture(const ArmDescription& arm, const EnvironmentCase& item,
                                 const std::vector<PlanTrial>& trials) {
  SvgDrawing drawing(picture_box(arm, item.environment), 560.0, item.environment.name);
  drawing.axes();
  std::set<std::string> shown;
  for (const PlanTrial& trial : trials) {
    if (trial.environment == item.id && trial.execution && trial.execution->final_backbone) {
      draw_arm(drawing, arm, *trial.execution->final_backbone, body_style(trial.model));
      drawing.polyline(center_line(*trial.execution->final_backbone),
                       {.stroke = model_color(trial.model), .dashed = trial.execution->collided});
      shown.insert(trial.model);
    }
  }
  draw_environment(drawing, item.environment);
  if (shown.contains("no_load")) {
    drawing.legend("no-load plans", body_style("no_load"));
  }
  if (shown.contains("network")) {
    drawing.legend("network plans", body_style("network"));
  }
  return drawing.svg();
}

std::string shapes_page(const std::string& title, const ArmDescription& arm, const Episode& episode,
                        const std::vector<ShownShapes>& predicted, const std::string& still) {
  const Eigen::Index frames = std::min<Eigen::Index>(episode.frame_count(), kMaxShownFrames);
  Json data = {{"frame_rate_hz", arm.frame_rate_hz},
               {"plates", episode.point_count()},
               {"length_m", arm.length_m()},
               {"gravity", {arm.gravity.x(), arm.gravity.y(), arm.gravity.z()}},
               {"unit_m", kPlaceUnitM},
               {"tracks", Json::array()}};
  std::vector<ShownShapes> shown = {{"recorded", "--virtual_arm", &episode.backbone}};
  shown.insert(shown.end(), predicted.begin(), predicted.end());
  for (const auto& [name, color, backbones] : shown) {
    const Json places = places_of(*backbones, episode, frames);
    data["tracks"].push_back({{"name", name},
                              {"color", color},
                              {"places", packed_frames(places, {kPlaceUnitM})},
                              {"unknown", unknown_frames(*backbones, episode, frames)}});
  }
  std::string notes;
  if (predicted.size() > 1) {
    notes = "<li>The network starts from the first recorded shape and is never corrected.</li>";
  }
  notes +=
      fmt::format("<li>The first {:.0f} s of {:.0f} s.</li>", double(frames) * arm.frame_period_s(),
                  double(episode.frame_count()) * arm.frame_period_s());
  return scripted_page("/assets/shapes.js", title, still, notes, data);
}

}  // namespace limber
