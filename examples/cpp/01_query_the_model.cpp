// Where does the arm go, says a network, when the first segment is inflated for two seconds?
//
//   01_query_the_model MODEL.safetensors [KPA]

#include <charconv>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "limber/arm/arm_description.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/world/environment.hpp"

double number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  if (error != std::errc() || end != text.end()) {
    throw std::invalid_argument("'" + std::string(text) + "' is not a number");
  }
  return value;
}

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::cerr << "01_query_the_model MODEL.safetensors [KPA]\n";
    return 2;
  }
  const limber::ArmDescription arm =
      limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::ForwardModel forward(arm, limber::read_model(argv[1]));
  const limber::ValveParameters valves =
      forward.compensation().valves.value_or(limber::ValveParameters{});
  const limber::MotionModel model(forward, limber::ValveModel(arm, valves));

  const limber::ArmStart rest = limber::start_state(limber::Environment{}, arm);
  limber::MotionState state = model.settled_state(rest.pressures_kpa, rest.backbone);
  limber::MotionModel::Workspace workspace;
  limber::Pressures setpoint_kpa = rest.pressures_kpa;
  setpoint_kpa[0] = argc > 2 ? static_cast<float>(number(argv[2])) : 60.0F;
  const int frames = arm.frames_in(2.0);
  for (int frame = 1; frame <= frames; ++frame) {
    model.step(setpoint_kpa, state, workspace);
    if (frame % 10 == 0) {
      const limber::Pose tip = limber::tip_pose(state.backbone);
      std::cout << frame * arm.frame_period_s() << " s: tip at (" << tip.x_m << ", " << tip.y_m
                << ") m, " << tip.theta_rad << " rad, segment 0 at " << state.pressure_kpa()[0]
                << " kPa\n";
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
