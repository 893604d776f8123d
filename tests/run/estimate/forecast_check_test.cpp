#include "src/run/estimate/forecast_check.hpp"

#include <gtest/gtest.h>

#include "limber/forward/motion_simulator.hpp"
#include "planning/play_model.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr std::size_t kFrames = 4;
constexpr double kRoundingM = 1e-6;

/// An arm that does as the model says, but for a push to the side in some frames.
struct CheckSetting {
  ArmDescription arm = small_arm();
  ForwardModel forward{arm, play_network(arm, 0.002F, 0.3F)};  // reads velocities
  MotionModel model{forward};
  ArmStart rest = start_state(Environment{}, arm);
  MotionState state = state_of(rest, model);
  MotionModel::Workspace workspace;
  ForecastCheck check{kFrames, kFrames};

  CheckSetting() { check.compare(state); }

  void frame(int k, float pushed_m) {
    const Pressures before_kpa = state.pressure_kpa();
    model.step(Pressures::Constant(2, 3.0F * float(k)), state, workspace);
    check.step(model, before_kpa, state.pressure_kpa(), workspace);
    state.backbone.col(1).array() += pushed_m;
    check.compare(state);
  }
};

TEST(ForecastCheck, NothingIsMissedOfAnArmThatDoesAsTheModelSays) {
  CheckSetting s;
  for (int k = 1; k < 12; ++k) {
    s.frame(k, 0.0F);
    ASSERT_EQ(s.check.missed_m().maxCoeff(), 0.0) << k;
  }
}

TEST(ForecastCheck, IsWhatWasMissedSinceTheOldestForecast) {
  CheckSetting s;
  s.frame(1, 0.0F);
  s.frame(2, 0.01F);  // the first forecast is two frames old
  const double first_m = s.check.missed_m().maxCoeff();
  EXPECT_NEAR(first_m, 0.01, kRoundingM);
  EXPECT_NEAR(s.check.missed_m().minCoeff(), first_m, kRoundingM) << "all plates were pushed";
  double most_m = 0.0;
  for (int k = 3; k < 12; ++k) {
    s.frame(k, 0.0F);
    most_m = std::max(most_m, s.check.missed_m().maxCoeff());
  }
  EXPECT_LT(most_m, 2.0 * first_m) << "a push counts once, with what follows from it";
  EXPECT_LT(s.check.missed_m().maxCoeff(), 0.7 * most_m) << "what is past counts less and less";
}

TEST(ForecastCheck, IsNoOlderAfterTheArmWasNotSeen) {
  CheckSetting s;
  for (int k = 1; k < 6; ++k) {  // unseen, and it drifts
    const Pressures before_kpa = s.state.pressure_kpa();
    s.model.step(Pressures::Constant(2, 3.0F * float(k)), s.state, s.workspace);
    s.check.step(s.model, before_kpa, s.state.pressure_kpa(), s.workspace);
    s.state.backbone.col(1).array() += 0.01F;
  }
  s.check.compare(s.state);
  EXPECT_EQ(s.check.missed_m().size(), 0) << "there is no forecast of the last frames";
  s.frame(6, 0.0F);
  EXPECT_LT(s.check.missed_m().maxCoeff(), 0.01) << "what it does now is what counts";
}

TEST(ForecastCheck, KnowsNothingOnceForgotten) {
  CheckSetting s;
  s.frame(1, 0.01F);
  s.check.forget();
  EXPECT_EQ(s.check.missed_m().size(), 0);
  s.check.compare(s.state);
  EXPECT_EQ(s.check.missed_m().size(), 0) << "there is no forecast to compare with yet";
  s.frame(2, 0.0F);
  EXPECT_EQ(s.check.missed_m().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace limber
