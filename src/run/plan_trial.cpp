#include "limber/run/plan_trial.hpp"

#include "limber/common/statistics.hpp"

namespace limber {

namespace {

std::optional<double> mean_of(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

bool is_asked_for(const PlanTrial& trial, const std::string& environment,
                  const std::string& model) {
  return (environment.empty() || trial.environment == environment) &&
         (model.empty() || trial.model == model);
}

}  // namespace

TrialSummary summarise(const std::vector<PlanTrial>& trials, const std::string& environment,
                       const std::string& model) {
  TrialSummary sum;
  std::vector<double> first_solution_s, first_candidate_s, first_certificate_s;
  std::vector<double> cost_kpa, distance_m, distance_free_m, orientation_rad;
  for (const PlanTrial& trial : trials) {
    if (!is_asked_for(trial, environment, model)) {
      continue;
    }
    ++sum.trials;
    if (trial.solved()) {
      ++sum.solved;
      const FirstSolution& first = *trial.planning.first_solution;
      first_solution_s.push_back(first.time_s);
      first_candidate_s.push_back(first.candidate_s);
      first_certificate_s.push_back(first.certificate_s);
      cost_kpa.push_back(trial.planning.plan->cost_kpa);
    }
    if (!trial.execution || !has_run(*trial.execution)) {
      continue;
    }
    const ExecutionResult& run = *trial.execution;
    ++sum.executed;
    sum.collided += run.collided ? 1 : 0;
    sum.reached += has_arrived(run) ? 1 : 0;
    if (!run.final_backbone) {
      continue;
    }
    distance_m.push_back(run.goal_error.position_m);
    if (!run.collided) {
      distance_free_m.push_back(run.goal_error.position_m);
    }
    if (trial.asks_heading) {
      orientation_rad.push_back(run.goal_error.orientation_rad);
    }
  }
  sum.first_solution_s = mean_of(first_solution_s);
  sum.first_candidate_s = mean_of(first_candidate_s);
  sum.first_certificate_s = mean_of(first_certificate_s);
  sum.cost_kpa = mean_of(cost_kpa);
  sum.distance_m = mean_of(distance_m);
  sum.distance_free_m = mean_of(distance_free_m);
  sum.orientation_rad = mean_of(orientation_rad);
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

}  // namespace limber
