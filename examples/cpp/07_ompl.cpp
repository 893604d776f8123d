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
  const limber::ForwardModel forward(arm, limber::read_model(argv[1]));
  const limber::MotionModel model(forward);  // pressures are the set points
  const limber::PlanningProblem problem{arm, model, environment, 0.005};
  limber::PlannerLimits limits;
  limits.time_s = 5.0;
  for (const std::string& name :
       {std::string("default"), std::string(argc > 3 ? argv[3] : "ompl:RRT")}) {
    const limber::PlanResult result = limber::make_planner(name)->plan(problem, limits, 1);
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
