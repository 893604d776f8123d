#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_model.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/certificate/certificate.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/plan_spread.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/report/plan_report.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "model_flags.hpp"
#include "spread_report.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// What another model makes of a plan's set points: a rehearsal, for arms without a virtual twin.
struct OtherJudgement {
  std::string model;     ///< its file
  bool is_shape = true;  ///< false: it predicts a shape that no arm has, and nothing else is known
  bool reaches_goal = false;
  bool collides = false;
  double goal_distance_m = 0.0;
  double clearance_m = 0.0;  ///< +∞ without obstacles
  double departure_m = 0.0;  ///< largest distance of a plate from where the plan puts it

  /// Where the file is an ensemble; everything above is its first network's.
  std::optional<PlanSpread> spread;

  bool agrees() const { return is_shape && reaches_goal && !collides; }
};

bool has_failed(const Certificate& certificate, const char* check) {
  return std::ranges::any_of(certificate.failures, [&](const CertificateFailure& failure) {
    return failure.check == check;
  });
}

/// What follows a plan's set points behind these valves is what it commands. Valves with a dead
/// time begin settled here, and not after what a start had been told before.
void give_commands(const ValveParameters& valves, const ArmDescription& arm, Plan& plan) {
  const auto frames = Eigen::Index(plan.frames.size());
  Eigen::MatrixXd setpoint_kpa(arm.channel_count(), frames);
  for (Eigen::Index k = 0; k < frames; ++k) {
    setpoint_kpa.col(k) = plan.frames[std::size_t(k)].setpoint_kpa.cast<double>();
  }
  const Eigen::VectorXd first_kpa =
      valves.is_ideal() ? Eigen::VectorXd(setpoint_kpa.col(0))
                        : Eigen::VectorXd(plan.frames.front().pressure_kpa.cast<double>());
  const Eigen::MatrixXd kpa = ValveModel(arm, valves).run(setpoint_kpa, first_kpa);
  for (Eigen::Index k = 0; k < frames; ++k) {
    plan.frames[std::size_t(k)].pressure_kpa = kpa.col(k).cast<float>();
  }
}

/// Rolls out `plan` on the network of `model_file`, by the certificate's own simulation, from its
/// start through its set points. Obstacles need only not be touched: margins are the plan's
/// model's business. A network that learnt from set points is asked with them.
/// @param valves  the plan's; null: its own model learnt from set points, so that the other one's
///                own valves are used.
/// @throws InputError where the network or the plan is of another arm.
OtherJudgement judge_by(const std::string& model_file, const Plan& plan, const ArmDescription& arm,
                        const ValveParameters* valves, const Environment& environment) {
  const CompensationModel network = read_model_of_one_arm(model_file, arm);
  const ValveParameters own = network.valves.value_or(ValveParameters{});
  const ValveParameters& used = valves == nullptr || network.learnt_from_setpoints ? own : *valves;
  Plan same_commands = plan;
  same_commands.model = "network";
  same_commands.valves_hash = used.hash();
  same_commands.tube.reset();  // the plan's model's business, as margins are
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
    // Else they are the plan's.
    if (network.learnt_from_setpoints || valves == nullptr || has_failed(found, "valves")) {
      give_commands(network.learnt_from_setpoints ? ValveParameters{} : used, arm, same_commands);
    }
    judgement.spread = plan_spread(same_commands, arm, network, environment);
  }
  return judgement;
}

Json to_json(const OtherJudgement& judgement) {
  return {{"model", judgement.model},
          {"agrees", judgement.agrees()},
          {"goal_reached", judgement.reaches_goal},
          {"collides", judgement.collides},
          {"distance_to_goal_cm", json_number(kCmPerM * judgement.goal_distance_m)},
          {"clearance_cm", json_number(kCmPerM * judgement.clearance_m)},
          {"largest_departure_cm", json_number(kCmPerM * judgement.departure_m)}};
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

class VerifyVerb final : public Verb {
 public:
  VerifyVerb()
      : Verb(
            "verify", "Certify a plan: simulate and check it again with independent code",
            "limber verify --plan plan.json --no-load --environment 01_pillar\n"
            "  limber verify --plan plan.json --model a.safetensors --environment 01_pillar --also "
            "b.safetensors --also c.safetensors") {}

  void add_flags(CLI::App& app) override {
    app.add_option("--plan", plan_, "Plan to certify, as `limber plan` wrote it")->required();
    add_arm_flag(app, arm_);
    model_.add_to(app, " that it was made with");
    app.add_option("--environment", environment_,
                   "Environment that it was made for; or the name of one of limber's own")
        ->required();
    app.add_option("--also", also_,
                   "Other networks of the same arm, to run the plan's set points on as well: where "
                   "they end, and whether they touch anything. One that misses or touches: exit 1");
  }

  int run(const CommonFlags& flags) override {
    const ArmDescription arm = load_asked_arm(arm_, "limber verify");
    const Environment environment = load_environment(find_environment_file(environment_), arm);
    const Plan plan = read_plan_unchecked(plan_);
    const std::optional<CompensationModel> network = read_network(plan);
    const CompensationModel* used = network ? &*network : nullptr;
    const ValveParameters valves = valves_of(plan, arm, used);
    Certificate certificate;
    try {
      certificate = certify(plan, arm, used, valves, environment);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", plan_, error.what()));
    }
    Json json = to_json(certificate, arm.command, environment);
    std::string text = to_text(certificate, arm, environment);
    const bool is_plan = !has_failed(certificate, "sizes");
    if (used != nullptr && used->member_count() > 1 && is_plan) {
      if (const auto spread = plan_spread(plan, arm, *used, environment)) {
        json["spread"] = to_json(*spread);
        text += "\n" + to_text(*spread, "this model", arm, environment);
      }
    }
    std::vector<std::string> disagreeing;
    const bool setpoints = used != nullptr && used->learnt_from_setpoints;
    // What is no plan says nothing of a network.
    for (const std::string& other : is_plan ? also_ : std::vector<std::string>()) {
      const OtherJudgement judgement =
          judge_by(other, plan, arm, setpoints ? nullptr : &valves, environment);
      json["also"].push_back(to_json(judgement));
      text += "\n" + to_text(judgement);
      if (judgement.spread) {
        json["also"].back()["spread"] = to_json(*judgement.spread);
        text += "; " + to_text(*judgement.spread, other, arm, environment);
      }
      if (!judgement.agrees()) {
        disagreeing.push_back(other);
      }
    }
    print_result(flags, json, text);
    if (!certificate.certified()) {
      print_error(
          fmt::format("{}: not certified: {}", plan_, certificate.failures.front().message));
    }
    if (!disagreeing.empty()) {
      print_error(fmt::format("{}: misses its goal or touches something by {}", plan_,
                              fmt::join(disagreeing, ", ")));
    }
    return certificate.certified() && disagreeing.empty() ? kExitDone : kExitNoSolution;
  }

 private:
  /// The valves that the certificate uses; they never come from the plan itself.
  ValveParameters valves_of(const Plan& plan, const ArmDescription& arm,
                            const CompensationModel* network) const {
    ValveParameters valves = model_.valves(arm, network);
    refuse_if(valves.is_ideal() && !plan.valves_hash.empty(),
              "{}: made with valves (hash {}): give --valves FILE with the same valves", plan_,
              plan.valves_hash);
    refuse_if(!valves.is_ideal() && plan.valves_hash.empty(),
              "{}: made without valves: give --no-valves to check it so", plan_);
    return valves;
  }

  std::optional<CompensationModel> read_network(const Plan& plan) const {
    if (plan.model == "network" ? !model_.names_model() : !model_.asks_no_load()) {
      throw InputError(
          fmt::format("{} was made with {}: give {}", plan_,
                      plan.model == "network" ? "a network" : "the no-load model",
                      plan.model == "network" ? "--model MODEL.safetensors" : "--no-load"));
    }
    if (model_.asks_no_load()) {
      return std::nullopt;
    }
    const std::string hash = file_hash(model_.model_file());
    // Plans made through the library may not say which file their model came from. The certificate
    // finds out whether they hold with this one.
    if (!plan.model_hash.empty() && plan.model_hash != hash) {
      throw InputError(fmt::format("{}: made with another model (hash {}; {} has {})", plan_,
                                   plan.model_hash, model_.model_file(), hash));
    }
    CompensationModel network = read_model_of_one_arm(model_.model_file());
    try {
      return plan.arm_of_family.size() == 0
                 ? std::move(network)
                 : model_of_followed_arm(std::move(network), plan.arm_of_family);
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: model.e: {}; give the model that the run had", plan_, error.what()));
    }
  }

  std::string plan_;
  std::string arm_ = "three_segment";
  ModelFlags model_;
  std::string environment_;
  std::vector<std::string> also_;
};

}  // namespace

std::unique_ptr<Verb> make_verify_verb() {
  return std::make_unique<VerifyVerb>();
}

}  // namespace limber
