// A plan executed, open loop, on the virtual arm. Another arm needs an ArmDriver of its own.
//
//   05_execute PLAN.json ENVIRONMENT.yaml

#include <iostream>

#include "limber/common/data_folder.hpp"
#include "limber/hardware/executor.hpp"
#include "limber/hardware/virtual_arm.hpp"

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "05_execute PLAN.json ENVIRONMENT.yaml\n";
    return 2;
  }
  const limber::ArmDescription arm =
      limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::Environment environment = limber::load_environment(argv[2], arm);
  const limber::Plan plan = limber::read_plan(argv[1]);
  limber::VirtualArm virtual_arm(arm);
  const limber::ExecutionResult result = limber::execute(arm, environment, plan, virtual_arm);

  std::cout << limber::to_string(result.status) << ": " << result.frames << " frames, "
            << result.goal_error.position_m * 100.0 << " cm from the goal's centre"
            << (result.goal_reached ? ", reached" : ", not reached")
            << (result.collided ? ", collided" : "") << "\n";
  if (result.prediction) {
    std::cout << "the tip was " << result.prediction->mean_m * 100.0
              << " cm from its prediction on average\n";
  }
  return result.goal_reached && !result.collided ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
