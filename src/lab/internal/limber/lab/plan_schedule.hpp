#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/progress.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/schedule.hpp"

namespace limber {

struct PlanScheduleSettings {
  int episodes = 1;               ///< unbroken runs, ≥ 1
  int count = 10;                 ///< plans of each, ≥ 1
  std::uint64_t queries = 20000;  ///< of each plan
  double limit_scale = 1.0;       ///< plans stay within so many times the limits, in (0, 1]
  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads, 0: one per core; never changes a result
  Progress::Mode progress = Progress::Mode::automatic;
};

/// Motions that a model plans: `collect --schedule plans` (docs/improving.md). Each episode begins
/// with the vented arm. A random environment is drawn about where the model says that the arm
/// rests, a plan is searched for in it, and the next one begins where that plan ends. Obstacles are
/// imagined: they make plans take detours. An environment without a plan is passed over.
/// @throws InputError for a setting out of range, and if environments in a row have no plan
std::vector<EpisodeSchedule> plan_schedule(const ArmDescription& arm, const MotionModel& model,
                                           const PlanScheduleSettings& settings);

/// In one line, as of `ScheduleSettings`; `model_hash` is of the model's file.
std::string describe(const PlanScheduleSettings& settings, const std::string& model_hash);

}  // namespace limber
