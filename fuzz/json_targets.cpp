#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/training/cross_validation.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "src/lab/trial_file.hpp"
#include "src/studio/scene_json.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

/// What `certify` judges, and what is executed.
void read_plan_file(const Input& input) {
  (void)read_plan_unchecked(input.file);
  const Plan plan = read_plan(input.file);
  (void)plan.duration_s();
  const auto again = scratch_folder() / "again.json";
  write_plan(again, plan);
  require(read_plan(again).frames.size() == plan.frames.size(),
          "a plan that is another one once written");
  require_plan_of(plan, three_segments(), input.file);
}

const TrialKey& trial_key() {
  static const TrialKey key = {"a", "e1", "a", "h1", "no_load", "", "default", "open", "", 7};
  return key;
}

/// Standing still at rest.
Plan still_plan() {
  const ArmDescription& arm = three_segments();
  Plan plan;
  plan.arm_name = arm.name;
  plan.arm_hash = arm.hash();
  plan.model = trial_key().model;
  plan.environment_name = trial_key().environment;
  plan.environment_hash = trial_key().environment_hash;
  plan.planner = trial_key().planner;
  plan.seed = trial_key().seed;
  plan.frame_rate_hz = arm.frame_rate_hz;
  plan.waypoints_kpa = {Pressures::Zero(arm.segment_count())};
  plan.frames.assign(3,
                     {plan.waypoints_kpa[0], plan.waypoints_kpa[0], start_state({}, arm).backbone});
  plan.hold_frame_count = 2;
  plan.certified = CertifiedFigures{0.01, 0.0, true};
  return plan;
}

/// The second is small enough for libFuzzer, which cuts longer ones off (soak.sh). It has no
/// certificate, so that it may be changed.
std::vector<std::string> plan_seeds() {
  Plan plan = still_plan();
  plan.certified.reset();
  const auto file = scratch_folder() / "seed.plan.json";
  write_plan(file, plan);
  return {source_file("tests/data/closed_loop/hard_051.plan.json"), read_file(file)};
}

/// The folder of an experiment with one trial that has a plan and was executed.
const std::filesystem::path& trial_folder() {
  static const std::filesystem::path folder = [] {
    PlanTrial trial;
    trial.environment = trial_key().environment;
    trial.model = trial_key().model;
    trial.planner = trial_key().planner;
    trial.seed = trial_key().seed;
    trial.planning.status = PlanStatus::solved;
    trial.planning.first_solution = FirstSolution{0.5, 10.0, 100};
    trial.planning.plan = still_plan();
    trial.execution.emplace();
    trial.execution->final_backbone = Backbone::Zero(three_segments().point_count(), 3);
    trial.execution->goal_error = {0.01, 0.1};
    OutputFolder output(scratch_folder() / "x", "experiment", OutputFolder::Start::fresh);
    write_trial(output, trial_key(), trial, {});
    return output.path();
  }();
  return folder;
}

void read_trial_file(const Input& input) {
  std::filesystem::copy_file(input.file, trial_folder() / "trials/a.json",
                             std::filesystem::copy_options::overwrite_existing);
  (void)read_trial(trial_folder(), trial_key(), three_segments(), {});
}

std::vector<std::string> trial_seeds() {
  return {read_file(trial_folder() / "trials/a.json")};
}

void read_cross_validation_text(const Input& input) {
  const CrossValidation found = read_cross_validation(std::string(input.bytes), "the state");
  require(read_cross_validation(to_json(found).dump(), "again") == found,
          "a cross-validation that is another one once written");
  (void)to_text(found);
}

std::vector<std::string> cross_validation_seeds() {
  CrossValidation found;
  found.folds = kFolds;
  found.tried = {{300, {200}, Optimiser::soap, 1, 0.1, 0.5, 1.0},
                 {300, {8, 8}, Optimiser::adam, kFolds, 0.1, 0.4, 0.9}};
  found.chosen = 1;
  return {to_json(found).dump()};
}

/// What the studio's page sends.
void read_environment_json(const Input& input) {
  const nlohmann::json json = parse_json_object(input.bytes, "request");
  const Environment environment = environment_from_json(json, three_segments());
  (void)read_environment(YamlReader::from_text(environment_to_yaml(environment), "again"));
}

}  // namespace

std::vector<Target> json_targets() {
  return {{"plan", "plan.json", read_plan_file, plan_seeds},
          {"trial", "a.json", read_trial_file, trial_seeds},
          {"cross_validation", "", read_cross_validation_text, cross_validation_seeds},
          {"page_environment", "", read_environment_json}};
}

}  // namespace limber::fuzz
