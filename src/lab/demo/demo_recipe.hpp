#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/run/schedule.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

struct DemoResults;

/// All of limber's own environments, by name; they are drawn up for the paper's arm, so none for
/// another one.
std::vector<EnvironmentCase> own_environments(const ArmDescription& arm);

/// Environments 1 to `count` of that seed about motions of that virtual arm, "random_1" and so on.
/// @throws InputError for an arm that hardly moves.
std::vector<EnvironmentCase> random_environments(const ArmDescription& arm, std::uint64_t seed,
                                                 int count);

/// Those of the run's own arm and seed.
std::vector<EnvironmentCase> random_environments(const DemoResults& results, int count);

/// A planning time that ends with the first certified plan.
inline constexpr double kFirstPlan = 0.0;

/// How much `limber demo` does of everything: the choices that decide its time and its figures.
struct DemoRecipe {
  /// Recorded one after another and joined; schedule k is sampled by its own seed.
  std::vector<ScheduleSettings> training_schedules;
  ScheduleSettings validation_schedule;
  /// Motions like those of plans, used neither for training nor for choosing: the model's error is
  /// measured on them.
  ScheduleSettings unseen_schedule;
  ScheduleSettings test_schedule;  ///< one unbroken episode, never trained on
  TrainingSettings training;
  /// Goes on from limber's family, where it has one, adapted to a minute of the arm.
  bool starts_from_family = false;
  std::int64_t bench_queries = 1000000;
  std::vector<std::string> environments;  ///< names of files in environments/; for the paper's arm
  int random_environments = 3;            ///< for any other arm, for which none are drawn up
  int plans_per_environment = 3;          ///< of each model, each by its own seed
  /// At most: improvement ends by queries, mostly long before.
  double planning_time_limit_s = 5.0;
  /// Limits of plans that show what more time is good for [s], kFirstPlan: to the first plan.
  std::vector<double> arrival_times_s = {kFirstPlan, 0.1, 1.0, 10.0};
  int arrival_random_environments = 20;  ///< beside limber's own
  int other_arms = 5;                    ///< that limber's family is adapted to
  ScheduleSettings other_arm_test_schedule;
};

/// Everything, in under six minutes on two cores.
DemoRecipe full_recipe(const ArmDescription& arm);
/// The same chain in about a minute: little data, and a network that goes on from limber's family.
DemoRecipe quick_recipe(const ArmDescription& arm);

/// Seed of part `index` of a run, so that no two parts share random numbers.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t index);

}  // namespace limber
