#include "limber/arm/arm_identity.hpp"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/common/error.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::ThrowsMessage;

// What two machines make of one bench test, measured: 2e-7 of strain.
constexpr double kMachinesApart = 2e-7;

/// The arm with every strain changed by `strain` at the pressure limit.
ArmDescription refitted(ArmDescription arm, double strain) {
  for (Segment& segment : arm.segments) {
    segment.strain_polynomial[0] += strain / segment.pressure_limit_kpa.largest_kpa();
  }
  return arm;
}

TEST(ArmIdentity, AnotherMachinesFitOfTheSameBenchTestIsTheSameArm) {
  const ArmDescription arm = arm_of(3);
  const ArmDescription elsewhere = refitted(arm, kMachinesApart);
  ASSERT_NE(elsewhere.hash(), arm.hash());
  EXPECT_EQ(why_another_arm(identity_of(arm), elsewhere, "m"), "");
  EXPECT_EQ(why_another_arm(identity_of(elsewhere), arm, "m"), "");
}

// Coefficients may differ by more than the strain that they make: what they make counts.
TEST(ArmIdentity, PolynomialsAreComparedByTheirStrain) {
  const ArmDescription arm = arm_of(1);
  ArmDescription other = arm;
  Segment& segment = other.segments[0];
  const double limit = segment.pressure_limit_kpa.largest_kpa();
  segment.strain_polynomial[3] += 8.0 * kSameStrain / std::pow(limit, 4);
  segment.strain_polynomial[2] -= 8.0 * kSameStrain / std::pow(limit, 3);
  // 8 (u⁴ − u³) is largest at u = 3/4: 0.84.
  EXPECT_THAT(arm_differences(arm, other), IsEmpty());
  segment.strain_polynomial[2] = arm.segments[0].strain_polynomial[2];
  EXPECT_THAT(arm_differences(arm, other),
              ElementsAre(AllOf(HasSubstr("segments[0].strain_polynomial: a strain of "),
                                HasSubstr("at 100 kPa"))));
}

TEST(ArmIdentity, ASecondsRealFitIsAnotherArm) {
  const ArmDescription arm = arm_of(2);
  EXPECT_THAT(arm_differences(arm, refitted(arm, 1e-4)),
              ElementsAre(HasSubstr("segments[0].strain_polynomial"),
                          HasSubstr("segments[1].strain_polynomial")));
}

TEST(ArmIdentity, LeavesTheRateLimitOutAndKeepsIt) {
  const ArmDescription arm = arm_of(2);
  ArmDescription slow = arm;
  slow.pressure_rate_limit_kpa_per_s = 50.0;
  EXPECT_THAT(arm_differences(arm, slow), testing::IsEmpty());
  EXPECT_EQ(why_another_arm(identity_of(slow), arm, "the plan"), "");
  EXPECT_EQ(rate_limit_of(identity_of(slow), "the plan"), 50.0);
  EXPECT_EQ(rate_limit_of({"a", "hash", ""}, "the plan"), std::nullopt);
}

TEST(ArmIdentity, NamesEveryKeyThatDiffersWithBothValues) {
  const ArmDescription arm = arm_of(2);
  const auto expect = [&](const std::function<void(ArmDescription&)>& change,
                          const std::string& difference) {
    ArmDescription other = arm;
    change(other);
    EXPECT_THAT(arm_differences(arm, other), ElementsAre(difference));
  };
  expect([](ArmDescription& a) { a.segments[1].length_m = 0.25; },
         "segments[1].length_m: 0.215 there, 0.25 here");
  expect([](ArmDescription& a) { a.segments[0].width_m = 0.06; },
         "segments[0].width_m: 0.05 there, 0.06 here");
  expect([](ArmDescription& a) { a.segments[0].gaps = 7; }, "segments[0].gaps: 3 there, 7 here");
  expect([](ArmDescription& a) { a.frame_rate_hz = 40.0; }, "frame_rate_hz: 20 there, 40 here");
  expect([](ArmDescription& a) { a.actuator_radius_m = 0.0; },
         "actuator_radius_m: 0.006 there, 0 here");
  expect([](ArmDescription& a) { a.segments.pop_back(); }, "segments: 2 there, 1 here");
  expect([](ArmDescription& a) { a.segments[1].pressure_limit_kpa = 96.0; },
         "segments[1].pressure_limit_kpa: 95 there, 96 here");
}

TEST(ArmIdentity, NamesEveryKeyOfAnArmOfAnotherCommand) {
  const ArmDescription arm = curvature_arm_of(1);
  ArmDescription other = arm;
  other.command.unit = "deg";
  other.no_load = NoLoadKind::straight;
  EXPECT_THAT(arm_differences(arm, other),
              ElementsAre("command.unit: 'rad' there, 'deg' here",
                          "no_load: 'curvature' there, 'straight' here"));
  other = arm;
  other.segments[0].pressure_limit_kpa = 2.0;
  other.segments[0].curvature_per_unit = -4.0;
  EXPECT_THAT(arm_differences(arm, other),
              ElementsAre("segments[0].limit: 1.5 there, 2 here",
                          "segments[0].curvature_per_unit: 4 there, -4 here"));
}

TEST(ArmIdentity, NamesEveryKeyOfAnArmInSpace) {
  const ArmDescription arm = testing_support::space_arm();
  const auto expect = [&](const std::function<void(ArmDescription&)>& change,
                          const std::string& difference) {
    ArmDescription other = arm;
    change(other);
    EXPECT_NE(other.hash(), arm.hash());
    EXPECT_THAT(arm_differences(arm, other), ElementsAre(HasSubstr(difference)));
  };
  expect([](ArmDescription& a) { a.gravity[0] = -1.0; }, "gravity[0]: 1 there, -1 here");
  expect([](ArmDescription& a) { a.segments[1].chambers.pop_back(); },
         "segments[1].chambers: 3 there, 2 here");
  expect([](ArmDescription& a) { a.segments[1].chambers[2].angle_deg = 290.0; },
         "segments[1].chambers[2].angle_deg: 300 there, 290 here");
  expect([](ArmDescription& a) { a.segments[0].chambers[0].radius_m = 0.03; },
         "segments[0].chambers[0].radius_m: 0.02 there, 0.03 here");
  expect([](ArmDescription& a) { a.segments[0].chambers[0].sense = -1; },
         "segments[0].chambers[0].sense: 1 there, -1 here");
  expect(
      [](ArmDescription& a) {
        a.segments[0].chambers[1].limit_kpa = {0.0, 90.0};
      },
      "segments[0].chambers[1].pressure_limit_kpa: [0, 100] there, [0, 90] here");
  expect([](ArmDescription& a) { a.segments[0].chambers[1].strain_polynomial[0] = 0.003; },
         "segments[0].chambers[1].strain_polynomial: a strain of");
  EXPECT_THAT(arm_differences(arm, arm_of(2)), ElementsAre("dimension: 3 there, 2 here"));
}

TEST(ArmIdentity, FitsOfAnArmInSpaceAreCompared) {
  ArmDescription arm = testing_support::space_arm();
  arm.no_load = NoLoadKind::fitted;
  for (Segment& segment : arm.segments) {
    segment.shape_of_strains = Eigen::MatrixXd::Constant(3, 6, 0.5);
  }
  ArmDescription other = arm;
  other.segments[1].shape_of_strains(2, 4) = 0.6;
  EXPECT_THAT(arm_differences(arm, other),
              ElementsAre("segments[1].shape_of_strains[2][4]: 0.5 there, 0.6 here"));
}

// `collect` records arms that are not characterised yet, and their recordings are read later.
TEST(ArmIdentity, AnArmWithoutPolynomialsIsTheOneThatTheyWereFittedTo) {
  const ArmDescription fitted = arm_of(1);
  ArmDescription raw = fitted;
  raw.segments[0].strain_polynomial = {};
  EXPECT_THAT(why_another_arm(identity_of(raw), fitted, "r.h5"),
              HasSubstr("segments[0].strain_polynomial: a strain of 0.000000 there"));
}

TEST(ArmIdentity, NumbersAgreeToAMillionth) {
  const ArmDescription arm = arm_of(1);
  ArmDescription other = arm;
  other.segments[0].length_m *= 1.0 + 0.5 * kSameNumber;
  EXPECT_THAT(arm_differences(arm, other), IsEmpty());
  other.segments[0].length_m = arm.segments[0].length_m * (1.0 + 2.0 * kSameNumber);
  EXPECT_THAT(arm_differences(arm, other), Not(IsEmpty()));
  other = arm;
  other.name = "renamed";
  other.virtual_arm.yaml = "virtual_arm:\n  friction_coefficient: 0.7\n";
  EXPECT_THAT(arm_differences(arm, other), IsEmpty());
}

TEST(ArmIdentity, AFileWithAHashAloneIsOfTheArmOfThatHash) {
  const ArmDescription arm = arm_of(2);
  ArmIdentity of_before = identity_of(arm);
  of_before.description.clear();
  EXPECT_EQ(why_another_arm(of_before, arm, "m"), "");
  EXPECT_THAT(why_another_arm(of_before, refitted(arm, kMachinesApart), "m"),
              HasSubstr("what differs is not known"));
}

TEST(ArmIdentity, DescriptionReadsBackForEveryKindOfArm) {
  for (ArmDescription arm : {arm_of(4), curvature_arm_of(2)}) {
    arm.name = "line\nbreak: \"x\"";
    const ArmIdentity identity = identity_of(arm);
    EXPECT_EQ(identity.name, arm.name);
    EXPECT_THAT(identity.description, Not(HasSubstr("limber/arm"))) << "no arm file itself";
    const ArmDescription back = read_arm_keys(identity.description, "a");
    EXPECT_EQ(back.hash(), arm.hash());
    EXPECT_EQ(back.name, arm.name);
  }
}

TEST(ArmIdentity, ABrokenDescriptionNamesTheFile) {
  ArmIdentity identity = identity_of(arm_of(1));
  identity.hash = "0";
  identity.description = "name: x\n";
  EXPECT_THAT([&] { (void)why_another_arm(identity, arm_of(1), "model.safetensors"); },
              ThrowsMessage<InputError>(HasSubstr("model.safetensors: arm_description")));
}

TEST(ArmIdentity, SaysHowManyMoreKeysDiffer) {
  const ArmDescription there = arm_of(4);
  const std::string why = why_another_arm(identity_of(there), refitted(there, 0.01), "m");
  EXPECT_THAT(why, HasSubstr("segments[3].strain_polynomial"));
  ArmDescription here = refitted(there, 0.01);
  here.segments[0].width_m = 0.1;
  EXPECT_THAT(why_another_arm(identity_of(there), here, "m"), HasSubstr("; and 1 more"));
}

}  // namespace
}  // namespace limber
