#include "limber/trial/proven_environment.hpp"

#include "limber/common/interrupt.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/hardware/executor.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/trial/random_environment.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

constexpr int kSamples = 100;
constexpr std::uint64_t kNextSample = 1'000'000;  // between the numbers of an environment's samples

bool is_proven(const ArmDescription& arm, const MotionModel& model,
               const RandomEnvironment& sampled) {
  const CollisionChecker checker(arm, sampled.environment.obstacles);
  MotionSimulator simulator(arm, model, checker);
  const PlanningProblem problem{arm, model, sampled.environment, 0.0};
  const Plan plan = build_plan(problem, simulator, sampled.witness_kpa, "witness", 0);
  VirtualArm driver(arm);
  const ExecutionResult run = execute(arm, sampled.environment, plan, driver);
  return run.goal_reached && !run.collided;
}

}  // namespace

std::optional<Environment> sample_proven_environment(const ArmDescription& arm,
                                                     const MotionModel& model, std::uint64_t seed,
                                                     std::uint64_t number) {
  for (int k = 0; k < kSamples; ++k) {
    throw_if_interrupted();
    const std::optional<RandomEnvironment> sampled =
        random_environment(arm, model, seed, number + std::uint64_t(k) * kNextSample);
    if (sampled && is_proven(arm, model, *sampled)) {
      Environment environment = sampled->environment;
      environment.name = "random " + std::to_string(number) + " of seed " + std::to_string(seed);
      return environment;
    }
  }
  return std::nullopt;
}

}  // namespace limber
