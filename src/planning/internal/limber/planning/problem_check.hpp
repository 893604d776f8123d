#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limber/planning/planner.hpp"
#include "limber/world/collision.hpp"

namespace limber {

/// What is wrong with a problem before any planning. Only certain faults are refused. Doubts that
/// come from the no-load model alone are warnings, because the arm moves differently.
struct ProblemCheck {
  std::optional<PlanStatus> refusal;  ///< invalid_start, goal_unreachable or goal_in_collision
  std::string reason;                 ///< names obstacle, plates and amount
  std::vector<std::string> warnings;
};

inline constexpr double kMaxMarginM = 1000.0;  // as coordinates of environments

/// @throws InputError unless 0 ≤ margin_m ≤ kMaxMarginM: a negative one would be a plan through
/// obstacles.
void require_margin(double margin_m);

/// @throws InputError unless both are finite and ≥ 0.
void require_goal_margin(const PoseError& margin);

/// @throws InputError unless there are none, or one of each segment, lower < upper and within the
/// arm's.
void require_limits(const std::vector<PressureLimits>& limits, const ArmDescription& arm);

/// The refusal alone, if there is one; planners check this first.
ProblemCheck find_refusal(const PlanningProblem& problem, const CollisionChecker& checker);

/// Warnings about a problem that is not refused. @param seed  of the inverse kinematics
std::vector<std::string> find_warnings(const PlanningProblem& problem, std::uint64_t seed);

/// Both. @param seed  of the inverse kinematics behind the warnings
ProblemCheck check_problem(const PlanningProblem& problem, const CollisionChecker& checker,
                           std::uint64_t seed);

/// For a search that found nothing: whether the no-load model reaches the goal only in collision.
/// A sentence that names obstacle, plates and amount of the configuration that is least deep; empty
/// if some configuration at the goal is free, or if none was found at all (then there is a
/// warning). The arm itself may differ, so this explains and never refuses.
/// @param give_up  called now and then; once it is true the answer is empty. Empty: never
std::string reached_only_in_collision(const PlanningProblem& problem,
                                      const CollisionChecker& checker, std::uint64_t seed,
                                      const std::function<bool()>& give_up = {});

}  // namespace limber
