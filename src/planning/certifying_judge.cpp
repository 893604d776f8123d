#include "certifying_judge.hpp"

#include <fmt/format.h>

namespace limber {

CertifyingJudge::CertifyingJudge(const PlanningProblem& asked)
    : asked_(asked), environment_hash_(environment_hash(asked.environment)) {}

void CertifyingJudge::name_problem(Plan& plan) const {
  plan.environment_hash = environment_hash_;
  plan.margin_m = asked_.margin_m;
}

PlanJudge::Verdict CertifyingJudge::judge(Plan& plan, const std::function<bool()>& give_up) {
  name_problem(plan);
  const CompensationModel* network =
      asked_.model.has_network() ? &asked_.model.compensation() : nullptr;
  Certificate certificate = certify(plan, asked_.arm, network,
                                    asked_.model.valves().parameters(), asked_.environment);
  (void)give_up;
  if (certificate.certified() && stays_within(plan)) {
    plan.certified = CertifiedFigures{certificate.clearance_m, certificate.largest_deviation_m};
    held_ = std::move(certificate);
    return Verdict::holds;
  }
  if (!refused_ || plan.cost_kpa < refused_kpa_) {
    refused_kpa_ = plan.cost_kpa;
    refused_ = std::move(certificate);
  }
  return Verdict::refused;
}

bool CertifyingJudge::stays_within(const Plan& plan) const {
  return asked_.stay_within == nullptr ||
         ways_beyond(asked_.stay_within->learnt(), plan, asked_.arm.command.unit).empty();
}

void CertifyingJudge::report(PlanResult& result) const {
  if (result.status == PlanStatus::solved) {
    result.certificate = held_;
  } else if (result.status == PlanStatus::not_certified) {
    result.certificate = refused_;
    if (refused_->certified()) {
      result.reason = fmt::format(
          "every plan that planner '{}' found leaves what the model's recordings held: {}",
          result.best_partial->planner,
          ways_beyond(asked_.stay_within->learnt(), *result.best_partial, asked_.arm.command.unit)
              .front());
      return;
    }
    const CertificateFailure& first = refused_->failures.front();
    result.reason = fmt::format(
        "every plan that planner '{}' found is refused by its certificate, the cheapest for this: "
        "{}: frame {}: {}; if it is not the model's fault it is the planner's: please report it "
        "with arm, model, environment and seed {}",
        result.best_partial->planner, first.check, first.frame, first.message,
        result.best_partial->seed);
  }
}

}  // namespace limber
