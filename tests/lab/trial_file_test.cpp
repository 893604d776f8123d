#include "src/lab/trial_file.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A finished trial with a plan and its execution, whose files are to be damaged.
class TrialFile : public ::testing::Test {
 protected:
  void SetUp() override {
    key_ = {"a_no_load_default_001", "e1", "a", "h1", "no_load", "", "default", "open", "", 7};
    PlanTrial trial;
    trial.environment = key_.environment;
    trial.model = key_.model;
    trial.planner = key_.planner;
    trial.seed = key_.seed;
    trial.planning.status = PlanStatus::solved;
    trial.planning.first_solution = FirstSolution{0.5, 10.0, 100};
    trial.planning.plan = small_plan();
    trial.execution.emplace();
    trial.execution->final_backbone = Backbone::Zero(arm_.point_count(), 3);
    trial.execution->goal_error = {0.01, 0.1};
    trial.execution->planned_goal_time_s = 2.5;
    write_trial(output_, key_, trial, environment_);
    trial_ = read_file(trial_path());
    plan_ = read_file(plan_path());
  }

  /// Standing still at rest.
  Plan small_plan() const {
    Plan plan;
    plan.arm_name = arm_.name;
    plan.arm_hash = arm_.hash();
    plan.model = key_.model;
    plan.environment_name = "a";
    plan.environment_hash = key_.environment_hash;
    plan.planner = key_.planner;
    plan.seed = key_.seed;
    plan.frame_rate_hz = arm_.frame_rate_hz;
    plan.waypoints_kpa = {Pressures::Zero(arm_.segment_count())};
    plan.frames.assign(3, {plan.waypoints_kpa[0], plan.waypoints_kpa[0],
                           start_state(environment_, arm_).backbone});
    plan.hold_frame_count = 2;
    plan.certified = CertifiedFigures{0.01, 0.0, true};
    return plan;
  }

  std::filesystem::path trial_path() const {
    return folder_.path() / "x/trials" / (key_.id + ".json");
  }
  std::filesystem::path plan_path() const {
    return folder_.path() / "x/plans" / (key_.id + ".json");
  }

  std::string refusal() const {
    try {
      (void)read_trial(output_.path(), key_, arm_, environment_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  std::string refusal_of(const std::function<void(Json&)>& damage) const {
    Json json = Json::parse(trial_);
    damage(json);
    write_file_atomically(trial_path(), json.dump());
    return refusal();
  }

  TemporaryFolder folder_;
  ArmDescription arm_ = load_arm(LIMBER_SOURCE_DIR "/arms/three_segment.yaml");
  Environment environment_;
  OutputFolder output_{folder_.path() / "x", "experiment", OutputFolder::Start::fresh};
  TrialKey key_;
  std::string trial_;
  std::string plan_;
};

TEST_F(TrialFile, ComesBackAfterARoundTrip) {
  const PlanTrial trial = read_trial(output_.path(), key_, arm_, environment_);
  EXPECT_EQ(trial.seed, 7U);
  EXPECT_TRUE(trial.solved());
  ASSERT_TRUE(trial.planning.plan && trial.execution && trial.execution->final_backbone);
  EXPECT_EQ(trial.execution->final_backbone->rows(), arm_.point_count());
  EXPECT_TRUE(has_trial(output_.path(), key_.id));
  const Json written = Json::parse(trial_).at("execution");
  EXPECT_TRUE(written.at("orientation_to_goal_rad").is_null()) << "the goal has no heading";
  ASSERT_TRUE(written.at("planned_goal_time_s").is_number());
  EXPECT_EQ(trial.execution->planned_goal_time_s, written.at("planned_goal_time_s").get<double>());
}

TEST_F(TrialFile, WhatIsNotKnownOfARunComesBackAsNoArrival) {
  Json json = Json::parse(trial_);
  for (const char* key : {"goal_reached", "collided", "distance_to_goal_cm",
                          "orientation_to_goal_rad", "final_backbone"}) {
    json["execution"][key] = nullptr;
  }
  write_file_atomically(trial_path(), json.dump());
  const PlanTrial trial = read_trial(output_.path(), key_, arm_, environment_);
  EXPECT_FALSE(trial.execution->final_backbone || trial.execution->collided);
  EXPECT_FALSE(has_arrived(*trial.execution));
}

TEST_F(TrialFile, DamageIsRefusedWithFileFieldAndWhatToDo) {
  struct Case {
    const char* field;
    std::function<void(Json&)> damage;
  };
  const Case cases[] = {
      {"execution.final_backbone",
       [](Json& j) { j["execution"]["final_backbone"] = {Json::array()}; }},
      {"execution.final_backbone",
       [](Json& j) { j["execution"]["final_backbone"] = Json::array(); }},
      {"execution.final_backbone[3]", [](Json& j) { j["execution"]["final_backbone"][3] = {1}; }},
      {"execution.final_backbone[3][1]",
       [](Json& j) { j["execution"]["final_backbone"][3][1] = 1e300; }},
      {"execution.final_backbone[3][1]",
       [](Json& j) { j["execution"]["final_backbone"][3][1] = nullptr; }},
      {"execution.status", [](Json& j) { j["execution"]["status"] = "bogus"; }},
      {"execution.distance_to_goal_cm",
       [](Json& j) { j["execution"]["distance_to_goal_cm"] = nullptr; }},
      {"execution", [](Json& j) { j["execution"] = nullptr; }},
      {"status", [](Json& j) { j["status"] = "bogus"; }},
      {"status", [](Json& j) { j["status"] = "limit"; }},
      {"first_solution", [](Json& j) { j["first_solution"] = nullptr; }},
      {"first_solution.cost_kpa", [](Json& j) { j["first_solution"]["cost_kpa"] = "much"; }},
      {"events", [](Json& j) { j["events"] = 3; }},
      {"nodes", [](Json& j) { j["nodes"] = -1; }},
      {"time_s", [](Json& j) { j.erase("time_s"); }},
      {"time_s", [](Json& j) { j["time_s"] = 1e308; }},
      {"environment", [](Json& j) { j["environment"] = "b"; }},
      {"model", [](Json& j) { j["model"] = "network"; }},
      {"planner", [](Json& j) { j["planner"] = "paper"; }},
      {"seed", [](Json& j) { j["seed"] = 8; }},
      {"seed", [](Json& j) { j.erase("seed"); }},
  };
  for (const Case& broken : cases) {
    EXPECT_THAT(refusal_of(broken.damage),
                AllOf(HasSubstr(trial_path().string() + ": "), HasSubstr(broken.field),
                      HasSubstr("to run it again"), HasSubstr(plan_path().string())))
        << broken.field;
  }
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("3"), trial_.substr(0, trial_.size() / 2),
        "{\"status\":" + std::string(200'000, '[') + "}", std::string("{\"nodes\": 1e999}")}) {
    write_file_atomically(trial_path(), text);
    EXPECT_THAT(refusal(), HasSubstr(trial_path().string() + ": "));
  }
}

TEST_F(TrialFile, AnotherExperimentsTrialIsRefusedByTheFieldThatDiffers) {
  const TrialKey good = key_;
  const std::pair<const char*, std::function<void(TrialKey&)>> others[] = {
      {"experiment", [](TrialKey& k) { k.experiment = "e2"; }},
      {"environment", [](TrialKey& k) { k.environment = "b"; }},
      {"environment_hash", [](TrialKey& k) { k.environment_hash = "h2"; }},
      {"model", [](TrialKey& k) { k.model = "network"; }},
      {"model_hash", [](TrialKey& k) { k.model_hash = "m"; }},
      {"planner", [](TrialKey& k) { k.planner = "paper"; }},
      {"seed", [](TrialKey& k) { k.seed = 8; }},
  };
  for (const auto& [field, change] : others) {
    key_ = good;
    change(key_);
    EXPECT_THAT(refusal(), AllOf(HasSubstr(trial_path().string()),
                                 HasSubstr(std::string("belongs_to.") + field),
                                 HasSubstr("another experiment's")));
  }
  // A copy under another trial's name.
  key_ = good;
  key_.id = "a_no_load_default_002";
  write_file_atomically(trial_path(), trial_);
  write_file_atomically(plan_path(), plan_);
  EXPECT_THAT(refusal(), HasSubstr("belongs_to.id"));
  // Of a version that did not say.
  key_ = good;
  EXPECT_THAT(refusal_of([](Json& j) { j.erase("belongs_to"); }), HasSubstr("belongs_to: missing"));
}

TEST_F(TrialFile, HoldsThePlanThatItWasWrittenWithAndNoOther) {
  Plan other = small_plan();
  other.frames.push_back(other.frames.back());
  write_plan(plan_path(), other);
  EXPECT_THAT(refusal(), AllOf(HasSubstr("belongs_to.plan"), HasSubstr(plan_path().string())));
  Json uncertified = Json::parse(plan_);
  uncertified.erase("certificate");
  write_file_atomically(plan_path(), uncertified.dump());
  EXPECT_THAT(refusal(), HasSubstr("belongs_to.plan"));
  std::filesystem::remove(plan_path());
  EXPECT_THAT(refusal(), HasSubstr(plan_path().string()));
}

TEST_F(TrialFile, APlanOfAnotherArmOrWithoutCertificateIsRefusedEvenUnderItsOwnHash) {
  const PlanTrial good = read_trial(output_.path(), key_, arm_, environment_);
  const auto refusal_with = [&](const std::function<void(Plan&)>& change) {
    PlanTrial trial = good;
    change(*trial.planning.plan);
    write_trial(output_, key_, trial, environment_);
    return refusal();
  };
  EXPECT_EQ(refusal_with([](Plan&) {}), "accepted");
  EXPECT_THAT(refusal_with([](Plan& plan) { plan.certified.reset(); }),
              HasSubstr("certificate: missing"));
  EXPECT_THAT(refusal_with([](Plan& plan) { plan.environment_hash = "h2"; }),
              HasSubstr("environment.hash"));
  EXPECT_THAT(refusal_with([](Plan& plan) { plan.arm_hash = "0123"; }), HasSubstr("arm"));
  EXPECT_THAT(refusal_with([](Plan& plan) { plan.seed = 8; }), HasSubstr("seed"));
}

}  // namespace
}  // namespace limber
