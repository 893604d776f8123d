// Which pressures bring the end effector to a place, where nothing rubs or pulls?
//
//   09_reach_a_pose [X_M Y_M]

#include <charconv>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/inverse_kinematics.hpp"

double number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  if (error != std::errc() || end != text.end()) {
    throw std::invalid_argument("'" + std::string(text) + "' is not a number");
  }
  return value;
}

int main(int argc, char** argv) try {
  const limber::ArmDescription arm =
      limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::NoLoadModel model(arm);

  limber::PoseGoal goal;
  goal.x_m = argc > 2 ? number(argv[1]) : 0.45;
  goal.y_m = argc > 2 ? number(argv[2]) : 0.30;

  limber::RandomStream random(1, 0);  // seed, stream
  const limber::InverseKinematicsResult result =
      limber::solve_inverse_kinematics(model, goal, {}, random);
  if (!result.reachable()) {
    std::cout << result.reason << "\n";
    return 1;
  }
  std::cout << "pressures [kPa], base first, and the tip they lead to [m, m, rad]:\n";
  for (const Eigen::VectorXd& pressures_kpa : result.pressures_kpa) {
    limber::BackboneD backbone(model.point_count(), 3);
    model.backbone(pressures_kpa, backbone);
    std::cout << pressures_kpa.transpose() << "  ->  " << backbone.bottomRows(1) << "\n";
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
