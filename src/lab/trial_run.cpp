#include "limber/lab/trial_run.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/run/jacobian_controller.hpp"
#include "limber/sim/disturbance.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

namespace {

constexpr std::array kControllers = {"open", "replan", "jacobian"};

}  // namespace

std::string controller_names() {
  return fmt::format("{}", fmt::join(kControllers, ", "));
}

void require_controller(const std::string& controller) {
  if (!parse_jacobian(controller) && std::ranges::count(kControllers, controller) == 0) {
    throw InputError(
        fmt::format("controller '{}': no such one; expected {}", controller, controller_names()));
  }
}

ErrorRoom room_of(const MotionModel& model, AskedRoom asked) {
  if (!model.has_network()) {
    asked.tube_level.reset();
  }
  return error_room(model.forward(), asked);
}

PlanTrial plan_trial(const ArmDescription& arm, const MotionModel& model,
                     const EnvironmentCase& item, const PlanTrialSettings& settings,
                     std::uint64_t seed) {
  PlanTrial trial;
  trial.environment = item.id;
  trial.model = model.has_network() ? "network" : "no_load";
  trial.planner = settings.planner;
  trial.seed = seed;
  trial.asks_heading = item.environment.goal.theta_rad.has_value();
  const ErrorRoom room = room_of(model, settings.room);
  PlanningProblem problem = problem_with_room(arm, model, item.environment, room);
  problem.limits = settings.within;
  trial.planning = make_planner(settings.planner, settings.planner_jobs, settings.forest)
                       ->plan(problem, settings.limits, seed,
                              [](const PlannerProgress&) { return !interrupt_requested(); });
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

void run_trial(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
               const PlanTrialSettings& settings, PlanTrial& trial) {
  require_controller(settings.controller);
  trial.controller = settings.controller;
  trial.disturbance = settings.disturbance;
  if (!trial.planning.plan) {
    return;
  }
  const Plan& plan = *trial.planning.plan;
  const DisturbedArm met =
      disturbed(arm, plan, parse_disturbances(settings.disturbance), trial.seed);
  VirtualArm driver(met.arm, met.options);
  ExecutionSettings run;
  run.obstacle = met.obstacle ? &*met.obstacle : nullptr;
  const ErrorRoom room = room_of(model, settings.room);
  std::optional<ClosedLoop> loop;
  if (settings.controller == "replan") {
    ClosedLoopSettings loop_settings;
    loop_settings.motion_queries = settings.motion_queries;
    loop_settings.adapts = settings.adapts;
    run.controller = &loop.emplace(arm, model, environment, room, loop_settings, trial.seed);
  }
  std::optional<JacobianController> controller;
  if (const std::optional<JacobianGains> gains = parse_jacobian(settings.controller)) {
    run.controller = &controller.emplace(arm, plan, environment.goal, *gains);
  }
  trial.execution = execute(arm, environment, plan, driver, run);
}

}  // namespace limber
