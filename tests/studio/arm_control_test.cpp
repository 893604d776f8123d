#include "src/studio/arm_control.hpp"

#include <gmock/gmock.h>

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Each held frame is kept: a page that is forgotten over a pause would fill the memory.
TEST(ArmControl, APauseHoldsAndVentsAtItsLongest) {
  const auto begin = ArmControl::Clock::now() - ArmControl::kLongestPause;
  ArmControl control;
  control.begin();
  control.pause(true, begin + std::chrono::minutes(1));
  EXPECT_TRUE(control.must_hold());
  EXPECT_FALSE(control.must_vent());
  control.pause(false);
  control.pause(true, begin);
  control.pause(true);  // says nothing new
  EXPECT_TRUE(control.must_vent());
  EXPECT_FALSE(control.must_disarm()) << "as where it is stopped";
  EXPECT_THAT(control.why_vented(), HasSubstr("paused for 10 min"));
  control.clear_stop();
  EXPECT_FALSE(control.must_vent() || control.must_hold());
  EXPECT_THAT(control.why_vented(), IsEmpty());
}

TEST(ArmControl, NothingIsSaidToHoldAnArmThatNothingHolds) {
  ArmControl control;
  control.begin();
  control.pause(true);
  EXPECT_EQ(control.why_held(), "paused");
  control.note_unheld();
  EXPECT_THAT(control.why_held(), IsEmpty());
  EXPECT_FALSE(control.must_hold()) << "what was asked before is forgotten";
  control.clear_stop();
  control.pause(true);
  EXPECT_EQ(control.why_held(), "paused") << "the next driver may be another one";
}

TEST(ArmControl, AStopIsNamedBeforeALongPause) {
  ArmControl control;
  control.begin();
  control.pause(true, ArmControl::Clock::now() - ArmControl::kLongestPause);
  control.stop();
  EXPECT_EQ(control.why_vented(), "stopped by hand");
}

}  // namespace
}  // namespace limber
