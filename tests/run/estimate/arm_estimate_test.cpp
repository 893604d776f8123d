#include "limber/run/arm_estimate.hpp"

#include <gtest/gtest.h>

#include "limber/forward/motion_simulator.hpp"
#include "planning/play_model.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

/// Valves with a dead time of two frames.
struct EstimateSetting {
  ArmDescription arm = small_arm();
  ForwardModel forward{arm, play_network(arm, 0.002F, 0.3F)};  // reads velocities
  MotionModel model{forward,
                    ValveModel(arm, {true, std::vector<SegmentValves>(
                                               2, {{0.1, 100.0}, {0.1, 100.0}, 0.1, 0.2})})};
  ArmStart rest = start_state(Environment{}, arm);
  MotionState state = state_of(rest, model);
  MotionModel::Workspace workspace;
  double time_s = 0.0;

  /// What the model itself does.
  ArmState after(const Pressures& setpoint_kpa) {
    model.step(setpoint_kpa, state, workspace);
    time_s += arm.frame_period_s();
    return {time_s, state.pressure_kpa(), std::nullopt, state.backbone};
  }
  Pressures setpoint(int k) const { return Pressures::Constant(2, 3.0F * float(k)); }
};

TEST(ArmEstimate, OfAnArmThatDoesAsTheModelSaysIsTheModelsStateAndNothingIsMissed) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  estimate.observe(s.rest.pressures_kpa,
                   {0.0, s.rest.pressures_kpa, std::nullopt, s.rest.backbone});
  for (int k = 1; k < 10; ++k) {
    estimate.observe(s.setpoint(k), s.after(s.setpoint(k)));
    ASSERT_TRUE(estimate.state() == s.state) << k;
  }
  EXPECT_EQ(estimate.miss().sum.x(), 0.0);
  EXPECT_EQ(estimate.miss().sum.y(), 0.0);
  EXPECT_NEAR(estimate.miss().travelled_kpa, 2 * 27.0, 1e-4);
}

// A driver that answers at once shows the end of the frame before, and says so.
TEST(ArmEstimate, OfADriverThatAnswersAtOnceIsWhereTheSetPointsLead) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  ArmState shown{0.0, s.rest.pressures_kpa, s.rest.pressures_kpa, s.rest.backbone};
  estimate.observe(s.rest.pressures_kpa, shown);
  shown.time_s += 0.5 * s.arm.frame_period_s();  // still at rest
  for (int k = 1; k < 10; ++k) {
    estimate.observe(s.setpoint(k), shown);
    ASSERT_TRUE(estimate.shown_state().backbone == *shown.backbone) << "a frame behind";
    shown = s.after(s.setpoint(k));
    shown.setpoint_kpa = s.setpoint(k);
    ASSERT_TRUE(estimate.state() == s.state) << k;
  }
  EXPECT_EQ(estimate.miss().sum.norm(), 0.0);
  EXPECT_NEAR(estimate.miss().travelled_kpa, 2 * 24.0, 1e-4) << "of what was shown";
}

TEST(ArmEstimate, BridgesUnseenFramesByPrediction) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  estimate.observe(s.rest.pressures_kpa,
                   {0.0, s.rest.pressures_kpa, std::nullopt, s.rest.backbone});
  for (int k = 1; k < 6; ++k) {
    ArmState unseen = s.after(s.setpoint(k));
    unseen.backbone.reset();
    estimate.observe(s.setpoint(k), unseen);
    EXPECT_EQ(estimate.frames_unseen(), k);
    ASSERT_TRUE(estimate.state() == s.state) << k;
  }
  estimate.observe(s.setpoint(6), s.after(s.setpoint(6)));
  EXPECT_EQ(estimate.frames_unseen(), 0);
}

// A tracker that is out of step with the frames has a driver say the same sample again.
TEST(ArmEstimate, ASampleThatIsSaidAgainIsNoNewShape) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  estimate.observe(s.rest.pressures_kpa,
                   {0.0, s.rest.pressures_kpa, std::nullopt, s.rest.backbone});
  ArmState shown;
  for (int k = 1; k < 12; ++k) {
    const ArmState now = s.after(s.setpoint(k));
    const bool is_new = k % 3 != 0;
    shown = is_new ? now : ArmState{shown.time_s, now.pressure_kpa, std::nullopt, shown.backbone};
    estimate.observe(s.setpoint(k), shown);
    EXPECT_EQ(estimate.frames_unseen(), is_new ? 0 : 1) << k;
    ASSERT_TRUE(estimate.state() == s.state) << k;
  }
  EXPECT_EQ(estimate.miss().sum.norm(), 0.0);
}

TEST(ArmEstimate, TakesWhatIsMeasuredAndSumsWhatTheModelMisses) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  estimate.observe(s.rest.pressures_kpa,
                   {0.0, s.rest.pressures_kpa, std::nullopt, s.rest.backbone});
  constexpr float kAsideM = 0.001F;
  constexpr double kRoundingM = 1e-6;
  for (int k = 1; k < 4; ++k) {
    ArmState aside = s.after(s.setpoint(k));
    MotionState expected = estimate.state();
    s.model.step(s.setpoint(k), expected, s.workspace);
    aside.backbone = expected.backbone;  // what follows from where it was, and a little beside it
    aside.backbone->col(1).array() += kAsideM;
    estimate.observe(s.setpoint(k), aside);
    EXPECT_EQ(estimate.state().backbone, *aside.backbone);
  }
  EXPECT_NEAR(estimate.miss().sum.y(), 3 * double(kAsideM), kRoundingM);
  EXPECT_GE(estimate.miss().plate_m.minCoeff(), double(kAsideM) - kRoundingM);
  estimate.forget_miss();
  EXPECT_EQ(estimate.miss().sum.y(), 0.0);
  EXPECT_EQ(estimate.miss().travelled_kpa, 0.0);
  EXPECT_EQ(estimate.miss().plate_m.size(), 0);
}

/// Frames whose tips come 1 mm aside of what the frame before led to.
TEST(ArmEstimate, ExpectsTheTipWhereForecastsHaveMissedIt) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  estimate.observe(s.rest.pressures_kpa,
                   {0.0, s.rest.pressures_kpa, std::nullopt, s.rest.backbone});
  EXPECT_EQ(estimate.missed_ahead_m(1).norm(), 0.0);
  for (int k = 1; k < 30; ++k) {
    ArmState aside = s.after(s.setpoint(k));
    MotionState expected = estimate.state();
    s.model.step(s.setpoint(k), expected, s.workspace);
    aside.backbone = expected.backbone;
    aside.backbone->col(1).array() += 0.001F;
    estimate.observe(s.setpoint(k), aside);
  }
  const int quarter = s.arm.frames_in(0.25);
  const Eigen::Vector2d missed_m = estimate.missed_ahead_m(quarter);
  EXPECT_GT(missed_m.y(), 0.0005);
  EXPECT_LE(missed_m.norm(), 0.05);
  const double per_frame = s.model.has_network() ? 1.0 / quarter : 1.0;
  EXPECT_NEAR(estimate.missed_ahead_m(1).y(), per_frame * missed_m.y(), 1e-12);
  EXPECT_EQ(estimate.missed_ahead_m(2 * quarter), estimate.missed_ahead_m(9 * quarter));
  estimate.forget_miss();
  EXPECT_EQ(estimate.missed_ahead_m(quarter).norm(), 0.0);
}

TEST(ArmEstimate, HasNoStateBeforeTheArmWasSeenButKnowsItsValvesThen) {
  EstimateSetting s;
  ArmEstimate estimate(s.arm, {&s.model, std::nullopt});
  estimate.observe(s.rest.pressures_kpa, {0.0, s.rest.pressures_kpa, std::nullopt, std::nullopt});
  for (int k = 1; k < 4; ++k) {
    ArmState unseen = s.after(s.setpoint(k));
    unseen.backbone.reset();
    estimate.observe(s.setpoint(k), unseen);
    EXPECT_FALSE(estimate.has_state());
  }
  estimate.observe(s.setpoint(4), s.after(s.setpoint(4)));
  ASSERT_TRUE(estimate.has_state());
  EXPECT_EQ(estimate.state().valves, s.state.valves);
  EXPECT_EQ(estimate.state().backbone, s.state.backbone);
  EXPECT_EQ(estimate.state().before, s.state.backbone) << "one shape does not show how it moves";
}

TEST(ArmEstimate, AStartThereIsTheSameState) {
  EstimateSetting s;
  for (int k = 1; k < 5; ++k) {
    (void)s.after(s.setpoint(k));
  }
  EXPECT_TRUE(state_of(start_at(s.state), s.model) == s.state);
}

}  // namespace
}  // namespace limber
