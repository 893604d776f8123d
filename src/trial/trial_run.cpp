#include "limber/trial/trial_run.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/trial/closed_loop.hpp"
#include "limber/trial/disturbance.hpp"
#include "limber/trial/jacobian_controller.hpp"

namespace limber {

namespace {

constexpr std::array kControllers = {"open", "replan", "jacobian", "online_jacobian"};

}  // namespace

std::string controller_names() {
  return fmt::format("{}", fmt::join(kControllers, ", "));
}

void require_controller(const std::string& controller) {
  if (parse_jacobian(controller)) {
    return;
  }
  if (std::find(kControllers.begin(), kControllers.end(), controller) == kControllers.end()) {
    throw InputError(fmt::format("controller '{}': no such one; expected {}", controller,
                                 fmt::join(kControllers, ", ")));
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
    run.replanner = &loop.emplace(arm, model, environment, room, loop_settings, trial.seed);
  }
  std::optional<JacobianController> controller;
  if (const std::optional<JacobianGains> gains = parse_jacobian(settings.controller)) {
    run.controller = &controller.emplace(arm, plan, environment.goal, *gains);
  }
  trial.execution = execute(arm, environment, plan, driver, run);
}

}  // namespace limber
