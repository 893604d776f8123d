#include "limber/run/plan_trial.hpp"

namespace limber {

namespace {

class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  std::optional<double> value() const {
    return count_ > 0 ? std::optional<double>(sum_ / count_) : std::nullopt;
  }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

bool is_asked_for(const PlanTrial& trial, const std::string& environment,
                  const std::string& model) {
  return (environment.empty() || trial.environment == environment) &&
         (model.empty() || trial.model == model);
}

}  // namespace

TrialSummary summarise(const std::vector<PlanTrial>& trials, const std::string& environment,
                       const std::string& model) {
  TrialSummary sum;
  Mean first_solution_s, first_candidate_s, first_certificate_s;
  Mean cost_kpa, distance_m, distance_free_m, orientation_rad;
  for (const PlanTrial& trial : trials) {
    if (!is_asked_for(trial, environment, model)) {
      continue;
    }
    ++sum.trials;
    if (trial.solved()) {
      ++sum.solved;
      const FirstSolution& first = *trial.planning.first_solution;
      first_solution_s.add(first.time_s);
      first_candidate_s.add(first.candidate_s);
      first_certificate_s.add(first.certificate_s);
      cost_kpa.add(trial.planning.plan->cost_kpa);
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
    distance_m.add(run.goal_error.position_m);
    if (!run.collided) {
      distance_free_m.add(run.goal_error.position_m);
    }
    if (trial.asks_heading) {
      orientation_rad.add(run.goal_error.orientation_rad);
    }
  }
  sum.first_solution_s = first_solution_s.value();
  sum.first_candidate_s = first_candidate_s.value();
  sum.first_certificate_s = first_certificate_s.value();
  sum.cost_kpa = cost_kpa.value();
  sum.distance_m = distance_m.value();
  sum.distance_free_m = distance_free_m.value();
  sum.orientation_rad = orientation_rad.value();
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
