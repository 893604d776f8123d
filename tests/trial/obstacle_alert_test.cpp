#include "limber/trial/obstacle_alert.hpp"

#include <gtest/gtest.h>

#include "limber/hardware/appearing_obstacle.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr double kInstant_s = 1e-4;
constexpr double kMargin_m = 0.01;

/// Knows no way on; counts what it is asked.
class NoWayOn final : public PlanSource {
 public:
  bool may_go_on(const Plan&, std::size_t, const ArmState&) override { return true; }
  std::optional<Plan> next(const Plan&, std::size_t, const ArmState&) override {
    return std::nullopt;
  }
};

ArmDescription slow_arm() {
  ArmDescription arm = small_arm();
  arm.pressure_rate_limit_kpa_per_s = 40.0;
  return arm;
}

class ObstacleAlertTest : public ::testing::Test {
 protected:
  ExecutionResult run(const AppearingObstacle& obstacle) {
    ObstacleAlert alert(arm_, environment_, kMargin_m, [&](const Environment& now) {
      known_.push_back(now.obstacles.size());
      return std::make_unique<NoWayOn>();
    });
    ExecutionSettings settings;
    settings.replanner = &alert;
    settings.obstacle = &obstacle;
    FakeArm driver(arm_, kInstant_s);
    return execute(arm_, environment_, plan_, driver, settings);
  }

  const ArmDescription arm_ = slow_arm();
  const Environment environment_;
  const Plan plan_ = bending_plan(arm_, environment_);
  std::vector<std::size_t> known_;  // obstacles of the environments that sources were made for
};

TEST_F(ObstacleAlertTest, StopsAtOnceWhereTheRestOfThePlanIsBlockedAndNoPlanLeadsOn) {
  const auto obstacle = appearing_obstacle(arm_, plan_, 0.02, 3, 0);
  ASSERT_TRUE(obstacle);
  const ExecutionResult result = run(*obstacle);
  ASSERT_TRUE(result.appeared);
  EXPECT_TRUE(result.stopped_ahead);
  EXPECT_FALSE(result.collided);
  EXPECT_EQ(result.halts, 1);
  EXPECT_EQ(result.frames, obstacle->frame + arm_.frames_in(1.0)) << "and the hold";
  EXPECT_EQ(known_, (std::vector<std::size_t>{0, 1}));
}

TEST_F(ObstacleAlertTest, GoesOnPastAnObstacleThatIsNotInTheWay) {
  const AppearingObstacle elsewhere{5, {Circle{-0.3, 0.3, 0.02}}};
  const ExecutionResult result = run(elsewhere);
  ASSERT_TRUE(result.appeared);
  EXPECT_EQ(result.halts, 0);
  EXPECT_FALSE(result.stopped_ahead);
  EXPECT_EQ(result.frames, plan_.frame_count() - 1 + arm_.frames_in(1.0));
}

TEST_F(ObstacleAlertTest, NeedsFiveCentimetresAtThatMomentElseNothingAppears) {
  const AppearingObstacle on_the_arm{5, {Circle{0.2, 0.0, 0.02}}};
  const ExecutionResult result = run(on_the_arm);
  EXPECT_FALSE(result.appeared || result.collided || result.halts > 0);
}

}  // namespace
}  // namespace limber
