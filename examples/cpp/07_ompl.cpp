// A planner of the Open Motion Planning Library on limber's model, beside limber's own. It needs a
// limber that was built with libompl-dev.
//
//   07_ompl MODEL.safetensors ENVIRONMENT.yaml [PLANNER]

#include <iostream>

#include "limber/common/data_folder.hpp"
#include "limber/planning/planner_factory.hpp"

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "07_ompl MODEL.safetensors ENVIRONMENT.yaml [PLANNER]\n";
    return 2;
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::Environment environment = limber::load_environment(argv[2], arm);
  for (const std::string& name :
       {std::string("default"), std::string(argc > 3 ? argv[3] : "ompl:RRT")}) {
    limber::PlanSettings settings;
    settings.planner = name;
    const auto result = limber::plan(arm, argv[1], environment, {.time_s = 5.0}, 1, settings);
    if (result.plan) {
      std::cout << name << ": " << result.plan->cost_kpa << " kPa, certified after "
                << result.first_solution->time_s << " s and " << result.first_solution->queries
                << " queries\n";
    } else {
      std::cout << name << ": no plan: " << result.reason << "\n";
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
