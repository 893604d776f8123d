#include "smaller_clearances.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "certified_search.hpp"
#include "given_waypoints.hpp"
#include "goal_room.hpp"
#include "limber/common/units.hpp"
#include "search/default_planner.hpp"

namespace limber {

namespace {

constexpr double kSmallerClearances[] = {0.75, 0.5, 0.25, 0.0};  // of the one asked for

PlannerLimits left_of(const PlannerLimits& limits, const PlannerStatistics& spent,
                      SteadyTime start) {
  PlannerLimits left = limits;
  if (limits.time_s) {
    left.time_s = *limits.time_s - seconds_since(start);
  }
  if (limits.iterations) {
    left.iterations = *limits.iterations - std::min(*limits.iterations, spent.iterations);
  }
  if (limits.queries) {
    left.queries = *limits.queries - std::min(*limits.queries, spent.queries);
  }
  left.cost_threshold_kpa = std::numeric_limits<double>::max();  // the first will do
  return left;
}

bool is_spent(const PlannerLimits& limits) {
  constexpr double kMinS = 0.01;
  return (limits.time_s && *limits.time_s < kMinS) || limits.iterations == 0 || limits.queries == 0;
}

/// An equal part of what is left for each of so many tries.
PlannerLimits part_of(PlannerLimits limits, double tries) {
  const auto part = [&](std::optional<std::uint64_t>& count) {
    if (count) {
      count = std::max<std::uint64_t>(1, std::uint64_t(double(*count) / tries));
    }
  };
  if (limits.time_s) {
    limits.time_s = *limits.time_s / tries;
  }
  part(limits.iterations);
  part(limits.queries);
  return limits;
}

/// A plan that was found with less, if it happens to keep what was asked for.
bool keeps_what_was_asked(const PlanningProblem& asked, AskedProblem& shared, const Plan& found,
                          SteadyTime start, PlanResult& result) {
  const std::vector<Pressures> waypoints_kpa(found.waypoints_kpa.begin() + 1,
                                             found.waypoints_kpa.end());
  PlanResult kept = certified_along(asked, shared, waypoints_kpa, found.planner, found.seed);
  if (!kept.plan) {
    return false;
  }
  kept.first_solution->time_s = seconds_since(start);
  kept.first_solution->queries = result.statistics.queries;
  kept.statistics = result.statistics;
  kept.warnings = std::move(result.warnings);
  kept.reason = "found by a search with less clearance, and keeps what was asked for";
  result = std::move(kept);
  return true;
}

}  // namespace

double seconds_since(SteadyTime start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void try_smaller_clearances(const PlanningProblem& asked, AskedProblem& shared,
                            const PlannerLimits& limits, SteadyTime start, std::uint64_t seed,
                            const PlannerCallback& callback, PlanResult& result) {
  const std::unique_ptr<Planner> planner = make_default_planner();
  const double max_m = asked.tube ? max_room_m(*asked.tube) : asked.margin_m;
  PlanningProblem problem = asked;
  problem.tube.reset();
  problem.on_plan = {};  // these keep less than was asked for
  PlannerStatistics& spent = result.statistics;
  std::size_t tries = std::size(kSmallerClearances);
  for (const double share : kSmallerClearances) {
    const PlannerLimits left = left_of(limits, spent, start);
    if (is_spent(left)) {
      return;
    }
    problem.margin_m = share * max_m;
    const PlanResult tried =
        certified_search(*planner, problem, shared, part_of(left, double(tries--)), seed, callback);
    spent.iterations += tried.statistics.iterations;
    spent.queries += tried.statistics.queries;
    if (tried.plan) {
      if (keeps_what_was_asked(asked, shared, *tried.plan, start, result)) {
        return;
      }
      result.max_clearance_m = tried.plan->certified->clearance_m;
      result.reason += fmt::format(
          "; with less clearance than the {:.2f} cm {} there is a plan, which keeps "
          "{:.2f} cm: --margin-m {:.4g}",
          max_m * kCmPerM, asked.tube ? "of the tube" : "asked for",
          *result.max_clearance_m * kCmPerM, problem.margin_m);
      return;
    }
  }
}

}  // namespace limber
