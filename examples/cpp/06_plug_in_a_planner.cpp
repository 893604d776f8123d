// A planner of your own: it says where the set points go, limber simulates, holds and certifies the
// motion. This one climbs: it changes the best motion so far, and keeps what is nearer to a plan.
//
//   06_plug_in_a_planner MODEL.safetensors ENVIRONMENT.yaml PLAN.json
//
// The model may be your own too: ../python/08_train_in_pytorch.py trains one in PyTorch, and
// ../python/model_file.py writes any network's weights as such a file.

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "limber/common/data_folder.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/planning/planner_factory.hpp"

constexpr int kTries = 2000;
constexpr double kSpread = 0.2;  // of the limits: how far a try is from the best so far

limber::PlanResult climb(const limber::PlanningProblem& problem, std::uint64_t seed) {
  // How far a motion ends from the goal, and how deep it goes into obstacles.
  const auto off_m = [](const auto& p) { return p.goal_distance_m - std::min(p.clearance_m, 0.0); };
  limber::RandomStream random(seed, 0);  // seed, stream
  std::vector best_kpa(2, limber::Pressures::Zero(problem.arm.segment_count()).eval());
  limber::PlanResult best = limber::plan_along(problem, best_kpa, "climber", seed);
  for (int i = 0; i < kTries && best.status == limber::PlanStatus::not_certified; ++i) {
    std::vector kpa = best_kpa;  // over one waypoint to another
    for (limber::Pressures& waypoint : kpa) {
      for (int s = 0; s < waypoint.size(); ++s) {
        const auto limits = problem.arm.segments[static_cast<std::size_t>(s)].pressure_limit_kpa;
        const double change_kpa = kSpread * limits.half_width_kpa() * random.normal();
        waypoint[s] = float(limits.clamped(waypoint[s] + change_kpa));
      }
    }
    limber::PlanResult tried = limber::plan_along(problem, kpa, "climber", seed);
    if (tried.plan || off_m(*tried.best_partial) < off_m(*best.best_partial)) {
      best_kpa = kpa;
      best = std::move(tried);
    }
  }
  return best;
}

int main(int argc, char** argv) try {
  if (argc < 4) {
    throw std::invalid_argument("06_plug_in_a_planner MODEL.safetensors ENVIRONMENT PLAN.json");
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::ForwardModel forward(arm, limber::read_model(argv[1]));
  const auto result = climb({arm, forward, limber::load_environment(argv[2], arm)}, 1);
  if (!result.plan) {
    std::cout << "no plan: " << result.reason << "\n";
    return 1;
  }
  limber::write_plan(argv[3], *result.plan);
  std::cout << argv[3] << ": " << result.plan->cost_kpa << " kPa, certified\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
