#include "limber/planning/planner_factory.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/ompl_planner.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

void expect_refusal(const std::string& name, const std::vector<std::string>& parts) {
  try {
    (void)make_planner(name);
    ADD_FAILURE() << name << " was made";
  } catch (const InputError& error) {
    for (const std::string& part : parts) {
      EXPECT_THAT(error.what(), HasSubstr(part));
    }
  }
}

TEST(PlannerFactory, MakesAPlannerOfEveryNameThatItGives) {
  ASSERT_THAT(planner_names(), testing::Not(IsEmpty()));
  EXPECT_EQ(planner_names().front(), "default");
  for (const std::string& name : planner_names()) {
    EXPECT_EQ(make_planner(name)->name(), name);
    EXPECT_EQ(is_default_planner(name), name == "default");
  }
  for (const std::string& name : ompl_planner_names()) {
    EXPECT_EQ(make_planner(name)->name(), name);
    EXPECT_FALSE(is_default_planner(name));
  }
}

// Whoever made it: solved means certified, and the plan says whose it is.
TEST(PlannerFactory, EveryPlannersPlanIsCertifiedAndNamesIt) {
  Setting setting(false);
  for (const std::string& name : planner_names()) {
    const PlanResult result = setting.plan(name, 1500);
    EXPECT_EQ(result.plan.has_value(), result.status == PlanStatus::solved) << name;
    if (result.plan) {
      EXPECT_EQ(result.plan->planner, name);
      ASSERT_TRUE(result.certificate && result.plan->certified) << name;
      EXPECT_TRUE(result.certificate->certified()) << name;
    }
  }
}

TEST(PlannerFactory, RefusesOtherNamesWithTheListOfItsOwn) {
  std::vector<std::string> known = planner_names();
  known.emplace_back("ompl:NAME");
  for (const char* name : {"", "Default", "rrt", "paper ", "defaults", "no,valves=1"}) {
    expect_refusal(name, known);
  }
}

TEST(PlannerFactory, SettingsFollowTheName) {
  EXPECT_EQ(std::string(make_planner("default,improved_plans=0")->name()),
            "default,improved_plans=0");
  EXPECT_TRUE(is_default_planner("default,improved_plans=0"));
  expect_refusal("default,fast=1", {"fast"});
  expect_refusal("paper,speed=1", {"planner setting speed: unknown", "valves"});
  expect_refusal("paper,valves=2", {"valves = '2'", "from 0 to 1"});
  if (!ompl_planner_names().empty()) {
    expect_refusal("ompl:RRT,frames=2.9", {"frames = 2.9; expected a whole number"});
  }
  expect_refusal("paper,valves=0.5", {"valves = 0.5; expected a whole number"});
  expect_refusal("default,improved_plans", {"expected NAME,key=value"});
}

TEST(PlannerFactory, GivesAForestToTheDefaultPlannerAlone) {
  const Forest none;
  EXPECT_NO_THROW((void)make_planner("default", 1, &none));
  for (const std::string& name : planner_names()) {
    if (!is_default_planner(name)) {
      EXPECT_THAT([&] { (void)make_planner(name, 1, &none); },
                  ThrowsMessage<InputError>(
                      AllOf(HasSubstr(name), HasSubstr("uses no forest; only 'default' does"))));
    }
  }
}

// As published, pressures are the set points; a setting asks for the valves.
TEST(PlannerFactory, ThePapersPlannerLeavesTheValvesOutUnlessAsked) {
  Setting setting(false);
  const ValveParameters valves{true, std::vector<SegmentValves>(3, {{0.1, 100.0}, {0.1, 100.0}})};
  const MotionModel model(setting.model, ValveModel(setting.arm, valves));
  PlannerLimits limits;
  limits.iterations = 3000;
  const auto valves_of = [&](const char* name) -> std::string {
    const PlanResult result =
        make_planner(name)->plan({setting.arm, model, setting.environment}, limits, 3);
    const std::optional<Plan>& plan = result.plan ? result.plan : result.best_partial;
    EXPECT_TRUE(plan) << name;
    return plan ? plan->valves_hash : "no plan";
  };
  EXPECT_EQ(valves_of("paper"), "");
  EXPECT_EQ(valves_of("paper,valves=1"), valves.hash());
}

}  // namespace
}  // namespace limber
