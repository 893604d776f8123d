#include "certifying_judge.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "asked_problem.hpp"
#include "limber/arm/names.hpp"

namespace limber {

namespace {

bool is_same_motion(const Plan& a, const Plan& b) {
  return a.waypoints_kpa == b.waypoints_kpa &&
         std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), b.frames.end(),
                    [](const PlanFrame& x, const PlanFrame& y) {
                      return x.setpoint_kpa == y.setpoint_kpa && x.pressure_kpa == y.pressure_kpa &&
                             x.backbone == y.backbone;
                    });
}

double clearance_with_reserve_m(double margin_m) {
  return std::max(margin_m, Certificate::kMinClearanceM) + kReserveM;
}

}  // namespace

void CertifyingJudge::name_problem(Plan& plan) {
  plan.environment_hash = asked_.environment_hash();
  plan.margin_m = problem_.margin_m;
  plan.tube = tube_of_plans(problem_);
}

PlanJudge::Verdict CertifyingJudge::judge(Plan& plan, const std::function<bool()>& give_up) {
  const Certifier& certifier = asked_.certifier();
  name_problem(plan);
  Certificate certificate = certifier.certify(plan, give_up);
  if (certificate.unfinished) {
    return Verdict::unfinished;
  }
  if (certificate.certified() &&
      (problem_.stay_within == nullptr ||
       excursions_beyond(problem_.stay_within->learnt(), plan, problem_.arm.command).empty())) {
    plan.certified = CertifiedFigures{certificate.clearance_m, certificate.max_deviation_m};
    held_ = std::move(certificate);
    held_plan_ = plan;
    if (problem_.on_plan) {
      problem_.on_plan(plan);
    }
    return Verdict::holds;
  }
  if (!refused_ || plan.cost_kpa < refused_kpa_) {
    refused_kpa_ = plan.cost_kpa;
    refused_ = std::move(certificate);
  }
  return Verdict::refused;
}

void CertifyingJudge::report(PlanResult& result) {
  const bool was_judged = !result.plan || (held_ && is_same_motion(*result.plan, held_plan_));
  if (!was_judged && judge(*result.plan, [] { return false; }) != Verdict::holds) {
    result.status = PlanStatus::not_certified;
    result.best_partial = std::move(result.plan);
    result.plan.reset();
    result.first_solution.reset();
    result.events.clear();
  }
  if (result.status == PlanStatus::solved) {
    result.certificate = held_;
  } else if (result.status == PlanStatus::not_certified) {
    result.certificate = refused_;
    if (refused_->certified()) {
      result.reason = fmt::format(
          "every plan that planner '{}' found leaves what the model's recordings held: {}",
          result.best_partial->planner,
          excursions_beyond(problem_.stay_within->learnt(), *result.best_partial,
                            problem_.arm.command)
              .front());
      return;
    }
    const CertificateFailure& first = refused_->failures.front();
    const std::string where = first.frame >= 0 ? frame_name(first.frame) + ": " : "";
    result.reason = fmt::format(
        "every plan that planner '{}' found is refused by its certificate, the cheapest for this: "
        "{}: {}{}; if the model is not at fault, the planner is: please report it with "
        "arm, model, environment and seed {}",
        result.best_partial->planner, first.check, where, first.message, result.best_partial->seed);
  }
}

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
