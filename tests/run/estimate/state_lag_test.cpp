#include "limber/run/state_lag.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limber {
namespace {

Pressures kpa(float value) {
  return Pressures::Constant(2, value);
}

ArmState in_force(float value) {
  ArmState state;
  state.setpoint_kpa = kpa(value);
  return state;
}

TEST(StateLag, IsNoneWhereStatesDoNotSay) {
  StateLag lag;
  EXPECT_EQ(lag.note(kpa(1.0F), ArmState{}), 0);
  EXPECT_EQ(lag.note(kpa(2.0F), ArmState{}), 0);
}

TEST(StateLag, IsFoundByTheSetPointInForce) {
  for (int behind = 0; behind <= StateLag::kMaxFrames; ++behind) {
    StateLag lag;
    int found = 0;
    for (int k = 0; k < 8; ++k) {
      found = lag.note(kpa(5.0F * float(k)), in_force(5.0F * float(std::max(0, k - behind))));
    }
    EXPECT_EQ(found, behind);
  }
}

// All set points of a hold are the same, so nothing speaks against what was known before.
TEST(StateLag, StaysWhileSetPointsStandStill) {
  StateLag lag;
  (void)lag.note(kpa(0.0F), in_force(0.0F));
  EXPECT_EQ(lag.note(kpa(5.0F), in_force(0.0F)), 1);
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(lag.note(kpa(5.0F), in_force(5.0F)), 1);
  }
  EXPECT_EQ(lag.note(kpa(9.0F), in_force(9.0F)), 0) << "it has caught up";
}

// A board that takes whole kilopascals says what it made of a set point.
TEST(StateLag, OfADeviceThatRoundsIsThatOfTheNearest) {
  StateLag lag;
  (void)lag.note(kpa(0.0F), in_force(0.0F));
  EXPECT_EQ(lag.note(kpa(4.6F), in_force(0.0F)), 1);
  EXPECT_EQ(lag.note(kpa(9.2F), in_force(5.0F)), 1);
}

}  // namespace
}  // namespace limber
