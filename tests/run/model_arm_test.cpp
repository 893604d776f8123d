#include "limber/run/model_arm.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

CompensationModel some_network(const ArmDescription& arm) {
  return untrained_model(arm, BackboneLayout::gap_poses, {16, 16}, 3);
}

// The oracle is the forward model, stepped by hand.
TEST(ModelArm, IsWhatTheNetworkSays) {
  const ArmDescription arm = small_arm();
  const CompensationModel network = some_network(arm);
  ModelArm driver(arm, network, {});
  const ForwardModel forward(arm, network);
  ForwardModel::Workspace workspace;
  Backbone expected = *driver.state().backbone;
  EXPECT_NEAR(expected(arm.point_count() - 1, 0), arm.length_m(), 1e-6) << "it starts straight";
  Pressures before = Pressures::Zero(2);
  for (int k = 1; k <= 30; ++k) {
    const Pressures now = Pressures::Constant(2, 2.0F * static_cast<float>(k));
    forward.step(before, now, expected, expected, workspace);
    const ArmState& state = driver.command(now);
    EXPECT_NEAR(state.time_s, k * arm.frame_period_s(), 1e-12);
    EXPECT_EQ(state.pressure_kpa, now);
    EXPECT_TRUE(*state.backbone == expected);
    before = now;
  }
}

TEST(ModelArm, RefusesSetPointsBeyondTheLimitsAndStaysWhereItIs) {
  const ArmDescription arm = small_arm();
  ModelArm driver(arm, some_network(arm), {});
  const double before_s = driver.state().time_s;
  EXPECT_THAT([&] { driver.command(Pressures::Constant(2, 101.0F)); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("segment 0 is 101")));
  EXPECT_THROW(driver.command(Pressures::Constant(2, std::nanf(""))), InputError);
  EXPECT_THROW(driver.command(Pressures::Zero(3)), InputError);
  EXPECT_EQ(driver.state().time_s, before_s);
}

TEST(ModelArm, RefusesANetworkOfAnotherArm) {
  EXPECT_THROW(ModelArm(small_arm(3), some_network(small_arm(2)), {}), InputError);
}

}  // namespace
}  // namespace limber
