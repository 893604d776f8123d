#pragma once

#include "limber/lab/planning_experiment.hpp"

namespace limber {

/// Executes the trial's plan, if it has one, on a fresh virtual arm at rest: as the trial's
/// controller has it, and with its disturbance, of which neither plan nor model know. Chance comes
/// from the trial's seed.
/// @throws InputError if there is no such controller or disturbance.
void run_trial(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
               const PlanTrialSettings& settings, PlanTrial& trial);

/// Room for the model's error. A tube is asked for of the network; the no-load model has none.
ErrorRoom room_of(const MotionModel& model, AskedRoom asked);

/// "open, replan, …".
std::string controller_names();
/// @throws InputError as `run_trial`, before any work.
void require_controller(const std::string& controller);

}  // namespace limber
