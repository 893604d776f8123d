#pragma once

#include <optional>

#include "asked_problem.hpp"
#include "limber/certificate/certificate.hpp"
#include "limber/planning/planner.hpp"
#include "plan_judge.hpp"

namespace limber {

/// Accepts plans that their certificate (certificate/certificate.hpp) certifies for the problem as
/// it was asked for and, if that is asked for, that stay within the recordings. Borrows both.
class CertifyingJudge final : public PlanJudge {
 public:
  /// @param problem  what is searched for now
  /// @param asked    its arm, model and environment, shared by searches that keep different margins
  CertifyingJudge(const PlanningProblem& problem, AskedProblem& asked)
      : problem_(problem), asked_(asked) {}

  Verdict judge(Plan& plan, const std::function<bool()>& give_up) override;

  /// Writes into the plan what was asked for: planners see a problem with a little less room.
  void name_problem(Plan& plan);

  /// Adds to a planner's result the certificate of its plan, or why there is none. A plan that was
  /// not judged yet, or has changed since, is judged now.
  void report(PlanResult& result);

 private:
  const PlanningProblem& problem_;
  AskedProblem& asked_;
  std::optional<Certificate> held_;  // of the last plan that holds: the cheapest
  Plan held_plan_;
  std::optional<Certificate> refused_;  // of the cheapest that was refused
  double refused_kpa_ = 0.0;
};

/// Plans `problem` with `planner` and a little less room, and certifies it as it was asked for.
/// @param asked  the same arm, model and environment, whatever their margins
PlanResult certified_search(Planner& planner, const PlanningProblem& problem, AskedProblem& asked,
                            const PlannerLimits& limits, std::uint64_t seed,
                            const PlannerCallback& callback);

}  // namespace limber
