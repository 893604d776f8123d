#include "limber/report/trial_report.hpp"

#include <nlohmann/json.hpp>

#include "limber/report/execution_report.hpp"
#include "limber/report/plan_report.hpp"

namespace limber {

namespace {

nlohmann::ordered_json with_names(const PlanTrial& trial, const nlohmann::ordered_json& object) {
  nlohmann::ordered_json named = {
      {"environment", trial.environment}, {"model", trial.model}, {"seed", trial.seed}};
  named.update(object);
  return named;
}

}  // namespace

nlohmann::ordered_json planning_to_json(const PlanTrial& trial, const Environment& environment) {
  const Command pressures;  // trials are those of the virtual arm
  return with_names(trial, to_json(trial.planning, pressures, environment.goal, trial.planner,
                                   trial.model, trial.seed));
}

nlohmann::ordered_json execution_to_json(const PlanTrial& trial, const Environment& environment) {
  return with_names(trial, to_json(*trial.execution, environment));
}

}  // namespace limber
