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
  const PlanningProblem searched{problem.arm,
                                 problem.model,
                                 environment,
                                 clearance_with_reserve_m(problem.margin_m),
                                 {},
                                 aim_of(problem),
                                 problem.stay_within,
                                 &judge,
                                 false,
                                 has_room(problem),
                                 problem.tube};
  PlanResult result = planner.plan(searched, limits, seed, callback);
  if (result.best_partial) {
    judge.name_problem(*result.best_partial);
  }
  judge.report(result);
  return result;
}

}  // namespace limber
