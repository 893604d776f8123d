#include "limber/planning/ompl_planner.hpp"

#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/play_model.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class OmplPlanner : public ::testing::Test {
 protected:
  void SetUp() override {
    if (ompl_planner_names().empty()) {
      GTEST_SKIP() << "built without OMPL";
    }
    environment_.name = "pillar";
    environment_.obstacles = {Circle{0.45, 0.22, 0.025}};
    environment_.goal = {0.30, 0.40, std::nullopt, 0.05, 0.3};
  }

  PlanResult plan(const std::string& planner, std::uint64_t queries, double threshold_kpa = 1e6) {
    PlannerLimits limits;
    limits.queries = queries;
    limits.cost_threshold_kpa = threshold_kpa;
    return make_planner(planner)->plan({arm_, model_, environment_}, limits, 1);
  }

  /// "SST: 12 active nodes, 3 inactive, 12 witnesses"
  static void read_counts(const PlanResult& result, int& active, int& inactive, int& witnesses) {
    for (const std::string& warning : result.warnings) {
      if (std::sscanf(warning.c_str(), "SST: %d active nodes, %d inactive, %d witnesses", &active,
                      &inactive, &witnesses) == 3) {
        return;
      }
    }
    ADD_FAILURE() << "no counts among the warnings";
  }

  ArmDescription arm_ = three_segment_arm();
  ForwardModel model_{arm_, play_network(arm_, 0.005F)};
  Environment environment_;
};

TEST_F(OmplPlanner, EveryPlannerRunsAndWhatItSolvesIsCertified) {
  int solved = 0;
  for (const std::string& name : ompl_planner_names()) {
    const PlanResult result = plan(name, 30000);
    EXPECT_NE(result.status, PlanStatus::not_certified) << result.reason;
    EXPECT_EQ(result.plan.has_value(), result.status == PlanStatus::solved) << name;
    if (result.plan) {
      ++solved;
      EXPECT_EQ(result.plan->planner, name);
      EXPECT_TRUE(result.certificate->certified());
      EXPECT_GT(result.first_solution->cost_kpa, 0.0);
    } else {
      EXPECT_EQ(result.limit, PlanLimit::queries) << name << ": " << result.reason;
    }
  }
  EXPECT_GE(solved, 2) << "an easy problem";
}

TEST_F(OmplPlanner, DependsOnItsSeedAndNotOnThePlansBefore) {
  for (const std::string& name : ompl_planner_names()) {
    for (const char* settings : {"", ",directed=0"}) {
      SCOPED_TRACE(name + settings);
      const auto waypoints = [](const PlanResult& result) {
        return (result.plan ? result.plan : result.best_partial).value_or(Plan{}).waypoints_kpa;
      };
      const PlanResult first = plan(name + settings, 3000);
      const PlanResult again = plan(name + settings, 3000);
      EXPECT_EQ(first.statistics.nodes, again.statistics.nodes);
      EXPECT_EQ(first.statistics.queries, again.statistics.queries);
      EXPECT_EQ(waypoints(first), waypoints(again));
    }
  }
}

// SST goes on after its first plan. What it found earlier was certified then, so that a search that
// ends in the middle of its work has a plan.
TEST_F(OmplPlanner, SstIsCertifiedWhileItSearches) {
  const std::uint64_t queries = 60000;
  const PlanResult result = plan("ompl:SST", queries, 1.0);
  ASSERT_TRUE(result.plan) << result.reason;
  const FirstSolution& first = *result.first_solution;
  EXPECT_LT(first.queries, queries / 2);
  EXPECT_LT(first.time_s, result.statistics.time_s);
  EXPECT_LE(result.plan->cost_kpa, first.cost_kpa);
  EXPECT_GE(first.time_s, first.candidate_s + first.certificate_s - 1e-9);
}

TEST_F(OmplPlanner, SstAsShippedNeverPrunes) {
  int active = 0, inactive = 0, witnesses = 0;
  read_counts(plan("ompl:SST,pruning_radius=0.3,selection_radius=0.5", 20000, 1.0), active,
              inactive, witnesses);
  EXPECT_EQ(inactive, 0) << "what prunes it? Then docs/planning.md is out of date";
  EXPECT_GT(active, 2 * witnesses);
}

TEST_F(OmplPlanner, UnknownNamesSettingsAndLimitsAreRefused) {
  EXPECT_THAT([] { make_planner("ompl:Fast"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("ompl:Fast"), HasSubstr("ompl:RRT"))));
  EXPECT_THAT(
      [] { make_planner("ompl:RRT,frames=0"); },
      ThrowsMessage<InputError>(HasSubstr("frames = '0'; expected a number from 1 to 100")));
  EXPECT_THAT([&] { (void)plan("ompl:RRT,speed=3", 100); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("speed=3"), HasSubstr("goal_bias"))));
  for (const auto& [key, value, range] :
       {std::tuple{"pruning_radius", "abc", "0 to 100"}, std::tuple{"goal_bias", "2", "0 to 1"},
        std::tuple{"selection_radius", "1e999", "0 to 100"}}) {
    const std::string name = fmt::format("ompl:SST,{}={}", key, value);
    EXPECT_THAT([&] { (void)plan(name, 100); },
                ThrowsMessage<InputError>(HasSubstr(fmt::format(
                    "planner setting {} = '{}'; expected a number from {}", key, value, range))));
  }
  PlannerLimits limits;
  limits.iterations = 10;
  EXPECT_THAT(
      [&] {
        (void)make_planner("ompl:RRT")->plan({arm_, model_, environment_}, limits, 1);
      },
      ThrowsMessage<InputError>(HasSubstr("limit time or queries")));
}

}  // namespace
}  // namespace limber
