#include "limber/report/final_shapes_picture.hpp"

#include "limber/plot/svg_drawing.hpp"
#include "limber/report/plan_picture.hpp"

namespace limber {

namespace {

constexpr int kNoLoadColor = 0;
constexpr int kNetworkColor = 1;

ShapeStyle body_style(const std::string& model) {
  ShapeStyle style;
  style.fill = palette_color(model == "network" ? kNetworkColor : kNoLoadColor);
  style.stroke = "none";
  style.opacity = 0.35;
  return style;
}

void draw_center_line(SvgDrawing& drawing, const Backbone& backbone, const PlanTrial& trial) {
  std::vector<WorldPoint> points;
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    points.push_back({backbone(i, 0), backbone(i, 1)});
  }
  ShapeStyle style;
  style.fill = "none";
  style.stroke = palette_color(trial.model == "network" ? kNetworkColor : kNoLoadColor);
  style.dashed = trial.execution->collided;
  drawing.polyline(points, style);
}

}  // namespace

std::string final_shapes_picture(const ArmDescription& arm, const EnvironmentCase& item,
                                 const std::vector<PlanTrial>& trials) {
  SvgDrawing drawing(picture_box(arm, item.environment), 560.0, item.environment.name);
  drawing.axes();
  for (const PlanTrial& trial : trials) {
    if (trial.environment == item.id && trial.execution && trial.execution->final_backbone) {
      draw_arm(drawing, arm, *trial.execution->final_backbone, body_style(trial.model));
      draw_center_line(drawing, *trial.execution->final_backbone, trial);
    }
  }
  draw_environment(drawing, item.environment);
  drawing.legend("no-load plans", body_style("no_load"));
  drawing.legend("network plans", body_style("network"));
  return drawing.svg();
}

}  // namespace limber
