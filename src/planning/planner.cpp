#include "limber/planning/planner.hpp"

#include <array>
#include <utility>

#include "limber/arm/pressure_limits.hpp"
#include "limber/forward/motion_simulator.hpp"

namespace limber {

MotionState start_of(const PlanningProblem& problem) {
  return state_of(start_state(problem.environment, problem.arm), problem.model);
}

std::vector<PressureLimits> limits_of(const PlanningProblem& problem) {
  return problem.limits.empty() ? limits_of(problem.arm) : problem.limits;
}

PressureBox setpoints_of(const PlanningProblem& problem) {
  const PressureBox box = pressure_box(limits_of(problem));
  return problem.stay_within == nullptr
             ? box
             : problem.stay_within->setpoints_of(problem.arm).within(box);
}

PlanningProblem problem_with_room(const ArmDescription& arm, const MotionModel& model,
                                  const Environment& environment, const ErrorRoom& room) {
  require_model_of_arm(arm, model, "planning problem");
  PlanningProblem problem{arm, model, environment, room.tube ? 0.0 : room.margin_m,
                          room.goal_margin};
  problem.margin_yields_to_start = room.margin_yields_to_start;
  problem.tube = room.tube;
  return problem;
}

PlannerLimits PlannerLimits::or_default() const {
  PlannerLimits limits = *this;
  if (!time_s && !iterations && !queries) {
    limits.time_s = kDefaultTimeLimitS;
  }
  return limits;
}

CollisionChecker checker_of(const PlanningProblem& problem) {
  PlateRoom room;
  if (problem.tube) {
    room = {problem.tube->plate_radius_m, problem.tube->growth,
            start_state(problem.environment, problem.arm).backbone};
  }
  return CollisionChecker(problem.arm, problem.environment.obstacles, problem.margin_m,
                          std::move(room));
}

const char* to_string(PlanStatus status) {
  constexpr std::array kNames{
      "solved", "limit", "invalid_start", "goal_unreachable", "goal_in_collision", "not_certified"};
  static_assert(kNames.size() == kPlanStatuses.size());
  return kNames[std::size_t(status)];
}

const char* to_string(PlanLimit limit) {
  constexpr std::array kNames{"time", "iterations", "queries", "memory"};
  return kNames[std::size_t(limit)];
}

}  // namespace limber
