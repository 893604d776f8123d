#include "limber/experiment/plan_trial.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "limber/hardware/execution_report.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/planning/plan_report.hpp"

namespace limber {

PlanTrial plan_trial(const ArmDescription& arm, const ForwardModel& model,
                     const EnvironmentCase& item, const PlanTrialSettings& settings,
                     std::uint64_t seed) {
  PlanTrial trial;
  trial.environment = item.id;
  trial.model = model.has_network() ? "network" : "no_load";
  trial.planner = settings.planner;
  trial.seed = seed;
  const PlanningProblem problem{arm, model, item.environment, settings.margin_m};
  trial.planning = make_planner(settings.planner)->plan(problem, settings.limits, seed);
  if (trial.planning.plan) {
    trial.planning.plan->model_hash = model.has_network() ? settings.model_hash : "";
  }
  return trial;
}

void execute_trial(const ArmDescription& arm, const Environment& environment, PlanTrial& trial) {
  if (trial.planning.plan) {
    VirtualArm driver(arm);
    trial.execution = execute(arm, environment, *trial.planning.plan, driver);
  }
}

namespace {

bool is_asked_for(const PlanTrial& trial, const std::string& environment,
                  const std::string& model) {
  return (environment.empty() || trial.environment == environment) &&
         (model.empty() || trial.model == model);
}

}  // namespace

TrialSummary summarise(const std::vector<PlanTrial>& trials, const std::string& environment,
                       const std::string& model) {
  TrialSummary sum;
  int executed = 0;
  int executed_free = 0;
  for (const PlanTrial& trial : trials) {
    const bool asked_for = is_asked_for(trial, environment, model);
    sum.trials += asked_for ? 1 : 0;
    if (!asked_for || !trial.solved()) {
      continue;
    }
    ++sum.solved;
    sum.mean_first_solution_s += trial.planning.first_solution->time_s;
    sum.mean_cost_kpa += trial.planning.plan->cost_kpa;
    if (trial.execution && trial.execution->status == ExecutionStatus::done) {
      ++executed;
      sum.mean_distance_m += trial.execution->goal_error.position_m;
      sum.mean_orientation_rad += trial.execution->goal_error.orientation_rad;
      sum.collided += trial.execution->collided ? 1 : 0;
      executed_free += trial.execution->collided ? 0 : 1;
      sum.mean_distance_free_m +=
          trial.execution->collided ? 0.0 : trial.execution->goal_error.position_m;
    }
  }
  sum.mean_first_solution_s /= std::max(1, sum.solved);
  sum.mean_cost_kpa /= std::max(1, sum.solved);
  sum.mean_distance_m /= std::max(1, executed);
  sum.mean_orientation_rad /= std::max(1, executed);
  sum.mean_distance_free_m /= std::max(1, executed_free);
  return sum;
}

const PlanTrial* cheapest_plan(const std::vector<PlanTrial>& trials, const std::string& environment,
                               const std::string& model) {
  const PlanTrial* best = nullptr;
  for (const PlanTrial& trial : trials) {
    if (is_asked_for(trial, environment, model) && trial.solved() &&
        (best == nullptr || trial.planning.plan->cost_kpa < best->planning.plan->cost_kpa)) {
      best = &trial;
    }
  }
  return best;
}

namespace {

nlohmann::ordered_json with_names(const PlanTrial& trial, const nlohmann::ordered_json& object) {
  nlohmann::ordered_json named = {
      {"environment", trial.environment}, {"model", trial.model}, {"seed", trial.seed}};
  named.update(object);
  return named;
}

}  // namespace

nlohmann::ordered_json planning_to_json(const PlanTrial& trial, const Environment& environment) {
  return with_names(trial, plan_result_to_json(trial.planning, environment.goal, trial.planner,
                                               trial.model, trial.seed));
}

nlohmann::ordered_json execution_to_json(const PlanTrial& trial, const Environment& environment) {
  return with_names(trial, execution_to_json(*trial.execution, environment));
}

}  // namespace limber
