// What a minute of motion makes of limber's family: arms that nobody has recorded before.
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "demo_recipe.hpp"
#include "demo_stages.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/family_traits.hpp"
#include "limber/lab/trial_run.hpp"
#include "limber/lab/unseen_arm.hpp"
#include "limber/report/training_report.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kOtherArmSeed = 320;
constexpr std::uint64_t kEnvironmentsSeed = 330;  // of the first arm's; then of the next one
constexpr double kMinuteS = 60.0;
constexpr double kShortS = 20.0;
constexpr int kEnvironments = 8;
// Of a search in mid-motion: what 20 ms were measured to allow on a busy core; fixed, so that runs
// are the same on every machine.
constexpr std::uint64_t kMotionQueries = 2500;

/// An arm with physics of its own, and what was recorded of it.
struct OtherArm {
  ArmDescription arm;
  Episode minute;
  Episode test;
};

OtherArm draw(const DemoResults& results, int number) {
  const std::uint64_t seed = derived_seed(results.settings->seed, kOtherArmSeed);
  OtherArm other{
      with_related_physics(results.settings->arm, WidePhysics{}, seed, std::uint64_t(number)),
      {},
      {}};
  other.minute = identifying_run(other.arm, kMinuteS, seed, std::uint64_t(number));
  VirtualArm driver(other.arm);
  other.test = record_episode(
      other.arm, driver,
      make_schedule(other.arm, results.recipe.other_arm_test_schedule, seed + number).front(), {});
  return other;
}

double open_loop_cm(const ArmDescription& arm, const CompensationModel& model, const Episode& test,
                    int jobs) {
  const ForwardModel forward(arm, model);
  return evaluate(ForwardModel(arm), &forward, {test}, jobs).network->open_loop.position_cm.mean;
}

/// One plan in each of some environments about that arm's own motions (limber's own may be out of
/// a weak arm's reach), for the adapted model, executed open loop, and again in closed loop.
void plan_and_execute(const DemoResults& results, const OtherArm& other, int number,
                      const CompensationModel& model, OtherArmFigures& figures) {
  const ArmDescription& arm = results.settings->arm;
  const ForwardModel forward(arm, model);
  const MotionModel motion(forward, ValveModel(arm, model.identified_valves().parameters));
  PlanTrialSettings settings;
  settings.limits.time_s = results.recipe.planning_time_limit_s;
  settings.controller = "replan";
  settings.motion_queries = kMotionQueries;
  for (const EnvironmentCase& item : random_environments(
           other.arm, derived_seed(results.settings->seed, kEnvironmentsSeed + number),
           kEnvironments)) {
    throw_if_interrupted();
    PlanTrial trial = plan_trial(arm, motion, item, settings,
                                 derived_seed(results.settings->seed, kOtherArmSeed));
    ++figures.plans;
    if (!trial.solved()) {
      continue;
    }
    ++figures.solved;
    execute_trial(other.arm, item.environment, trial);
    figures.arrived += has_arrived(*trial.execution) ? 1 : 0;
    figures.collided += trial.execution->collided ? 1 : 0;
    run_trial(other.arm, motion, item.environment, settings, trial);
    figures.arrived_closed_loop += has_arrived(*trial.execution) ? 1 : 0;
    figures.collided_closed_loop += trial.execution->collided ? 1 : 0;
  }
}

OtherArmFigures other_arm_figures(const DemoResults& results, const CompensationModel& family,
                                  int number) {
  const ArmDescription& arm = results.settings->arm;
  const int jobs = results.settings->jobs;
  const OtherArm other = draw(results, number);
  OtherArmFigures figures;
  const auto fitted_to = [&](double seconds) {
    AdaptationSettings settings;
    settings.jobs = jobs;
    return adapt(arm, family, {first_seconds(arm, other.minute, seconds)}, settings);
  };
  figures.own_network_cm = open_loop_cm(results.arm(), results.training.model, other.test, jobs);
  figures.after_20_s_cm = open_loop_cm(arm, fitted_to(kShortS).model, other.test, jobs);
  const Adaptation adapted = fitted_to(kMinuteS);
  figures.after_60_s_cm = open_loop_cm(arm, adapted.model, other.test, jobs);
  figures.traits = beside_truth(other.arm, adapted.traits);
  plan_and_execute(results, other, number, adapted.model, figures);
  return figures;
}

}  // namespace

void another_arm_stage(DemoResults& results) {
  const ArmDescription& arm = results.settings->arm;
  const std::optional<CompensationModel> family = own_family(arm);
  if (!family) {
    results.settings->say(fmt::format(
        "  limber has no family for {}; limber family --arm FILE --out FAMILY makes one",
        arm.name));
    return;
  }
  for (int number = 0; number < results.recipe.other_arms; ++number) {
    throw_if_interrupted();
    results.other_arms.push_back(other_arm_figures(results, *family, number));
    const OtherArmFigures& figures = results.other_arms.back();
    results.settings->say(fmt::format(
        "  arm {} of {}: {:.1f} cm off with the network above; adapted, after 20 s {:.1f}, after a "
        "minute {:.1f}; {} of {} plans found, {} arrive, {} in closed loop",
        number + 1, results.recipe.other_arms, figures.own_network_cm, figures.after_20_s_cm,
        figures.after_60_s_cm, figures.solved, figures.plans, figures.arrived,
        figures.arrived_closed_loop));
  }
}

Json to_json(const OtherArmFigures& figures) {
  return {{"own_network_cm", figures.own_network_cm},
          {"after_20_s_cm", figures.after_20_s_cm},
          {"after_60_s_cm", figures.after_60_s_cm},
          {"plans", figures.plans},
          {"solved", figures.solved},
          {"arrived", figures.arrived},
          {"collided", figures.collided},
          {"arrived_closed_loop", figures.arrived_closed_loop},
          {"collided_closed_loop", figures.collided_closed_loop},
          {"traits", to_json(figures.traits)}};
}

}  // namespace limber
