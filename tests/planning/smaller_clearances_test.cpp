#include "src/planning/certified/certified_planner.hpp"

#include <gmock/gmock.h>

#include "limber/planning/plan_builder.hpp"
#include "planning/planner_setting.hpp"
#include "src/planning/search/default_planner.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

/// Finds this motion, whatever is asked for.
class Given final : public Planner {
 public:
  explicit Given(std::vector<Pressures> waypoints_kpa) : waypoints_kpa_(std::move(waypoints_kpa)) {}
  const char* name() const override { return "given"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& /*limits*/,
                  std::uint64_t seed, const PlannerCallback& /*callback*/) override {
    const CollisionChecker checker = checker_of(problem);
    MotionSimulator simulator(problem.arm, problem.model, checker);
    PlanResult result;
    result.status = PlanStatus::solved;
    result.plan = build_plan(problem, simulator, waypoints_kpa_, name(), seed);
    result.first_solution = FirstSolution{};
    return result;
  }

 private:
  std::vector<Pressures> waypoints_kpa_;
};

class SmallerClearances : public ::testing::Test {
 protected:
  PlanResult try_with(PlannerLimits limits, const PlannerStatistics& spent, double patience = 0.0,
                      const PlannerCallback& callback = {}) {
    limits.patience = patience;  // 0: the tries may have all of it
    PlanResult result;
    result.statistics = spent;
    result.reason = "nothing was found";
    AskedProblem asked(problem_);
    try_smaller_clearances(*make_default_planner(), problem_, asked, limits,
                           std::chrono::steady_clock::now(), 3, callback, result);
    return result;
  }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment, 0.08};
};

TEST_F(SmallerClearances, WhereNothingKeepsItTheLargestThatGaveAPlanIsNamed) {
  constexpr double kTooMuchM = 0.08;
  PlannerLimits limits;
  limits.iterations = 40000;  // of which a tenth goes into smaller clearances
  const PlanResult result = make_planner("default")->plan(
      {setting_.arm, setting_.model, setting_.environment, kTooMuchM}, limits, 3);
  ASSERT_FALSE(result.plan);
  ASSERT_TRUE(result.max_clearance_m) << result.reason;
  EXPECT_LT(*result.max_clearance_m, kTooMuchM);
  EXPECT_GT(*result.max_clearance_m, 0.0);
  EXPECT_THAT(result.reason, HasSubstr("with less clearance than the 8.00 cm asked for"));
  EXPECT_LE(result.statistics.iterations, 40000U);
}

TEST_F(SmallerClearances, SpendNoMoreThanWhatIsLeft) {
  PlannerLimits limits;
  limits.iterations = 1000;
  PlannerStatistics spent;
  spent.iterations = 1000;
  spent.queries = 77;
  const PlanResult nothing_left = try_with(limits, spent);
  EXPECT_EQ(nothing_left.statistics.queries, 77U);
  EXPECT_EQ(nothing_left.reason, "nothing was found");
  EXPECT_FALSE(nothing_left.max_clearance_m);
  spent.iterations = 100;
  limits.queries = 300;
  const PlanResult hardly_any = try_with(limits, spent);
  EXPECT_GT(hardly_any.statistics.queries, 77U) << "what tries take is added";
}

TEST_F(SmallerClearances, SpendNoMoreThanWasKeptBackHoweverEarlyTheSearchEnded) {
  setting_.environment.obstacles = {Rectangle{0.0, 0.33, 2.0, 0.02, 0.0}};  // no way around
  PlannerLimits limits;
  limits.iterations = 40000;
  constexpr std::uint64_t kRounds = 1000;  // of edges tried side by side, in four tries
  const PlanResult result = try_with(limits, {}, 0.9);
  EXPECT_LE(result.statistics.iterations, 4000U + kRounds);
}

// They are nobody's plans, and go on where the search has ended.
TEST_F(SmallerClearances, AreWatchedAsThePartOfTheSearchThatTheyAre) {
  PlannerLimits limits;
  limits.iterations = 8000;
  PlannerStatistics spent;
  spent.iterations = 100;
  spent.queries = 77;
  int calls = 0;
  const PlanResult result = try_with(limits, spent, 0.0, [&](const PlannerProgress& now) {
    ++calls;
    EXPECT_FALSE(now.best_cost_kpa);
    EXPECT_GE(now.iterations, 100U);
    EXPECT_GE(now.queries, 77U);
    return true;
  });
  EXPECT_GT(calls, 0);
  EXPECT_TRUE(result.max_clearance_m) << result.reason;
}

// A search with less clearance may come upon a plan that keeps what was asked for.
TEST_F(SmallerClearances, APlanThatKeepsWhatWasAskedForIsTheAnswer) {
  constexpr double kEasyM = 0.002;
  problem_.margin_m = kEasyM;
  PlannerLimits limits;
  limits.iterations = 8000;
  const PlanResult result = try_with(limits, {});
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  ASSERT_TRUE(result.plan);
  EXPECT_EQ(result.plan->margin_m, kEasyM);
  EXPECT_GE(result.plan->certified->clearance_m, kEasyM);
  EXPECT_FALSE(result.max_clearance_m);
  EXPECT_GT(result.first_solution->queries, 0U);
  expect_lawful(setting_, *result.plan);
}

// With so much play the tip follows ten centimetres behind, and ends beside the goal.
TEST_F(SmallerClearances, APlanThatAnotherNetworkRefusesDoesNotKeepIt) {
  constexpr double kAskedM = 0.004;
  constexpr double kKeptM = 0.005;
  const ArmDescription& arm = setting_.arm;
  CompensationModel network = play_network(arm, 0.005F);
  const ForwardModel leading(arm, network);
  PlannerLimits limits;
  limits.iterations = 1000;
  const PlanResult found =
      make_planner("default")->plan({arm, leading, setting_.environment, kKeptM}, limits, 3);
  ASSERT_TRUE(found.plan) << found.reason;
  limits.patience = 0.0;  // the tries may have all of it
  for (const bool has_second : {false, true}) {
    if (has_second) {
      network.more_members.push_back(play_network(arm, 0.1F).layers);
    }
    const ForwardModel model(arm, network);
    const PlanningProblem problem{arm, model, setting_.environment, kAskedM};
    Given planner(found.plan->waypoints_kpa);
    AskedProblem asked(problem);
    PlanResult result;
    try_smaller_clearances(planner, problem, asked, limits, std::chrono::steady_clock::now(), 3, {},
                           result);
    EXPECT_EQ(result.plan.has_value(), !has_second) << result.reason;
    EXPECT_EQ(result.max_clearance_m.has_value(), has_second) << result.reason;
  }
}

// What is named is no promise: a search that asks for a little less finds a plan.
TEST_F(SmallerClearances, TheOneNamedIsKeptByAPlan) {
  PlannerLimits limits;
  limits.iterations = 8000;
  const PlanResult result = try_with(limits, {});
  ASSERT_TRUE(result.max_clearance_m) << result.reason;
  EXPECT_THAT(result.reason, HasSubstr("nothing was found; with less clearance than the 8.00 cm"));
  EXPECT_FALSE(result.plan) << "nobody asked for less";
  PlannerLimits whole;
  whole.iterations = 10000;
  const double kept_m = *result.max_clearance_m;
  const auto plan_with = [&](double margin_m) {
    return make_planner("default")->plan(
        {setting_.arm, setting_.model, setting_.environment, margin_m}, whole, 3);
  };
  const PlanResult with_that = plan_with(0.9 * kept_m);
  ASSERT_TRUE(with_that.plan) << with_that.reason;
  expect_lawful(setting_, *with_that.plan);
}

}  // namespace
}  // namespace limber
