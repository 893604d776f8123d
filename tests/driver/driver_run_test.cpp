#include "limber/driver/driver_run.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "support/fake_arm.hpp"

namespace limber {
namespace {

Plan plan_to(float first, float second) {
  Plan plan;
  plan.frames.resize(2);
  plan.frames[0].setpoint_kpa = Pressures::Zero(2);
  plan.frames[1].setpoint_kpa = Pressures::Zero(2);
  plan.frames[1].setpoint_kpa << first, second;
  return plan;
}

using ::testing::HasSubstr;

const std::vector<PressureLimits> kLimits = {{-20.0, 50.0}, 30.0};

TEST(DriverRun, FindsTheFirstSetPointBeyondEitherSideOfItsSegment) {
  EXPECT_FALSE(first_beyond(plan_to(50.0F, -30.0F), kLimits));
  EXPECT_FALSE(first_beyond(plan_to(std::nextafter(50.0F, 60.0F), 0.0F), kLimits)) << "rounding";

  const auto above = first_beyond(plan_to(50.1F, -31.0F), kLimits);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->frame, 1U);
  EXPECT_EQ(above->segment, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(above->value), 50.1F);
  EXPECT_EQ(above->limits.upper_kpa, 50.0);

  EXPECT_EQ(first_beyond(plan_to(-20.1F, 0.0F), kLimits)->segment, 0);
  EXPECT_EQ(first_beyond(plan_to(0.0F, -30.1F), kLimits)->segment, 1);
}

// The gate's rounding is a share of the limit: what passes here is not refused in mid-motion.
TEST(DriverRun, RoundingIsThatOfTheGate) {
  const std::vector<PressureLimits> small = {29.9991, 30.0};
  EXPECT_TRUE(first_beyond(plan_to(30.0F, 0.0F), small));
  ArmDescription arm = small_arm();
  arm.segments[0].pressure_limit_kpa = 30.0;
  arm.segments[1].pressure_limit_kpa = 30.0;
  EXPECT_TRUE(first_short_reach(arm, 1.0, small));
}

TEST(DriverRun, NoNumberIsNotWithinLimits) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(first_beyond(plan_to(0.0F, nan), kLimits)->segment, 1);
}

TEST(DriverRun, AScaleIsOfTheArmsLimitsAndEachSideIsLookedAt) {
  ArmDescription arm = small_arm();
  arm.segments[0].pressure_limit_kpa = {-40.0, 100.0};
  arm.segments[1].pressure_limit_kpa = 60.0;

  EXPECT_FALSE(first_short_reach(arm, 0.5, kLimits)) << "-20, 50 and 30 are just reached";
  EXPECT_FALSE(first_short_reach(arm, 1.0, {{-40.0, 100.0}, 60.0}));

  const auto lower = first_short_reach(arm, 1.0, {{-39.0, 100.0}, 60.0});
  ASSERT_TRUE(lower);
  EXPECT_EQ(lower->segment, 0);
  EXPECT_EQ(lower->wanted_kpa, -40.0);
  EXPECT_EQ(lower->allowed_kpa, -39.0);

  EXPECT_EQ(first_short_reach(arm, 1.0, {{-40.0, 100.0}, 59.0})->segment, 1);
}

TEST(DriverRun, TheScaleThatIsAdvisedStaysWithinOnEverySide) {
  const ArmDescription arm = small_arm();  // 100 kPa
  for (const std::vector<PressureLimits>& allowed : std::vector<std::vector<PressureLimits>>{
           {{-20.0, 30.0}, 50.0}, {30.0, {-29.0, 100.0}}, {100.0, 7.777}, {1.5, 100.0}}) {
    const auto found = first_short_reach(arm, 1.0, allowed);
    ASSERT_TRUE(found);
    const std::optional<double> scale = scale_within(arm, allowed);
    ASSERT_TRUE(scale);
    EXPECT_FALSE(first_short_reach(arm, *scale, allowed)) << *scale;
    EXPECT_TRUE(first_short_reach(arm, *scale + 0.02, allowed)) << *scale;
    EXPECT_THAT(advice(*found, arm, allowed, "--limit-scale {:g}"),
                HasSubstr(fmt::format("; --limit-scale {:g} stays within", *scale)));
  }
  EXPECT_EQ(scale_within(arm, {{-20.0, 30.0}, 50.0}), 0.2);
}

TEST(DriverRun, WhereADriverAllowsNothingNoScaleIsAdvised) {
  const ArmDescription arm = small_arm();
  const std::vector<PressureLimits> allowed = {{0.0, 50.0}, 100.0};
  EXPECT_FALSE(scale_within(arm, allowed));
  EXPECT_THAT(advice(*first_short_reach(arm, 1.0, allowed), arm, allowed, "--limit-scale {:g}"),
              HasSubstr("say in the arm file which side has no pressure"));
}

}  // namespace
}  // namespace limber
