#include "limber/planning/planner.hpp"

#include <atomic>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/world/collision.hpp"
#include "planning/planner_setting.hpp"
#include "src/planning/paper/pressure_rrt_star.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

TEST(Planner, TakesSettingsWithItsName) {
  Setting s(false);
  const PlanResult bare = s.plan("default,improved_plans=0", 1500);
  const PlanResult improved = s.plan("default", 1500);
  ASSERT_EQ(bare.status, PlanStatus::solved);
  ASSERT_EQ(improved.status, PlanStatus::solved);
  EXPECT_LT(improved.plan->cost_kpa, bare.plan->cost_kpa);
  const auto refusal = [](const char* name, const char* message) {
    EXPECT_THAT([&] { (void)make_planner(name); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refusal("default,goal_shot=0", "planner setting goal_shot: the default planner has step_size");
  refusal("default,goal_steering_share",
          "planner setting 'goal_steering_share'; expected NAME,key=value");
  refusal("default,goal_steering_share=x", "goal_steering_share = 'x'; expected a number");
  refusal("default,goal_steering_share=2",
          "goal_steering_share = '2'; expected a number from 0 to 1");
  refusal("default,goal_steering_share=0,goal_steering_share=1",
          "planner setting goal_steering_share: given twice");
  refusal("default,improved_plans=2.5", "improved_plans = 2.5; expected a whole number");
  refusal("default,goal_steering_share=0.6,goal_bias=0.6",
          "goal_bias + goal_steering_share = 1.2; expected 0 to 1");
  refusal("paper,goal_steering_share=0",
          "planner setting goal_steering_share: unknown; 'paper' has the setting valves");
}

TEST(Planner, LogsHowTheCostFell) {
  Setting s(false);
  const PlanResult result = s.plan("default", 1500);
  ASSERT_EQ(result.status, PlanStatus::solved);
  ASSERT_GE(result.events.size(), 2U);
  EXPECT_EQ(result.events.front().best_cost_kpa, result.first_solution->cost_kpa);
  for (std::size_t i = 1; i < result.events.size(); ++i) {
    EXPECT_GE(result.events[i].queries, result.events[i - 1].queries);
    EXPECT_LE(*result.events[i].best_cost_kpa, *result.events[i - 1].best_cost_kpa);
  }
  EXPECT_EQ(result.events.back().queries, result.statistics.queries);
  constexpr double kRoundingKpa = 0.1;  // the sum over frames, against that over waypoints
  EXPECT_NEAR(*result.events.back().best_cost_kpa, result.plan->cost_kpa, kRoundingKpa);
}

TEST(Planner, LogsAPlanThatCostsNothingOnce) {
  Setting s(false);
  s.environment.goal = {s.arm.length_m(), 0.0, std::nullopt, 0.02, 0.3};
  for (const char* planner : {"default", "paper"}) {
    const PlanResult result = s.plan(planner, 300);
    ASSERT_EQ(result.status, PlanStatus::solved);
    EXPECT_LE(result.events.size(), 2U) << planner;
  }
}

TEST(Planner, EveryPlanIsLawful) {
  for (const bool play : {false, true}) {
    Setting s(play);
    for (const char* planner : {"paper", "default"}) {
      const PlanResult result = s.plan(planner, 1500, 3);
      ASSERT_EQ(result.status, PlanStatus::solved) << planner << ' ' << play;
      EXPECT_EQ(result.limit, PlanLimit::iterations);
      EXPECT_FALSE(result.best_partial);
      EXPECT_GE(result.first_solution->cost_kpa, result.plan->cost_kpa - 1e-3);
      EXPECT_EQ(result.plan->planner, planner);
      EXPECT_EQ(result.plan->model, play ? "network" : "no_load");
      expect_lawful(s, *result.plan);
    }
  }
}

TEST(Planner, PosesWithAHeadingAreReachedInIt) {
  Setting s(false);
  s.environment.goal.theta_rad = 2.2;
  s.environment.goal.orientation_tolerance_rad = 0.2;
  const PlanResult result = s.plan("paper", 3000);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LE(std::abs(std::remainder(result.plan->frames.back().backbone(15, 2) - 2.2, 2 * M_PI)),
            0.2);
  expect_lawful(s, *result.plan);
}

TEST(Planner, CostNeverRisesWithTheBudget) {
  for (const char* planner : {"paper", "default"}) {
    Setting s(true);
    double before = std::numeric_limits<double>::infinity();
    for (const std::uint64_t iterations : {200, 400, 800, 1600}) {
      const PlanResult result = s.plan(planner, iterations);
      const double cost =
          result.plan ? result.plan->cost_kpa : std::numeric_limits<double>::infinity();
      EXPECT_LE(cost, before + 1e-3) << planner << ' ' << iterations;
      before = cost;
    }
    EXPECT_LT(before, 1000.0) << "solved in the end";
  }
}

TEST(Planner, ImprovingFindsCheaperPlansThanTheTreeAlone) {
  Setting s(true);
  PlannerLimits limits;
  limits.queries = 100'000;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const PlanResult paper = make_planner("paper")->plan(problem, limits, 3);
  const PlanResult improved = make_planner("default")->plan(problem, limits, 3);
  ASSERT_TRUE(paper.plan && improved.plan);
  EXPECT_LT(improved.plan->cost_kpa, paper.plan->cost_kpa);
}

TEST(Planner, PlanIsTheSameForAnyNumberOfThreads) {
  Setting s(true);
  PlannerLimits limits;
  limits.iterations = 2000;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const PlanResult one = make_planner("default", 1)->plan(problem, limits, 3);
  ASSERT_TRUE(one.plan);
  for (const int jobs : {2, 3}) {
    const PlanResult many = make_planner("default", jobs)->plan(problem, limits, 3);
    ASSERT_TRUE(many.plan);
    EXPECT_EQ(many.plan->waypoints_kpa, one.plan->waypoints_kpa) << jobs << " threads";
    EXPECT_EQ(many.statistics.queries, one.statistics.queries);
  }
}

/// One segment whose plates lag behind its pressure. The goal's heading leaves one pressure, and
/// its place only those who come back to it from beyond.
class OvershootAndReturn : public ::testing::Test {
 protected:
  static constexpr float kWidePlayM = 0.02F;

  void SetUp() override {
    const Pressures ways_kpa[] = {Pressures::Zero(1), Pressures::Constant(1, 90.0F),
                                  Pressures::Constant(1, 60.0F)};
    MotionSimulator simulator(arm_, model_, checker_);
    std::vector<PlanFrame> frames{
        {ways_kpa[0], ways_kpa[0], start_state(environment_, arm_).backbone}};
    simulator.append_motion(ways_kpa[1], frames);
    simulator.append_motion(ways_kpa[2], frames);
    const Pose tip = tip_pose(frames.back().backbone);
    environment_.goal = {tip.x_m, tip.y_m, tip.theta_rad, 0.3 * double(kWidePlayM), 0.02};
  }

  int solved(const char* planner) {
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      PlannerLimits limits;
      limits.queries = 100'000;
      limits.iterations = 100'000;
      count += make_planner(planner)->plan({arm_, model_, environment_}, limits, seed).plan ? 1 : 0;
    }
    return count;
  }

  ArmDescription arm_ = sample_arm(1);
  ForwardModel model_{arm_, play_network(arm_, kWidePlayM)};
  Environment environment_;
  CollisionChecker checker_{arm_, {}};
};

TEST_F(OvershootAndReturn, IsFoundByTheDefaultPlannerAlways) {
  EXPECT_EQ(solved("default"), 20);
}

TEST_F(OvershootAndReturn, IsNotFoundByThePapersRule) {
  EXPECT_EQ(solved("paper"), 0);
}

TEST(Planner, DependsOnTheSeedAndNothingElse) {
  for (const char* planner : {"paper", "default"}) {
    Setting s(true);
    const PlanResult a = s.plan(planner, 500, 7);
    const PlanResult b = s.plan(planner, 500, 7);
    EXPECT_TRUE(same_tree(a, b));
    EXPECT_EQ(a.statistics.queries, b.statistics.queries);
    ASSERT_EQ(a.plan.has_value(), b.plan.has_value());
    if (a.plan) {
      EXPECT_EQ(a.plan->waypoints_kpa, b.plan->waypoints_kpa);
    }
    EXPECT_FALSE(same_tree(a, s.plan(planner, 500, 8)));
  }
}

// The paper's point: a plan made without the arm's memory misses the goal on the arm that has one.
TEST(Planner, APlanOfTheNoLoadModelMissesTheGoalOnAnArmWithPlay) {
  Setting s(false);
  const PlanResult result = s.plan("paper", 800);
  ASSERT_TRUE(result.plan);
  constexpr float kWidePlayM = 0.05F;
  const ForwardModel arm(s.arm, play_network(s.arm, kWidePlayM));
  Backbone b = result.plan->frames.front().backbone;
  for (std::size_t k = 1; k < result.plan->frames.size(); ++k) {
    b = arm.checked_step(result.plan->frames[k - 1].setpoint_kpa,
                         result.plan->frames[k].setpoint_kpa, b);
  }
  EXPECT_GT(std::hypot(b(15, 0) - 0.30, b(15, 1) - 0.40), 0.02);
}

TEST(Planner, CallsNothingASolutionThatIsNone) {
  Setting s(false);
  // A ring of four walls about the goal.
  s.environment.obstacles = {
      Rectangle{0.30, 0.46, 0.16, 0.02, 0.0}, Rectangle{0.30, 0.34, 0.16, 0.02, 0.0},
      Rectangle{0.37, 0.40, 0.02, 0.14, 0.0}, Rectangle{0.23, 0.40, 0.02, 0.14, 0.0}};
  const PlanResult result = s.plan("default", 600);
  EXPECT_EQ(result.status, PlanStatus::limit);
  EXPECT_EQ(result.limit, PlanLimit::iterations);
  EXPECT_FALSE(result.plan);
  EXPECT_FALSE(result.first_solution);
  ASSERT_TRUE(result.best_partial);
  EXPECT_GT(result.best_partial->goal_distance_m, 0.02);
  const CollisionChecker checker(s.arm, s.environment.obstacles);
  const std::vector<PlanFrame>& frames = result.best_partial->frames;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    EXPECT_TRUE(checker.is_motion_free(frames[k - 1].backbone, frames[k].backbone)) << k;
  }
  EXPECT_THAT(result.reason, AllOf(HasSubstr("600 iterations spent"), HasSubstr("seed 3"),
                                   HasSubstr("(tolerance 2.0 cm)")));
}

TEST(Planner, StopsAtEachLimitAndSaysWhich) {
  Setting s(false);
  const auto planner = make_planner("paper");
  const PlanningProblem problem{s.arm, s.model, s.environment};
  PlannerLimits queries;
  queries.queries = 2000;
  const PlanResult by_queries = planner->plan(problem, queries, 1);
  EXPECT_EQ(by_queries.limit, PlanLimit::queries);
  EXPECT_GE(by_queries.statistics.queries, 2000U);

  PlannerLimits memory;
  memory.iterations = 100000;
  memory.memory_mb = 0.05;
  EXPECT_EQ(planner->plan(problem, memory, 1).limit, PlanLimit::memory);

  PlannerLimits time;
  time.time_s = 0.05;
  EXPECT_EQ(planner->plan(problem, time, 1).limit, PlanLimit::time);

  PlannerLimits first;
  first.iterations = 100000;
  first.cost_threshold_kpa = 1e6;
  const PlanResult at_first = planner->plan(problem, first, 1);
  EXPECT_EQ(at_first.status, PlanStatus::solved);
  EXPECT_FALSE(at_first.limit);
  EXPECT_LT(at_first.statistics.iterations, 100000U);

  PlannerLimits many;
  many.iterations = 1000000;
  int calls = 0;
  const PlanResult stopped = planner->plan(problem, many, 1, [&](const PlannerProgress& now) {
    EXPECT_GE(now.nodes, 1U);
    return ++calls < 2;
  });
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(stopped.reason.rfind("stopped by the user", 0), 0U);
}

// Every sample falls on the start: no query would ever be spent.
TEST(Planner, EndsUnderALimitOfQueriesAloneWhereThereIsNothingToTry) {
  Setting s(false);
  PlanningProblem problem{s.arm, s.model, s.environment};
  problem.limits.assign(3, PressureLimits(0.001));
  PlannerLimits limits;
  limits.queries = 2000;
  const PlanResult result = make_planner("paper")->plan(problem, limits, 1);
  EXPECT_EQ(result.status, PlanStatus::limit);
  EXPECT_FALSE(result.limit) << result.reason;
  EXPECT_THAT(result.reason, StartsWith("nothing left to try, 1 nodes, seed 1; the nearest"));
  EXPECT_EQ(result.statistics.nodes, 1U);
  EXPECT_LT(result.statistics.queries, 2000U);
}

TEST(Planner, KeepsTheCertifiedPlanWhereItIsStopped) {
  Setting s(false);
  PlannerLimits many;
  many.iterations = 1000000;
  for (const char* name : {"paper", "default"}) {
    std::atomic<bool> stop = false;
    const StopScope scope(&stop);
    const PlanResult stopped = make_planner(name)->plan({s.arm, s.model, s.environment}, many, 1,
                                                        [&](const PlannerProgress& now) {
                                                          stop = now.best_cost_kpa.has_value();
                                                          return true;
                                                        });
    EXPECT_TRUE(stop) << name;
    ASSERT_EQ(stopped.status, PlanStatus::solved) << name << ": " << stopped.reason;
    EXPECT_TRUE(stopped.plan->certified) << name;
  }
}

TEST(Planner, RefusesMissingAndSenselessLimitsAndSettings) {
  Setting s(false);
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const auto plan_with = [&](const PlannerLimits& limits) {
    (void)make_planner("paper")->plan(problem, limits, 1);
  };
  EXPECT_THAT([&] { plan_with({}); },
              ThrowsMessage<InputError>(HasSubstr("needs a limit of time, iterations or queries")));
  PlannerLimits negative;
  negative.time_s = -1.0;
  EXPECT_THAT([&] { plan_with(negative); },
              ThrowsMessage<InputError>(HasSubstr("time limit [s] of -1; expected a number > 0")));
  EXPECT_THAT([] { make_planner("fast"); },
              ThrowsMessage<InputError>(
                  HasSubstr("'fast'; expected one of default, paper, paper-steer-all or")));
}

TEST(Planner, AGoalAtTheStartIsAPlanThatStandsStill) {
  Setting s(false);
  s.environment.goal = {0.705, 0.0, std::nullopt, 0.02, 0.3};
  const PlanResult result = s.plan("default", 50);
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_EQ(result.plan->cost_kpa, 0.0);
  EXPECT_EQ(result.plan->frame_count(), 21);
}

TEST(Planner, NamesWhatIsWrongWithAProblemBeforePlanning) {
  Setting s(false);
  s.environment.obstacles.push_back(Circle{0.3, 0.04, 0.05});
  PlanResult result = s.plan("paper", 10);
  EXPECT_EQ(result.status, PlanStatus::invalid_start);
  EXPECT_THAT(result.reason, AllOf(HasSubstr("cm deep in obstacle 3 (circle)"),
                                   HasSubstr("between plates 6 and 7 (segment 1)")));
  EXPECT_EQ(result.statistics.queries, 0U);

  s.environment = pillars();
  s.environment.goal.x_m = 0.7;
  result = s.plan("paper", 10);
  EXPECT_EQ(result.status, PlanStatus::goal_unreachable);
  EXPECT_THAT(result.reason, AllOf(HasSubstr("8.12 cm beyond the arm's reach"),
                                   HasSubstr("the arm is 70.5 cm long")));

  s.environment = pillars();
  s.environment.goal.x_m = 0.45;
  s.environment.goal.y_m = 0.22;
  result = s.plan("paper", 10);
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_THAT(result.reason, AllOf(HasSubstr("2.50 cm inside obstacle 0 (circle)"),
                                   HasSubstr("1.96 cm are missing")));

  // Within the arm's length, but no arc of it bends there: only a warning.
  s.environment = pillars();
  s.environment.obstacles.clear();
  s.environment.goal.x_m = -0.6;
  s.environment.goal.y_m = 0.0;
  result = s.plan("paper", 10);
  EXPECT_EQ(result.status, PlanStatus::limit);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_THAT(result.warnings[0], HasSubstr("the no-load model reaches no closer to the goal"));
}

// Clamped in silence, it came into the plan's file, which nothing reads.
TEST(Planner, RefusesAMarginThatIsNone) {
  Setting s(false);
  PlannerLimits limits;
  limits.iterations = 10;
  for (const double margin_m : {-1.0, -1e-9, 2e3, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(
        [&] {
          (void)make_planner("default")->plan({s.arm, s.model, s.environment, margin_m}, limits, 1);
        },
        ThrowsMessage<InputError>(AllOf(HasSubstr("margin_m = "), HasSubstr("0 to 1000"))));
  }
}

TEST(Planner, AStartThatIsNoArmIsInvalid) {
  Setting s(false);
  s.environment.start = ArmStart{Pressures::Zero(3), Backbone::Zero(16, 3)};
  const PlanResult result = s.plan("default", 10);
  EXPECT_EQ(result.status, PlanStatus::invalid_start);
  EXPECT_THAT(result.reason, HasSubstr("start.backbone[1]: plate 1 is 0 m from plate 0"));
}

TEST(Planner, MarginKeepsTheArmAway) {
  Setting s(false);
  PlannerLimits limits;
  limits.iterations = 2000;
  constexpr double kMarginM = 0.01;
  const PlanResult result =
      make_planner("default")->plan({s.arm, s.model, s.environment, kMarginM}, limits, 3);
  ASSERT_TRUE(result.plan);
  EXPECT_GE(result.plan->clearance_m, kMarginM);
  EXPECT_EQ(result.plan->margin_m, kMarginM);
}

TEST(Planner, NamesOfStatusesAndLimitsAreThoseOfTheFiles) {
  EXPECT_STREQ(to_string(PlanStatus::goal_in_collision), "goal_in_collision");
  EXPECT_STREQ(to_string(PlanStatus::not_certified), "not_certified");
  EXPECT_STREQ(to_string(PlanLimit::queries), "queries");
  EXPECT_THAT(planner_names(), ElementsAre("default", "paper"));
}

}  // namespace
}  // namespace limber
