#include "other_judges.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/units.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

namespace {

nlohmann::ordered_json centimetres(double metres) {
  return std::isfinite(metres) ? nlohmann::ordered_json(kCmPerM * metres)
                               : nlohmann::ordered_json();
}

bool has_failed(const Certificate& certificate, const char* check) {
  return std::ranges::any_of(certificate.failures, [&](const CertificateFailure& failure) {
    return failure.check == check;
  });
}

}  // namespace

OtherJudgement judge_by(const std::string& model_file, const Plan& plan, const ArmDescription& arm,
                        const ValveParameters* valves, const Environment& environment) {
  const CompensationModel network = read_model_of_one_arm(model_file);
  const ValveParameters own = network.valves.value_or(ValveParameters{});
  const ValveParameters& used = valves == nullptr || network.learnt_from_setpoints ? own : *valves;
  Plan same_commands = plan;
  same_commands.model = "network";
  same_commands.valves_hash = used.hash();
  const Certificate found = certify(same_commands, arm, &network, used, environment);
  OtherJudgement judgement;
  judgement.model = model_file;
  judgement.goal_distance_m = found.goal_distance_m;
  judgement.clearance_m = found.clearance_m;
  judgement.departure_m = found.max_deviation_m;
  judgement.is_shape = std::isfinite(found.goal_distance_m) && !std::isnan(found.clearance_m);
  judgement.reaches_goal = judgement.is_shape && !has_failed(found, "goal");
  judgement.collides = judgement.is_shape && !(found.clearance_m >= Certificate::kMinClearanceM);
  if (judgement.is_shape) {
    judgement.spread = plan_spread(plan, arm, network, environment);
  }
  return judgement;
}

nlohmann::ordered_json to_json(const OtherJudgement& judgement) {
  return {{"model", judgement.model},
          {"agrees", judgement.agrees()},
          {"goal_reached", judgement.reaches_goal},
          {"collides", judgement.collides},
          {"distance_to_goal_cm", centimetres(judgement.goal_distance_m)},
          {"clearance_cm", centimetres(judgement.clearance_m)},
          {"largest_departure_cm", centimetres(judgement.departure_m)}};
}

std::string to_text(const OtherJudgement& judgement) {
  if (!judgement.is_shape) {
    return fmt::format("by {}: it predicts a shape that no arm has, so it can't judge this plan",
                       judgement.model);
  }
  const std::string clearance =
      std::isfinite(judgement.clearance_m)
          ? fmt::format(", clearance {:.2f} cm", kCmPerM * judgement.clearance_m)
          : "";
  return fmt::format(
      "by {}: ends {:.2f} cm from the goal ({}){}{}; up to {:.2f} cm beside the plan",
      judgement.model, kCmPerM * judgement.goal_distance_m,
      judgement.reaches_goal ? "reached" : "missed", clearance,
      judgement.collides ? " (collides)" : "", kCmPerM * judgement.departure_m);
}

}  // namespace limber
