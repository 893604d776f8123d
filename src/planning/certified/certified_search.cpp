#include "certified_search.hpp"

#include <algorithm>

#include "certifying_judge.hpp"
#include "goal_room.hpp"

namespace limber {

namespace {

double clearance_with_reserve_m(double margin_m) {
  return std::max(margin_m, Certificate::kMinClearanceM) + kReserveM;
}

}  // namespace

PlanResult certified_search(Planner& planner, const PlanningProblem& problem, AskedProblem& asked,
                            const PlannerLimits& limits, std::uint64_t seed,
                            const PlannerCallback& callback) {
  const Environment environment = with_room(problem.environment, problem.goal_margin);
  CertifyingJudge judge(problem, asked);
  const PlanningProblem searched{.arm = problem.arm,
                                 .model = problem.model,
                                 .environment = environment,
                                 .margin_m = clearance_with_reserve_m(problem.margin_m),
                                 .aim = aim_of(problem),
                                 .stay_within = problem.stay_within,
                                 .limits = problem.limits,
                                 .judge = &judge,
                                 .goal_has_room = has_room(problem),
                                 .tube = problem.tube};
  PlanResult result = planner.plan(searched, limits, seed, callback);
  if (result.best_partial) {
    judge.name_problem(*result.best_partial);
  }
  judge.report(result);
  return result;
}

}  // namespace limber
