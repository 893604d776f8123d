#include "limber/arm/pressure_limits.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/arm_identity.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kLower = -11.0;
constexpr double kUpper = 13.8;

std::string arm_with(const std::string& limits) {
  return "schema: limber/arm/1\n"
         "name: small\n"
         "frame_rate_hz: 20\n"
         "pressure_rate_limit_kpa_per_s: 100\n"
         "actuator_radius_m: 0.006\n"
         "segments:\n"
         "  - {length_m: 0.2, width_m: 0.05, gaps: 4, strain_polynomial: [1.0e-3, 0, 0, 0],\n"
         "     pressure_limit_kpa: " +
         limits + "}\n";
}

std::string motors_with(const std::string& limits, const std::string& own) {
  return "schema: limber/arm/1\n"
         "name: motors\n"
         "command: {name: curvature, unit: 1/m, rate_limit_per_s: 20, limit: " +
         limits +
         "}\n"
         "no_load: curvature\n"
         "frame_rate_hz: 20\n"
         "actuator_radius_m: 0.004\n"
         "segments:\n"
         "  - {length_m: 0.2, width_m: 0.04, gaps: 4}\n"
         "  - {length_m: 0.2, width_m: 0.04, gaps: 4, limit: " +
         own + "}\n";
}

ArmDescription read(const std::string& text) {
  return read_arm(YamlReader::from_text(text, "a.yaml"));
}

void expect_refused(const std::string& limits, const std::string& message) {
  EXPECT_THAT(
      [&] { (void)read(arm_with(limits)); },
      ThrowsMessage<InputError>(HasSubstr("a.yaml:8: segments[0].pressure_limit_kpa" + message)))
      << limits;
}

// Formulas that took ± limit before must give the same bits.
TEST(PressureLimits, OfBothSidesAreTheLimitToTheBit) {
  RandomStream random(3, 0);
  for (int trial = 0; trial < 1000; ++trial) {
    const double limit = random.uniform(1e-3, 1e3);
    const double factor = random.uniform(1.0, 3.0);
    const double value = random.uniform(-2.0, 2.0) * limit;
    const PressureLimits limits = limit;
    EXPECT_TRUE(limits.is_symmetric());
    EXPECT_EQ(limits.largest_kpa(), limit);
    EXPECT_EQ(limits.half_width_kpa(), limit);
    EXPECT_EQ(limits.size_kpa(value), std::abs(value));
    EXPECT_EQ(limits.clamped(value), std::clamp(value, -limit, limit));
    EXPECT_EQ(limits.widened(factor), PressureLimits(factor * limit));
    PressureLimits scaled = limits;
    scaled *= factor;
    EXPECT_EQ(scaled, PressureLimits(factor * limit));
  }
}

TEST(PressureLimits, OfEachSideAreKept) {
  const PressureLimits limits(kLower, kUpper);
  EXPECT_FALSE(limits.is_symmetric());
  EXPECT_EQ(limits.largest_kpa(), kUpper);
  EXPECT_DOUBLE_EQ(limits.half_width_kpa(), 12.4);
  EXPECT_EQ(limits.side_kpa(-1.0), kLower);
  EXPECT_EQ(limits.side_kpa(1.0), kUpper);
  EXPECT_TRUE(limits.contains(kLower));
  EXPECT_TRUE(limits.contains(double(static_cast<float>(kUpper)))) << "set points are float32";
  EXPECT_FALSE(limits.contains(-11.01));
  EXPECT_FALSE(limits.contains(std::nan("")));
  EXPECT_TRUE(limits.contains(PressureLimits(-8.0, 10.0)));
  EXPECT_FALSE(limits.contains(PressureLimits(12.0)));
  EXPECT_EQ(limits.within(PressureLimits(12.0)), PressureLimits(kLower, 12.0));
  // A tenth of the larger side beyond either end.
  EXPECT_NEAR(limits.widened(1.1).lower_kpa, kLower - 0.1 * kUpper, 1e-12);
  EXPECT_NEAR(limits.widened(1.1).upper_kpa, 1.1 * kUpper, 1e-12);
  EXPECT_EQ(to_string(limits), "-11 to 13.8");
  EXPECT_EQ(to_string(PressureLimits(14.0)), "± 14");
}

TEST(PressureLimits, CornersAreOffAndFullToEitherSide) {
  const auto corners = [](const PressureLimits& limits) {
    return std::vector{corner_kpa(limits, 0), corner_kpa(limits, 1), corner_kpa(limits, 2)};
  };
  EXPECT_THAT(corners(100.0), ElementsAre(0.0, 100.0, -100.0));
  EXPECT_THAT(corners({kLower, kUpper}), ElementsAre(0.0, kUpper, kLower));
  EXPECT_THAT(corners({0.0, 80.0}), ElementsAre(0.0, 80.0, 40.0));
  EXPECT_THAT(corners({-80.0, 0.0}), ElementsAre(0.0, -40.0, -80.0));
}

TEST(PressureLimits, AreReadAsANumberOrAsBothEnds) {
  EXPECT_EQ(read(arm_with("14")).segments[0].pressure_limit_kpa, PressureLimits(14.0));
  EXPECT_EQ(read(arm_with("[-11, 13.8]")).segments[0].pressure_limit_kpa,
            PressureLimits(kLower, kUpper));
  EXPECT_EQ(read(arm_with("[0, 13.8]")).segments[0].pressure_limit_kpa,
            PressureLimits(0.0, kUpper));
  const ArmDescription motors = read(motors_with("[-11, 13.8]", "12"));
  EXPECT_EQ(motors.segments[0].pressure_limit_kpa, PressureLimits(kLower, kUpper));
  EXPECT_EQ(motors.segments[1].pressure_limit_kpa, PressureLimits(12.0));
  EXPECT_EQ(read(motors_with("12", "[-9, 8]")).segments[1].pressure_limit_kpa,
            PressureLimits(-9.0, 8.0));
}

TEST(PressureLimits, AreRefusedByFileLineAndField) {
  expect_refused("0", ": 0 found; expected a gauge pressure in kPa, > 0");
  expect_refused("[13.8, -11]", ": [13.8, -11] found; expected [lower, upper] with lower < upper");
  expect_refused("[5, 5]", "");
  expect_refused("[-11, 0, 13.8]", ": [-11, 0, 13.8] found; expected [lower, upper]");
  expect_refused("[1, 13.8]",
                 ": [1, 13.8] found; expected 0 within them: a vented segment is at 0");
  expect_refused("[-11, -1]", ": [-11, -1] found; expected 0 within them");
  expect_refused("[-11, .nan]", "[1]");
  expect_refused("[-11, lots]", "[1]");
  EXPECT_THAT([] { (void)read(motors_with("[4, -4]", "3")); },
              ThrowsMessage<InputError>(HasSubstr("a.yaml:3: command.limit: ")));
}

TEST(PressureLimits, SurviveTheRoundTripAndAreHashed) {
  for (const std::string& text :
       {arm_with("[-11, 13.8]"), arm_with("[0, 13.8]"), motors_with("[-11, 13.8]", "[-9, 8]")}) {
    const ArmDescription arm = read(text);
    const ArmDescription again = read(arm_to_yaml(arm));
    EXPECT_EQ(limits_of(again), limits_of(arm));
    EXPECT_EQ(again.hash(), arm.hash());
    EXPECT_EQ(read_arm_keys(arm_keys_to_yaml(arm), "keys").hash(), arm.hash());
  }
  EXPECT_NE(read(arm_with("[-11, 13.8]")).hash(), read(arm_with("13.8")).hash());
  EXPECT_NE(read(arm_with("[-11, 13.8]")).hash(), read(arm_with("[-12, 13.8]")).hash());
  EXPECT_EQ(read(arm_with("[-13.8, 13.8]")).hash(), read(arm_with("13.8")).hash());
}

// 5 % of the range, to either side.
TEST(PressureLimits, AMeasuredPressureMayOvershootThem) {
  EXPECT_EQ(measured_limits(PressureLimits(100.0)), PressureLimits(110.0));
  EXPECT_EQ(measured_limits(PressureLimits(0.0, 100.0)), PressureLimits(-5.0, 105.0));
  EXPECT_EQ(measured_limits(PressureLimits(-60.0, 100.0)), PressureLimits(-68.0, 108.0));
}

TEST(PressureLimits, AreNamedWhereArmsDiffer) {
  const ArmDescription there = read(motors_with("12", "12"));
  const ArmDescription here = read(motors_with("12", "[-11, 13.8]"));
  EXPECT_THAT(arm_differences(there, here),
              ElementsAre("segments[1].limit: 12 there, [-11, 13.8] here"));
  EXPECT_THAT(why_another_arm(identity_of(there), here, "a file"),
              HasSubstr("segments[1].limit: 12 there, [-11, 13.8] here"));
}

}  // namespace
}  // namespace limber
