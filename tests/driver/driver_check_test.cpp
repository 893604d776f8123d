#include "limber/driver/driver_check.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "support/fake_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kPeriodS = 0.05;
constexpr double kStepKpa = 30.0;

/// Readings after a jump: dead for `dead_s`, then first order.
std::vector<double> first_order(double dead_s, double time_constant_s, double sign) {
  std::vector<double> readings;
  for (int k = 1; k <= 60; ++k) {
    const double t = k * kPeriodS - dead_s;
    readings.push_back(t <= 0.0 ? 0.0 : sign * kStepKpa * (1.0 - std::exp(-t / time_constant_s)));
  }
  return readings;
}

// A first-order answer rises from 10 to 90 % in T ln 9.
TEST(StepResponse, FindsDeadTimeAndRiseOfAFirstOrderAnswer) {
  for (const double sign : {1.0, -1.0}) {
    const StepResponse found =
        step_response(first_order(0.15, 0.2, sign), kPeriodS, sign * kStepKpa, 0.01);
    ASSERT_TRUE(found.answered);
    EXPECT_NEAR(found.reached_kpa, sign * kStepKpa, 0.01);
    EXPECT_NEAR(found.rise_time_s, 0.2 * std::log(9.0), 0.02);
    EXPECT_NEAR(found.dead_time_s, 0.15 - kPeriodS, 0.03);  // the first reading is a frame old
    EXPECT_LT(found.overshoot_kpa, 0.01);
  }
}

// At 1 Hz a hold of 1.5 s is two frames.
TEST(StepResponse, TellsAnAnswerAlsoWhereAFrameIsLongerThanAMean) {
  const StepResponse found = step_response({0.0, kStepKpa}, 1.0, kStepKpa, 0.01);
  EXPECT_TRUE(found.answered);
  EXPECT_EQ(found.reached_kpa, kStepKpa);
}

TEST(StepResponse, AReadingThatStaysIsNoAnswer) {
  EXPECT_FALSE(step_response(std::vector<double>(60, 0.1), kPeriodS, kStepKpa, 0.1).answered);
  EXPECT_FALSE(step_response({}, kPeriodS, kStepKpa, 0.1).answered);
}

TEST(StepResponse, OvershootIsWhatIsBeyondTheEnd) {
  std::vector<double> readings(60, kStepKpa);
  readings[4] = kStepKpa + 3.5;
  EXPECT_NEAR(step_response(readings, kPeriodS, kStepKpa, 0.0).overshoot_kpa, 3.5, 1e-9);
}

TEST(DriverSilence, IsThreeFramesOrWhatTheDeviceTakesAndTimeForTheValves) {
  EXPECT_DOUBLE_EQ(silence_s(0.05), 0.65);
  EXPECT_DOUBLE_EQ(silence_s(0.1), 0.65);
  EXPECT_DOUBLE_EQ(silence_s(0.2), 0.95);
  EXPECT_DOUBLE_EQ(silence_s(1.0), 3.35);
}

// A pulse of 1 s would be one frame, whose state is that of the frame before.
TEST(DriverCheck, AtOneFramePerSecondBlamesNoDriverThatAnswersAtOnce) {
  const TemporaryFolder folder;
  ArmDescription arm = small_arm();
  arm.frame_rate_hz = 1.0;
  ProcessDriverSettings settings;
  settings.command = fmt::format("{} {}/tests/driver/fake_driver.py {} behind", LIMBER_PYTHON,
                                 LIMBER_SOURCE_DIR, (folder.path() / "heard").string());
  settings.simulated = true;
  const DriverCheck found = check_driver(arm, settings);
  EXPECT_THAT(found.complaints, IsEmpty());
  ASSERT_EQ(found.steps.size(), 4U);
  for (const StepResponse& step : found.steps) {
    EXPECT_TRUE(step.answered);
    EXPECT_EQ(step.reached_kpa, step.setpoint_kpa);
  }
}

TEST(ScaleComplaint, NamesTheUnitThatWouldFit) {
  EXPECT_THAT(scale_complaint("segment 0", 5.0, 4.8), IsEmpty());
  EXPECT_THAT(scale_complaint("segment 0", -5.0, -5.2), IsEmpty());
  EXPECT_THAT(scale_complaint("segment 1", 5.0, 0.725), HasSubstr("sends psi"));
  EXPECT_THAT(scale_complaint("segment 1", 5.0, 34.5), HasSubstr("takes set points for psi"));
  EXPECT_THAT(scale_complaint("segment 1", 5.0, 50.0), HasSubstr("sends mbar"));
  EXPECT_THAT(scale_complaint("segment 1", 5.0, 0.5), HasSubstr("set points for mbar"));
  EXPECT_THAT(scale_complaint("segment 1", 5.0, 5000.0), HasSubstr("sends Pa"));
  EXPECT_THAT(scale_complaint("segment 2", -5.0, 5.1), HasSubstr("segment 2 reads 5.10 kPa"));
  EXPECT_THAT(scale_complaint("segment 2", -5.0, 5.1), HasSubstr("swapped, or the sign"));
  EXPECT_THAT(scale_complaint("segment 2", 5.0, 0.0), HasSubstr("check supply"));
}

}  // namespace
}  // namespace limber
