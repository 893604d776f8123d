#include <algorithm>
#include <optional>
#include <vector>

#include "limber/certificate/certificate.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/report/plan_report.hpp"
#include "model_flags.hpp"
#include "other_judges.hpp"
#include "spread_report.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class VerifyVerb final : public Verb {
 public:
  const char* name() const override { return "verify"; }
  const char* summary() const override {
    return "Certify a plan: simulate and check it again with independent code";
  }
  const char* example() const override {
    return "limber verify --plan plan.json --no-load --environment 01_pillar\n"
           "  limber verify --plan plan.json --model a.safetensors --environment 01_pillar --also "
           "b.safetensors --also c.safetensors";
  }

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
    nlohmann::ordered_json json = to_json(certificate, arm.command, environment);
    std::string text = to_text(certificate, arm, environment);
    const bool is_plan = std::ranges::none_of(
        certificate.failures, [](const auto& failure) { return failure.check == "sizes"; });
    if (used != nullptr && used->member_count() > 1 && is_plan) {
      if (const auto spread = plan_spread(plan, arm, *used, environment)) {
        json["spread"] = to_json(*spread);
        text += "\n" + to_text(*spread, "this model", arm, environment);
      }
    }
    bool agreed = true;
    const bool setpoints = used != nullptr && used->learnt_from_setpoints;
    for (const std::string& other : also_) {
      const OtherJudgement judgement =
          judge_by(other, plan, arm, setpoints ? nullptr : &valves, environment);
      json["also"].push_back(to_json(judgement));
      text += "\n" + to_text(judgement);
      if (judgement.spread) {
        json["also"].back()["spread"] = to_json(*judgement.spread);
        text += "; " + to_text(*judgement.spread, other, arm, environment);
      }
      agreed = agreed && judgement.agrees();
    }
    print_result(flags, json, text);
    return certificate.certified() && agreed ? kExitDone : kExitNoSolution;
  }

 private:
  /// The valves that the certificate uses; they never come from the plan itself.
  ValveParameters valves_of(const Plan& plan, const ArmDescription& arm,
                            const CompensationModel* network) const {
    ValveParameters valves = model_.valves(arm, network);
    if (valves.is_ideal() && !plan.valves_hash.empty()) {
      throw InputError(
          fmt::format("{}: made with valves (hash {}): give --valves FILE with the same valves",
                      plan_, plan.valves_hash));
    }
    if (!valves.is_ideal() && plan.valves_hash.empty()) {
      throw InputError(
          fmt::format("{}: made without valves: give --no-valves to check it so", plan_));
    }
    return valves;
  }

  std::optional<CompensationModel> read_network(const Plan& plan) const {
    if (!model_.names_model() && !model_.asks_no_load()) {
      throw InputError(
          fmt::format("{} was made with {}: give {}", plan_,
                      plan.model == "network" ? "a network" : "the no-load model",
                      plan.model == "network" ? "--model MODEL.safetensors" : "--no-load"));
    }
    if (model_.asks_no_load()) {
      return std::nullopt;
    }
    const std::string hash = content_hash(read_file(model_.model_file()));
    // Plans made through the library may not say which file their model came from. The certificate
    // finds out whether they hold with this one.
    if (plan.model == "network" && !plan.model_hash.empty() && plan.model_hash != hash) {
      throw InputError(fmt::format("{}: made with another model (hash {}; {} has {})", plan_,
                                   plan.model_hash, model_.model_file(), hash));
    }
    return read_model_of_one_arm(model_.model_file());
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
