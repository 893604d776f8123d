#include <utility>

#include <gmock/gmock.h>

#include "certificate/solved_problem.hpp"

namespace limber {
namespace {

using ::testing::Contains;

// Roundings are shares of commands: float32 of 100 000 Pa are 8 mPa apart.
TEST(Certificate, HoldsInAnyUnit) {
  for (const auto& [unit, per_kpa] : {std::pair{"Pa", 1000.0}, std::pair{"MPa", 1e-3}}) {
    ArmDescription arm = three_segment_arm();
    arm.command = {"pressure", unit};
    arm.pressure_rate_limit_kpa_per_s *= per_kpa;
    for (Segment& segment : arm.segments) {
      PressureLimits& limits = segment.pressure_limit_kpa;
      limits = {per_kpa * limits.lower_kpa, per_kpa * limits.upper_kpa};
      double power = 1.0;
      for (double& coefficient : segment.strain_polynomial) {
        coefficient /= power *= per_kpa;
      }
    }
    const ForwardModel model(arm);
    Environment environment = solved().environment;
    environment.goal.theta_rad.reset();
    PlannerLimits limits;
    limits.iterations = 1500;
    const PlanResult result = make_planner("default")->plan({arm, model, environment}, limits, 3);
    ASSERT_EQ(result.status, PlanStatus::solved) << unit << ": " << result.reason;
    EXPECT_TRUE(certify(*result.plan, arm, nullptr, {}, environment).certified());
    // Every second frame left out: twice as fast as the arm may be asked to move.
    Plan fast = *result.plan;
    for (std::size_t k = fast.frames.size() / 2; k-- > 0;) {
      fast.frames.erase(fast.frames.begin() + long(2 * k + 1));
    }
    EXPECT_THAT(failed_checks(certify(fast, arm, nullptr, {}, environment)), Contains("rate"));
  }
}

// Its motions take as many frames as the rate that was asked for needs.
TEST(Certificate, HoldsAtARateBelowTheArmsAndAtNoneAbove) {
  const ArmDescription arm = three_segment_arm();
  Environment environment = solved().environment;
  environment.goal.theta_rad.reset();
  PlannerLimits limits;
  limits.iterations = 1500;
  for (const double factor : {0.25, 2.0}) {
    ArmDescription asked = arm;
    asked.pressure_rate_limit_kpa_per_s *= factor;
    const ForwardModel model(asked);
    const PlanResult result = make_planner("default")->plan({asked, model, environment}, limits, 3);
    ASSERT_TRUE(result.plan) << result.reason;
    const Certificate certificate = certify(*result.plan, arm, nullptr, {}, environment);
    EXPECT_EQ(certificate.certified(), factor < 1.0);
    if (factor > 1.0) {
      EXPECT_THAT(failed_checks(certificate), Contains("rate"));
    }
  }
}

}  // namespace
}  // namespace limber
