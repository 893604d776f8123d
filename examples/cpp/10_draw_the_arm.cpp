// Draws the arm's shape at given pressures as an SVG picture.
//
//   10_draw_the_arm PICTURE.svg [PRESSURE_KPA…]

#include <charconv>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/plot/svg_drawing.hpp"

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::cerr << "usage: 10_draw_the_arm PICTURE.svg [PRESSURE_KPA…]\n";
    return 2;
  }
  const limber::ArmDescription arm =
      limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::NoLoadModel model(arm);

  Eigen::VectorXd pressures_kpa = Eigen::VectorXd::Constant(model.segment_count(), 30.0);
  for (int i = 0; i < pressures_kpa.size() && i + 2 < argc; ++i) {
    const std::string_view text = argv[i + 2];
    if (std::from_chars(text.begin(), text.end(), pressures_kpa[i]).ptr != text.end()) {
      throw std::invalid_argument("'" + std::string(text) + "' is not a number");
    }
  }
  limber::BackboneD backbone(model.point_count(), 3);
  model.backbone(pressures_kpa, backbone);

  std::vector<limber::WorldPoint> points;
  for (int i = 0; i < model.point_count(); ++i) {
    points.push_back({backbone(i, 0), backbone(i, 1)});
  }
  std::vector<double> radii_m;
  for (int gap = 0; gap + 1 < model.point_count(); ++gap) {
    const limber::Segment& segment = model.segment(arm.segment_of_gap(gap));
    radii_m.push_back(segment.width_m / 2.0 + arm.actuator_radius_m);
  }
  const double reach_m = 1.05 * arm.length_m();
  limber::SvgDrawing drawing({-0.2 * reach_m, reach_m, -reach_m, reach_m}, 560.0, arm.name);
  drawing.axes();
  drawing.capsule_chain(points, radii_m, {.fill = limber::palette_color(limber::kNoLoadColor)});
  drawing.polyline(points, {.stroke = "#ffffff", .width_px = 1.5});
  limber::write_file_atomically(argv[1], drawing.svg());
  std::cout << argv[1] << "\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
