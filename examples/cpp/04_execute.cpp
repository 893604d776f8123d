// A plan executed on the virtual arm: open loop, and planned again from where the arm is measured.
// Another arm needs an ArmDriver of its own.
//
//   04_execute PLAN.json ENVIRONMENT.yaml MODEL.safetensors

#include <iostream>

#include "limber/common/data_folder.hpp"
#include "limber/run/controller.hpp"
#include "limber/sim/virtual_arm.hpp"

void print(const std::string& how, const limber::ExecutionResult& result) {
  if (!result.final_backbone) {  // the arm was not tracked at the end
    std::cout << how << ": " << result.message << "\n";
    return;
  }
  std::cout << how << ": " << limber::to_string(result.status) << ", " << result.frames
            << " frames, " << result.goal_error.position_m * 100.0 << " cm from the goal's centre"
            << (result.goal_reached ? ", reached" : ", not reached")
            << (result.collided ? ", collided" : "") << ", planned again " << result.replans
            << " times\n";
}

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::cerr << "04_execute PLAN.json ENVIRONMENT.yaml MODEL.safetensors\n";
    return 2;
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::Environment environment = limber::load_environment(argv[2], arm);
  const limber::Plan plan = limber::read_plan(argv[1]);
  limber::VirtualArm virtual_arm(arm);
  const limber::ExecutionResult open_loop = limber::execute(arm, environment, plan, virtual_arm);
  print("open loop", open_loop);
  if (open_loop.prediction) {
    std::cout << "the tip was " << open_loop.prediction->mean_m * 100.0
              << " cm from its prediction on average\n";
  }

  const limber::CompensationModel network = limber::read_model(argv[3]);
  const limber::ForwardModel forward(arm, network);
  const limber::ValveParameters valves = network.valves.value_or(limber::ValveParameters{});
  const limber::MotionModel model(forward, limber::ValveModel(arm, valves));
  const auto loop =
      limber::make_closed_loop(arm, model, environment, limber::error_room(forward), 1);
  limber::VirtualArm again(arm);
  limber::ExecutionSettings settings;
  settings.controller = loop.get();
  const auto closed_loop = limber::execute(arm, environment, plan, again, settings);
  print("closed loop", closed_loop);
  return limber::has_arrived(closed_loop) ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
