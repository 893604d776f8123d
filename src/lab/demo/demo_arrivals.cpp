// What more planning time does to plans on the arm: the network's plans, executed open loop, in
// environments that its other plans did not choose.
#include "demo_arrivals.hpp"

#include <fmt/format.h>

#include "demo_recipe.hpp"
#include "kernels/job_arena.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kArrivalSeed = 192;
constexpr double kFirstPlanLimit_s = 10.0;
constexpr double kAnyCostKpa = 1e12;  // the first plan is cheap enough

struct Group {
  std::string name;
  std::vector<EnvironmentCase> environments;
};

std::vector<Group> groups_of(const DemoResults& results) {
  std::vector<Group> groups;
  if (std::vector<EnvironmentCase> own = own_environments(results.arm()); !own.empty()) {
    groups.push_back({"limber's own", std::move(own)});
  }
  if (results.recipe.arrival_random_environments > 0) {
    groups.push_back(
        {"random", random_environments(results, results.recipe.arrival_random_environments)});
  }
  return groups;
}

PlannerLimits limits_of(double planning_time_s) {
  PlannerLimits limits;
  limits.time_s = planning_time_s;
  if (planning_time_s == kFirstPlan) {
    limits.time_s = kFirstPlanLimit_s;
    limits.cost_threshold_kpa = kAnyCostKpa;
  }
  return limits;
}

/// What one plan came to; all that is kept of it.
struct Outcome {
  bool solved = false;
  bool arrived = false;
  bool collided = false;
  std::optional<double> distance_cm;
};

Outcome plan_and_execute(const DemoResults& results, const EnvironmentCase& item,
                         double planning_time_s) {
  PlanTrialSettings settings;
  settings.limits = limits_of(planning_time_s);
  PlanTrial trial = plan_trial(results.arm(), results.motion_model(*results.network), item,
                               settings, derived_seed(results.settings->seed, kArrivalSeed));
  execute_trial(results.arm(), item.environment, trial);
  Outcome outcome;
  outcome.solved = trial.solved();
  if (trial.execution) {
    outcome.arrived = has_arrived(*trial.execution);
    outcome.collided = trial.execution->collided;
    if (trial.execution->final_backbone) {
      outcome.distance_cm = trial.execution->goal_error.position_m * kCmPerM;
    }
  }
  return outcome;
}

Arrivals summarised(const Group& group, double planning_time_s,
                    const std::vector<Outcome>& outcomes) {
  Arrivals row;
  row.environments = group.name;
  row.planning_time_s = planning_time_s;
  row.plans = int(outcomes.size());
  std::vector<double> distances_cm;
  for (const Outcome& outcome : outcomes) {
    row.solved += outcome.solved ? 1 : 0;
    row.arrived += outcome.arrived ? 1 : 0;
    row.collided += outcome.collided ? 1 : 0;
    if (outcome.distance_cm) {
      distances_cm.push_back(*outcome.distance_cm);
    }
  }
  row.distance_cm = figures_of(std::move(distances_cm));
  return row;
}

std::string planning_time(const Arrivals& row) {
  return row.planning_time_s == kFirstPlan ? "first plan"
                                           : fmt::format("{:g} s", row.planning_time_s);
}

}  // namespace

void arrival_stage(DemoResults& results) {
  const std::vector<Group> groups = groups_of(results);
  const std::vector<double>& times_s = results.recipe.arrival_times_s;
  const auto plans = sum_of<std::size_t>(
      groups, [&](const Group& group) { return group.environments.size() * times_s.size(); });
  Progress progress("planning time", "plans", plans, results.settings->progress);
  JobArena arena(results.settings->jobs);
  for (const Group& group : groups) {
    for (const double time_s : times_s) {
      std::vector<Outcome> outcomes(group.environments.size());
      arena.for_each(outcomes.size(), [&](std::size_t i) {
        if (!interrupt_requested()) {
          outcomes[i] = plan_and_execute(results, group.environments[i], time_s);
        }
        progress.advance();
      });
      throw_if_interrupted();
      results.arrivals.push_back(summarised(group, time_s, outcomes));
    }
  }
  progress.finish();
}

ReportTable arrivals_table(const std::vector<Arrivals>& rows) {
  ReportTable table{
      "The network's plans over planning time, executed open loop; distances to the goal's centre "
      "are of all runs, mean ± standard error",
      {"environments", "planning", "solved", "arrive", "collide", "distance [cm]"}};
  for (const Arrivals& row : rows) {
    const SampleFigures& distance = row.distance_cm;
    table.rows.push_back(
        {row.environments, planning_time(row), fmt::format("{}/{}", row.solved, row.plans),
         std::to_string(row.arrived), std::to_string(row.collided),
         distance.standard_error
             ? fmt::format("{:.2f} ± {:.2f}", *distance.mean, *distance.standard_error)
             : "–"});
  }
  return table;
}

Json arrivals_to_json(const std::vector<Arrivals>& rows) {
  return mapped<Json>(rows, [&](const Arrivals& row) {
    return Json{{"environments", row.environments},
                {"first_plan", row.planning_time_s == kFirstPlan},
                {"time_limit_s", *limits_of(row.planning_time_s).time_s},
                {"plans", row.plans},
                {"solved", row.solved},
                {"arrived", row.arrived},
                {"collided", row.collided},
                {"mean_distance_to_goal_cm", optional_json(row.distance_cm.mean)},
                {"standard_error_cm", optional_json(row.distance_cm.standard_error)}};
  });
}

}  // namespace limber
