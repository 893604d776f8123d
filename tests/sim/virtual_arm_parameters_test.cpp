#include "limber/sim/virtual_arm_parameters.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "arm/small_arm_text.hpp"
#include "limber/common/error.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::filesystem::path kArms = std::filesystem::path(LIMBER_SOURCE_DIR) / "arms";

/// An arm file whose lines 12 and 13 say `entry` of the virtual arm.
std::string with_entry(const std::string& entry) {
  const std::string arm = kGood;
  return arm.substr(0, arm.find("friction_coefficient")) + entry + "\n";
}

TEST(VirtualArmParameters, AreReadFromTheArmsFile) {
  const VirtualArmParameters parameters =
      virtual_arm_parameters(read(with_entry("friction_coefficient: 0.2\n\n  strength_seed: 3\n"
                                             "  actuator_extension_n: [1, 2, 3, 4]")));
  EXPECT_EQ(parameters.friction_coefficient, 0.2);
  EXPECT_EQ(parameters.strength_seed, 3u);
  EXPECT_EQ(parameters.actuator_extension_n, (QuarticCoefficients{1, 2, 3, 4}));
  EXPECT_EQ(parameters.time_step_s, VirtualArmParameters{}.time_step_s) << "not given";
}

TEST(VirtualArmParameters, WhatIsWrongIsNamedByFileLineAndKey) {
  const auto refuses = [](const std::string& entry, const std::string& message) {
    EXPECT_THAT([&] { virtual_arm_parameters(read(with_entry(entry))); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refuses("friction_coefficient: -1", "a.yaml:13: virtual_arm.friction_coefficient: -1 found");
  refuses("friction: 0.2", "a.yaml:13: virtual_arm.friction: unknown parameter of the virtual arm");
  refuses("# a comment\n\n  friction: 0.2",
          "a.yaml:15: virtual_arm.friction: unknown parameter of the virtual arm");
  refuses("actuator_extension_n: [1, 2]", "a.yaml:13: virtual_arm.actuator_extension_n: 2 coeff");
  refuses("strength_seed: {a: 1}", "a.yaml:13: virtual_arm.strength_seed");
}

TEST(VirtualArmParameters, DefaultsAndThePapersArmSayTheSame) {
  // A fit of the virtual arm that changes one must change both.
  ArmDescription paper = load_arm(kArms / "three_segment.yaml");
  const std::string file = virtual_arm_to_yaml(paper);
  set_virtual_arm_parameters(paper, VirtualArmParameters{});
  EXPECT_EQ(virtual_arm_to_yaml(paper), file);
  paper.virtual_arm.yaml.clear();
  EXPECT_EQ(virtual_arm_to_yaml(paper), file);
}

TEST(VirtualArmParameters, ThoseThatCameLaterAreWrittenWhereTheyAreUsedAlone) {
  ArmDescription arm = sample_arm(2);
  const std::string plain = virtual_arm_to_yaml(arm);
  for (const char* key :
       {"valve_dead_time_s", "inflate_rate_limit_kpa_per_s", "vent_rate_limit_kpa_per_s",
        "actuator_strain_scale", "actuator_bow", "gap_length_spread", "table_tilt_rad",
        "table_downhill_rad", "friction_static_excess", "friction_stribeck_m_per_s",
        "friction_viscous_s_per_m"}) {
    EXPECT_EQ(plain.find(key), std::string::npos) << key;
  }
  change_virtual_arm(arm, [](VirtualArmParameters& p) {
    p.valve_dead_time_s = 0.13;
    p.inflate_rate_limit_kpa_per_s = 60.0;
    p.vent_rate_limit_kpa_per_s = 140.0;
    p.friction_stribeck_m_per_s = 0.05;
  });
  const ArmDescription back = read(virtual_arm_to_yaml(arm));
  EXPECT_EQ(virtual_arm_parameters(back).valve_dead_time_s, 0.13);
  EXPECT_EQ(virtual_arm_parameters(back).inflate_rate_limit_kpa_per_s, 60.0);
  EXPECT_EQ(virtual_arm_parameters(back).vent_rate_limit_kpa_per_s, 140.0);
  EXPECT_EQ(virtual_arm_parameters(back).friction_stribeck_m_per_s, 0.05);
  EXPECT_EQ(back.hash(), sample_arm(2).hash()) << "an arm's hash leaves physics out";
}

TEST(VirtualArmParameters, SurviveTheRoundTripExactly) {
  ArmDescription arm = sample_arm(2);
  change_virtual_arm(arm, [](VirtualArmParameters& p) {
    p.friction_coefficient = 1.0 / 3.0;
    p.actuator_threshold_kpa[2] = 0.1 + 0.2;
    p.strength_seed = 999;
  });
  const VirtualArmParameters back = virtual_arm_parameters(read(arm_to_yaml(arm)));
  EXPECT_EQ(back.friction_coefficient, 1.0 / 3.0);
  EXPECT_EQ(back.actuator_threshold_kpa[2], 0.1 + 0.2);
  EXPECT_EQ(back.strength_seed, 999u);
}

TEST(VirtualArmParameters, DifferencesAreJsonOfWhatDiffersAlone) {
  const VirtualArmParameters of;
  EXPECT_EQ(physics_differences(of, of), "{}");
  VirtualArmParameters varied = of;
  varied.friction_coefficient = 0.31;
  varied.actuator_extension_n[1] = 2.5;
  varied.tip_load_kg = 1e-7;
  varied.strength_seed = 12;
  EXPECT_EQ(physics_differences(of, varied),
            "{\"friction_coefficient\": 0.31, \"tip_load_kg\": 1e-07, "
            "\"actuator_extension_n\": [62.596, 2.5, 89998, 0], \"strength_seed\": 12}");
}

/// The same of an arm in space.
std::string in_space_with_entry(const std::string& entry) {
  return R"(schema: limber/arm/1
name: small
dimension: 3
no_load: straight
frame_rate_hz: 20
pressure_rate_limit_kpa_per_s: 100
actuator_radius_m: 0.006
segments:
  - length_m: 0.2
    width_m: 0.05
    gaps: 4
    chambers: [{pressure_limit_kpa: [0, 80]}]
virtual_arm:
  )" + entry +
         "\n";
}

TEST(VirtualArmParameters, KeysOfTheOtherKindOfArmAreRefusedByName) {
  EXPECT_THAT(
      [] { virtual_arm_parameters(read(in_space_with_entry("friction_coefficient: 0.2"))); },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("a.yaml:14"), HasSubstr("friction_coefficient"),
                HasSubstr("belongs to the virtual arm in a plane, and this arm is in space"))));
  EXPECT_THAT([] { virtual_arm_parameters(read(in_space_with_entry("weak_side: 1"))); },
              ThrowsMessage<InputError>(HasSubstr("belongs to the virtual arm in a plane")));
  EXPECT_THAT([] { virtual_arm_parameters(read(with_entry("joint_friction_n_m: 0.2"))); },
              ThrowsMessage<InputError>(
                  HasSubstr("belongs to the virtual arm in space, and this arm is in a plane")));
}

TEST(VirtualArmParameters, OfAnArmInSpaceSurviveTheRoundTrip) {
  ArmDescription arm = read(in_space_with_entry("joint_friction_n_m: 0.25"));
  EXPECT_EQ(virtual_arm_parameters(arm).joint_friction_n_m, 0.25);
  change_virtual_arm(arm, [](VirtualArmParameters& p) { p.wall_stiffening = 1.0 / 3.0; });
  EXPECT_EQ(arm.virtual_arm.yaml.find("table_tilt_rad"), std::string::npos);
  const VirtualArmParameters back = virtual_arm_parameters(read(arm_to_yaml(arm)));
  EXPECT_EQ(back.joint_friction_n_m, 0.25);
  EXPECT_EQ(back.wall_stiffening, 1.0 / 3.0);
}

TEST(VirtualArmHash, IsOfThePhysicsAndNotOfSafety) {
  const ArmDescription arm = sample_arm(2);
  ArmDescription other = arm;
  other.safety_yaml = "safety:\n  jump_m: 0.1\n";
  EXPECT_EQ(virtual_arm_hash(other), virtual_arm_hash(arm));
  change_virtual_arm(other, [](VirtualArmParameters& p) { p.friction_coefficient += 0.01; });
  EXPECT_NE(virtual_arm_hash(other), virtual_arm_hash(arm));
}

}  // namespace
}  // namespace limber
