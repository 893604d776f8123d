#include <chrono>

#include <fmt/format.h>

#include "asked_problem.hpp"
#include "given_waypoints.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/planning/problem_check.hpp"
#include "smaller_clearances.hpp"

namespace limber {

namespace {

void require_waypoints(const PlanningProblem& problem, const std::vector<Pressures>& kpa) {
  if (kpa.empty()) {
    throw InputError("no waypoints; expected at least one, to which the motion goes");
  }
  for (std::size_t w = 0; w < kpa.size(); ++w) {
    if (kpa[w].size() != problem.arm.channel_count()) {
      throw InputError(fmt::format("{} has {} set points; arm '{}' has {} segments",
                                   waypoint_name(w), kpa[w].size(), problem.arm.name,
                                   problem.arm.channel_count()));
    }
    for (Eigen::Index i = 0; i < kpa[w].size(); ++i) {
      const auto index = static_cast<std::size_t>(i);
      const PressureLimits& limits = problem.limits.empty()
                                         ? problem.arm.segments[index].pressure_limit_kpa
                                         : problem.limits[index];
      if (!limits.contains(double(kpa[w][i]))) {  // NaN neither
        throw InputError(fmt::format(
            "{}: {} at {:.6g} {unit}; expected within {} {unit}", waypoint_name(w), segment_name(i),
            kpa[w][i], to_string(limits), fmt::arg("unit", problem.arm.command.unit)));
      }
    }
  }
}

}  // namespace

PlanResult plan_along(const PlanningProblem& given, const std::vector<Pressures>& waypoints_kpa,
                      const std::string& planner, std::uint64_t seed) {
  const auto start = std::chrono::steady_clock::now();
  require_margin(given.margin_m);
  require_goal_margin(given.goal_margin);
  require_limits(given.limits, given.arm);
  require_waypoints(given, waypoints_kpa);
  PlanningProblem problem = given;
  PlanResult result;
  yield_to_start(problem, result.warnings);
  ProblemCheck check = find_refusal(problem, checker_of(problem));
  if (check.refusal) {
    result.status = *check.refusal;
    result.reason = std::move(check.reason);
    return result;
  }
  AskedProblem asked(problem);
  const std::vector<std::string> notes = std::move(result.warnings);
  result = certified_along(problem, asked, waypoints_kpa, planner, seed);
  result.warnings.insert(result.warnings.begin(), notes.begin(), notes.end());
  if (result.status == PlanStatus::limit) {  // refused before its certificate was asked
    result.status = PlanStatus::not_certified;
  }
  result.statistics.time_s = seconds_since(start);
  return result;
}

}  // namespace limber
