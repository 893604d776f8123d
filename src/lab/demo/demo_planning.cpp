// The demo's stages from the trained model to executed plans.

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "demo_recipe.hpp"
#include "demo_stages.hpp"
#include "kernels/job_arena.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/report/shapes_page.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kPlanSeed = 128;
constexpr std::size_t kDrawnEdges = 3000;  // of the tree; more would weigh the page down

/// Those of the recipe; another arm than the paper's gets random ones.
std::vector<EnvironmentCase> choose_environments(const DemoResults& results) {
  std::vector<EnvironmentCase> own = own_environments(results.arm());
  if (own.empty()) {
    return random_environments(results, results.recipe.random_environments);
  }
  const std::vector<std::string>& wanted = results.recipe.environments;
  std::erase_if(own, [&](const EnvironmentCase& item) {
    return std::ranges::find(wanted, item.id) == wanted.end();
  });
  return own;
}

/// Every trial of every environment with both models, in the order of DemoResults::trials.
struct TrialTask {
  const EnvironmentCase* environment;
  const ForwardModel* model;
  int number;
};

std::vector<TrialTask> all_tasks(const DemoResults& results) {
  std::vector<TrialTask> tasks;
  for (const EnvironmentCase& environment : results.environments) {
    for (const ForwardModel* model : {&*results.no_load, &*results.network}) {
      for (int k = 0; k < results.recipe.plans_per_environment; ++k) {
        tasks.push_back({&environment, model, k});
      }
    }
  }
  return tasks;
}

/// The network's in that environment; null: none was solved.
const PlanTrial* cheapest_plan(const std::vector<PlanTrial>& trials,
                               const std::string& environment) {
  const PlanTrial* best = nullptr;
  for (const PlanTrial& trial : trials) {
    if (trial.environment == environment && trial.model == "network" && trial.solved() &&
        (best == nullptr || trial.planning.plan->cost_kpa < best->planning.plan->cost_kpa)) {
      best = &trial;
    }
  }
  return best;
}

}  // namespace

MotionModel DemoResults::motion_model(const ForwardModel& forward) const {
  return {forward, ValveModel(arm(), network->compensation().identified_valves().parameters)};
}

const Environment& DemoResults::environment(const std::string& id) const {
  const auto found = std::ranges::find(environments, id, &EnvironmentCase::id);
  assert(found != environments.end());
  return found->environment;
}

void plan_stage(DemoResults& results) {
  results.environments = choose_environments(results);
  for (const EnvironmentCase& item : results.environments) {
    results.output->write("environments/" + item.id + ".yaml",
                          environment_to_yaml(item.environment));
  }
  PlanTrialSettings settings;
  settings.limits.time_s = results.recipe.planning_time_limit_s;
  settings.model_hash = results.model_hash;
  const std::vector<TrialTask> tasks = all_tasks(results);
  results.trials.resize(tasks.size());
  Progress progress("planning", "plans", tasks.size(), results.settings->progress);
  JobArena arena(results.settings->jobs);
  arena.for_each(tasks.size(), [&](std::size_t i) {
    const TrialTask& task = tasks[i];
    const std::uint64_t seed =
        derived_seed(results.settings->seed, kPlanSeed + std::uint64_t(task.number));
    if (!interrupt_requested()) {
      results.trials[i] = plan_trial(results.arm(), results.motion_model(*task.model),
                                     *task.environment, settings, seed);
    }
    progress.advance();
  });
  progress.finish();
  throw_if_interrupted();
  for (const PlanTrial& trial : results.trials) {
    if (trial.planning.plan) {
      const std::string name =
          fmt::format("plans/{}_{}_{}.json", trial.environment, trial.model, trial.seed);
      results.output->write_with({name},
                                 [&] { write_plan(results.file(name), *trial.planning.plan); });
    }
  }
}

void execute_stage(DemoResults& results) {
  JobArena arena(results.settings->jobs);
  arena.for_each(results.trials.size(), [&](std::size_t i) {
    PlanTrial& trial = results.trials[i];
    execute_trial(results.arm(), results.environment(trial.environment), trial);
  });
  throw_if_interrupted();
  for (const EnvironmentCase& item : results.environments) {
    const auto add = [&](const std::string& kind, std::string svg, const std::string& caption) {
      results.output->write(fmt::format("plots/{}_{}.svg", kind, item.id), svg);
      results.plan_pictures.push_back({std::move(svg), item.environment.name + ": " + caption});
    };
    const PlanTrial* best = cheapest_plan(results.trials, item.id);
    if (best != nullptr) {
      PlanResult drawn = best->planning;
      drawn.tree.resize(std::min(drawn.tree.size(), kDrawnEdges));
      add("planned", plan_picture(results.arm(), item.environment, drawn),
          "the cheapest plan of the network model, its shapes from faint to full, and the tree");
    }
    add("executed", final_shapes_picture(results.arm(), item, results.trials),
        "where the arm ended, executing plans of the no-load and the network model");
  }
}

}  // namespace limber
