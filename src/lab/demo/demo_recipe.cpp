#include "demo_recipe.hpp"

#include <fmt/format.h>

#include "demo_stages.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/witnessed_environment.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kEnvironmentSeed = 64;
constexpr const char* kPaperArm = "three_segment";

constexpr int kMotionsPerEpisode = 50;
constexpr int kQuickEpochs = 60;  // of an arm without a family
constexpr std::uint64_t kSeedStream =
    0x64656d6f;  // apart from the streams that use a seed as it is

ScheduleSettings transitions(const ArmDescription& arm, int most) {
  int configurations = 1;
  for (int i = 0; i < arm.channel_count() && configurations <= most; ++i) {
    configurations *= 3;
  }
  // Up to three segments every transition is recorded; above, there are too many.
  return {.kind = ScheduleKind::transitions,
          .count = arm.channel_count() <= 3 && configurations * configurations <= most ? 0 : most};
}

ScheduleSettings random(int motions, Approach approach) {
  const int episodes = (motions + kMotionsPerEpisode - 1) / kMotionsPerEpisode;
  return {.kind = ScheduleKind::random,
          .count = motions / episodes,
          .episodes = episodes,
          .approach = approach};
}

/// Motions like those of a plan: straight in pressure, cut short.
ScheduleSettings plan_like(int motions) {
  ScheduleSettings schedule = random(motions, Approach::straight);
  schedule.hold_s = 1.5;
  schedule.hold_min_s = 0.05;
  return schedule;
}

ScheduleSettings one_episode(int motions) {
  return {.kind = ScheduleKind::random, .count = motions, .episodes = 1};
}

/// Straight in pressure, as a plan's motions are: the error that plans keep room for is theirs.
ScheduleSettings unseen_motions(int count) {
  return {
      .kind = ScheduleKind::random, .count = count, .episodes = 1, .approach = Approach::straight};
}

}  // namespace

std::vector<EnvironmentCase> own_environments(const ArmDescription& arm) {
  return arm.name == kPaperArm ? environments_in(data_folder() / "environments", arm)
                               : std::vector<EnvironmentCase>{};
}

std::vector<EnvironmentCase> random_environments(const ArmDescription& arm, std::uint64_t seed,
                                                 int count) {
  std::vector<EnvironmentCase> cases;
  for (int k = 1; k <= count; ++k) {
    throw_if_interrupted();
    std::optional<WitnessedEnvironment> sampled =
        witnessed_environment(arm, virtual_witness(arm), seed, std::uint64_t(k));
    refuse_if(!sampled, "arm '{}': its tip comes nowhere in a hundred random motions", arm.name);
    cases.push_back({fmt::format("random_{}", k), std::move(sampled->environment)});
  }
  return cases;
}

std::vector<EnvironmentCase> random_environments(const DemoResults& results, int count) {
  return random_environments(results.arm(), derived_seed(results.settings->seed, kEnvironmentSeed),
                             count);
}

DemoRecipe full_recipe(const ArmDescription& arm) {
  DemoRecipe recipe;
  recipe.training_schedules = {transitions(arm, 729), random(2000, Approach::step),
                               plan_like(1500)};
  recipe.validation_schedule = one_episode(60);
  recipe.unseen_schedule = unseen_motions(300);
  recipe.test_schedule = one_episode(100);
  recipe.other_arm_test_schedule = one_episode(28);  // 100 s
  recipe.training = best_preset();
  // Those that leave room for the error of a network trained on three hours (docs/planning.md).
  recipe.environments = {"01_pillar", "05_between_pillars", "06_overshoot"};
  return recipe;
}

DemoRecipe quick_recipe(const ArmDescription& arm) {
  DemoRecipe recipe = full_recipe(arm);
  recipe.training_schedules = {transitions(arm, 729), random(300, Approach::step), plan_like(300)};
  recipe.validation_schedule = one_episode(30);
  recipe.unseen_schedule = unseen_motions(50);
  set_epoch_count(recipe.training, kQuickEpochs);
  recipe.starts_from_family = true;
  recipe.bench_queries = 100'000;
  recipe.plans_per_environment = 1;
  recipe.arrival_times_s = {kFirstPlan, 0.1};
  recipe.arrival_random_environments = 0;
  recipe.other_arms = 1;
  return recipe;
}

std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t index) {
  RandomStream stream(seed, kSeedStream + index);
  return std::uint64_t{stream.next_u32()};  // 32 bits: easy to read and to type again
}

}  // namespace limber
