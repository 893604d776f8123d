#include "src/run/closed_loop/shape_feedback.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/bending_arms.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

/// limber's model has the arm bend twice as far as it does, so that it stays behind its plan.
class ShapeFeedbackTest : public ::testing::Test {
 protected:
  Backbone planned(const Pressures& kpa) const { return unloaded_shape(known_, kpa); }

  static double bend_rad(const Backbone& shape) { return double(shape(shape.rows() - 1, 2)); }

  const ArmDescription known_ = slow(small_arm());
  const ArmDescription real_ = bending(known_, 0.5);
  const NoLoadModel model_{known_};
  const Pressures there_kpa_ = Pressures::Constant(2, 20.0F);
};

TEST_F(ShapeFeedbackTest, AnArmWhereItsPlanHasItGetsThePlansSetPoints) {
  ShapeFeedback feedback(known_, model_, ValveModel::ideal(2));
  for (int k = 0; k < 20; ++k) {
    feedback.learn(planned(there_kpa_), planned(there_kpa_));
    EXPECT_EQ(feedback.setpoint(there_kpa_, there_kpa_, {}), there_kpa_);
  }
}

TEST_F(ShapeFeedbackTest, BringsAWeakArmToItsPlansShape) {
  ShapeFeedback feedback(known_, model_, ValveModel::ideal(2));
  FakeArm arm(real_, kInstant_s);
  Pressures sent_kpa = arm.command(there_kpa_).pressure_kpa;
  const Backbone goal = planned(there_kpa_);
  ASSERT_GT(std::abs(bend_rad(goal) - bend_rad(*arm.state().backbone)), 0.1);
  sent_kpa = there_kpa_;
  for (int k = 0; k < 60; ++k) {
    feedback.learn(goal, *arm.state().backbone);
    sent_kpa = feedback.setpoint(there_kpa_, sent_kpa, {});
    arm.command(sent_kpa);
  }
  constexpr double kThereRad = 0.005;
  EXPECT_NEAR(bend_rad(*arm.state().backbone), bend_rad(goal), kThereRad);
}

// The gains for an arm that valves make slow would have these swing.
TEST_F(ShapeFeedbackTest, DoesNotSwingWhereAnArmFollowsAtOnceAndBendsMoreThanModelled) {
  for (const double share : {1.0, 2.0, 3.0}) {
    ShapeFeedback feedback(known_, model_, ValveModel::ideal(2));
    FakeArm arm(bending(known_, share), kInstant_s);
    Pressures sent_kpa = there_kpa_;
    arm.command(sent_kpa + Eigen::Vector2f(4.0F, -4.0F));
    const Backbone goal = planned(there_kpa_);
    for (int k = 0; k < 60; ++k) {
      feedback.learn(goal, *arm.state().backbone);
      sent_kpa = feedback.setpoint(there_kpa_, sent_kpa, {});
      arm.command(sent_kpa);
    }
    constexpr double kThereRad = 0.005;
    EXPECT_NEAR(bend_rad(*arm.state().backbone), bend_rad(goal), kThereRad) << share;
  }
}

// They follow at once what is not small: with the gains of slow valves their arm would swing.
TEST_F(ShapeFeedbackTest, ADeadBandMakesNoValveSlow) {
  const ValveModel valves(
      known_, {true, std::vector<SegmentValves>(2, {{0.0, 100.0}, {0.0, 100.0}, 0.0, 1.5})});
  ShapeFeedback with_band(known_, model_, valves);
  ShapeFeedback ideal(known_, model_, ValveModel::ideal(2));
  const Backbone goal = planned(there_kpa_);
  const Backbone behind = planned(Pressures::Constant(2, 15.0F));
  for (ShapeFeedback* feedback : {&with_band, &ideal}) {
    feedback->learn(goal, goal);
    feedback->learn(goal, behind);
  }
  EXPECT_EQ(with_band.setpoint(there_kpa_, there_kpa_, {}),
            ideal.setpoint(there_kpa_, there_kpa_, {}));
}

TEST_F(ShapeFeedbackTest, KeepsTheFrameRuleAndTheLimitsAndWindsNothingUp) {
  ShapeFeedback feedback(known_, model_, ValveModel::ideal(2));
  const Backbone straight = planned(Pressures::Zero(2));
  const std::vector<PressureLimits> limits(2, PressureLimits(-30.0, 30.0));
  Pressures before_kpa = there_kpa_;
  for (int k = 0; k < 100; ++k) {  // it never moves
    feedback.learn(planned(there_kpa_), straight);
    const Pressures sent_kpa = feedback.setpoint(there_kpa_, before_kpa, limits);
    EXPECT_LE(double((sent_kpa - before_kpa).cwiseAbs().maxCoeff()),
              known_.pressure_step_limit_kpa() + 1e-3);
    EXPECT_LE(sent_kpa.cwiseAbs().maxCoeff(), 30.0F);
    before_kpa = sent_kpa;
  }
  EXPECT_EQ(before_kpa, Pressures::Constant(2, 30.0F)) << "as far as it may";
  // Beyond the plan at last: the first frame takes something back.
  feedback.learn(straight, planned(there_kpa_));
  EXPECT_LT(feedback.setpoint(there_kpa_, before_kpa, limits).maxCoeff(), 30.0F);
}

TEST_F(ShapeFeedbackTest, LeavesASegmentAloneThatTheModelDoesNotBend) {
  ArmDescription stiff = known_;
  stiff.no_load = NoLoadKind::straight;
  const NoLoadModel straight(stiff);
  ShapeFeedback feedback(stiff, straight, ValveModel::ideal(2));
  feedback.learn(planned(there_kpa_), planned(Pressures::Zero(2)));
  EXPECT_EQ(feedback.setpoint(there_kpa_, there_kpa_, {}), there_kpa_);
}

}  // namespace
}  // namespace limber
