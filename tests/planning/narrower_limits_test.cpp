#include <gmock/gmock.h>

#include "limber/certificate/certificate.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<PressureLimits> kNarrow = {
    PressureLimits(-95.0, 60.0), PressureLimits(-90.0, 65.0), PressureLimits(-95.0, 70.0)};

/// A goal to the left, and less pressure to the right.
struct Narrowed {
  Setting setting{false};
  PlanningProblem problem{setting.arm, setting.model, setting.environment};

  Narrowed() { problem.limits = kNarrow; }

  PlanResult plan(const std::string& planner, const Forest* forest = nullptr) {
    PlannerLimits limits;
    limits.iterations = 3000;
    return make_planner(planner, 1, forest)->plan(problem, limits, 3);
  }
};

void expect_within(const Plan& plan, const std::vector<PressureLimits>& limits) {
  EXPECT_EQ(plan.limits, limits);
  const auto look = [&](const Pressures& kpa) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      EXPECT_TRUE(limits[i].contains(double(kpa[Eigen::Index(i)])))
          << kpa[Eigen::Index(i)] << " of segment " << i;
    }
  };
  for (const Pressures& waypoint : plan.waypoints_kpa) {
    look(waypoint);
  }
  for (const PlanFrame& frame : plan.frames) {
    look(frame.setpoint_kpa);
  }
}

TEST(NarrowerLimits, NoSetPointOfAnyPlannerIsBeyondThem) {
  for (const char* planner : {"default", "paper"}) {
    SCOPED_TRACE(planner);
    Narrowed n;
    const PlanResult result = n.plan(planner);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    expect_within(*result.plan, kNarrow);
    EXPECT_TRUE(
        certify(*result.plan, n.setting.arm, nullptr, {}, n.setting.environment).certified());
    EXPECT_EQ(result.plan->arm_hash, n.setting.arm.hash()) << "it is still the arm's plan";
  }
}

TEST(NarrowerLimits, AForestOfTheArmServesThem) {
  Narrowed n;
  const ArmStart start = start_state(n.setting.environment, n.setting.arm);
  ForestSettings settings;
  settings.nodes = 4000;
  const Forest forest = *grow_forest(n.setting.arm, n.setting.model,
                                     forest_key(n.setting.arm, "", {}, start), start, settings);
  ASSERT_GT(forest.highest_kpa.minCoeff(), 70.0F) << "it goes beyond them";
  const PlanResult result = n.plan("default", &forest);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  expect_within(*result.plan, kNarrow);
}

TEST(NarrowerLimits, AsWideAsTheArmsChangeNothing) {
  Narrowed n;
  n.problem.limits.assign(3, n.setting.arm.segments[0].pressure_limit_kpa);
  for (const char* planner : {"default", "paper"}) {
    const PlanResult wide = n.plan(planner);
    const PlanResult none = n.setting.plan(planner, 3000);
    ASSERT_TRUE(wide.plan && none.plan);
    EXPECT_EQ(wide.plan->waypoints_kpa, none.plan->waypoints_kpa) << planner;
    EXPECT_EQ(wide.statistics.queries, none.statistics.queries);
  }
}

TEST(NarrowerLimits, AStartBeyondThemIsRefusedWithNumbers) {
  Narrowed n;
  const Pressures kpa = Pressures::Constant(3, 75.0F);
  Backbone shape(n.setting.arm.point_count(), 3);
  n.setting.model.no_load().backbone(kpa, shape);
  n.setting.environment.start = ArmStart{kpa, shape};
  n.setting.environment.obstacles.clear();
  const PlanResult result = n.plan("default");
  EXPECT_EQ(result.status, PlanStatus::invalid_start);
  EXPECT_THAT(result.reason, HasSubstr("at 75 kPa; the limits to plan within are -95 to 60 kPa"));
}

TEST(NarrowerLimits, HaveToLieWithinTheArms) {
  Narrowed n;
  n.problem.limits[1] = PressureLimits(-60.0, 101.0);
  EXPECT_THAT([&] { (void)n.plan("default"); },
              ThrowsMessage<InputError>(HasSubstr("-60 to 101 kPa; expected lower < upper, both "
                                                  "within the arm's ± 100 kPa")));
  n.problem.limits.pop_back();
  EXPECT_THAT([&] { (void)n.plan("paper"); },
              ThrowsMessage<InputError>(HasSubstr("limits of 2 segments")));
}

// The same without narrowing: an arm whose sides differ.
TEST(NarrowerLimits, OfTheArmItselfAreKept) {
  Setting s(false);
  for (std::size_t i = 0; i < kNarrow.size(); ++i) {
    s.arm.segments[i].pressure_limit_kpa = kNarrow[i];
  }
  const ForwardModel model(s.arm);
  for (const char* planner : {"default", "paper"}) {
    PlannerLimits limits;
    limits.iterations = 20'000;
    const PlanResult result = make_planner(planner)->plan({s.arm, model, s.environment}, limits, 3);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_NO_THROW(require_plan_of(*result.plan, s.arm, "plan"));
    EXPECT_TRUE(certify(*result.plan, s.arm, nullptr, {}, s.environment).certified());
    for (const PlanFrame& frame : result.plan->frames) {
      EXPECT_LE(frame.setpoint_kpa[0], 60.0F);
      EXPECT_LE(frame.setpoint_kpa[2], 70.0F);
    }
  }
}

}  // namespace
}  // namespace limber
