#include <gtest/gtest.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/run/collision_watch.hpp"
#include "limber/world/collision.hpp"
#include "src/run/execution/run_watch.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

TEST(CollisionWatch, MissesNothingWhileSkippingMostChecks) {
  const ArmDescription arm = small_arm();
  const NoLoadModel model(arm);
  Environment environment;
  environment.obstacles = {Circle{0.3, 0.15, 0.03}, Rectangle{0.2, -0.2, 0.1, 0.05, 0.3}};
  const CollisionChecker checker(arm, environment.obstacles);
  RandomStream random(5, 0);
  constexpr int kTrials = 20;
  constexpr int kSteps = 2000;
  int checks = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    CollisionWatch watch(arm, environment);
    Eigen::VectorXd from = Eigen::VectorXd::Zero(2);
    Eigen::VectorXd to(2);
    to << random.uniform(-100, 100), random.uniform(-100, 100);
    double smallest = 1e9;
    double first_s = -1.0;
    for (int k = 0; k <= kSteps; ++k) {
      const Eigen::VectorXd pressures = from + (to - from) * k / kSteps;
      BackboneD backbone(arm.point_count(), 3);
      model.backbone(Eigen::Ref<const Eigen::VectorXd>(pressures), Eigen::Ref<BackboneD>(backbone));
      watch.observe(k, backbone);
      const double value = checker.clearance(backbone).value_m;
      smallest = std::min(smallest, value);
      first_s = first_s < 0.0 && value < 0.0 ? k : first_s;
    }
    ASSERT_TRUE(watch.closest());
    EXPECT_NEAR(watch.closest()->clearance.value_m, smallest, 1e-4);
    EXPECT_EQ(watch.first_collision().has_value(), first_s >= 0.0);
    if (watch.first_collision()) {
      EXPECT_EQ(watch.first_collision()->time_s, first_s);
    }
    checks += watch.checks();
  }
  EXPECT_LT(checks, kTrials * kSteps / 2);
}

TEST(PredictionWatch, TheErrorBeforeTheHoldIsThatOfFramesThatMove) {
  Plan plan;
  plan.hold_frame_count = 2;
  plan.frames.resize(4);
  for (PlanFrame& frame : plan.frames) {
    frame.backbone = Backbone::Zero(2, 3);
  }
  const auto at = [](double x_m) {
    BackboneD shape = BackboneD::Zero(2, 3);
    shape(1, 0) = x_m;
    return shape;
  };
  PredictionWatch watch;
  for (const double moving_m : {0.01, 0.02}) {  // a plan, its hold, and a plan after it
    for (std::size_t frame = 0; frame < 4; ++frame) {
      watch.compare(plan, frame, at(frame < 2 ? moving_m : 0.001));
    }
  }
  EXPECT_NEAR(watch.error()->before_hold_m, 0.015, 1e-12);
  EXPECT_NEAR(watch.error()->mean_m, 0.5 * (0.015 + 0.001), 1e-12);
}

}  // namespace
}  // namespace limber
