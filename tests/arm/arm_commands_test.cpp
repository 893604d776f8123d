// Arms with other commands than one for each segment.
#include "limber/arm/arm_commands.hpp"

#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/characterisation.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

constexpr double kRounding = 1e-12;

/// Three segments, each bent by a pair; the last pair's tendons pull at the segment before, too.
constexpr const char* kSixMotors =
    "commands:\n"
    "  - {name: motor_0, acts_on: {0: 1.0}}\n"
    "  - {name: motor_1, acts_on: {0: -1.0}}\n"
    "  - {name: motor_2, acts_on: {1: 0.5}}\n"
    "  - {name: motor_3, acts_on: {1: -0.5}}\n"
    "  - {name: motor_4, acts_on: {1: 0.25, 2: 1}}\n"
    "  - {name: motor_5, acts_on: {1: -0.25, 2: -1}}\n";

std::string six_motor_text() {
  return arm_to_yaml(curvature_arm_of(3)) + kSixMotors;
}

ArmDescription read_six(const std::string& text) {
  return read_arm(YamlReader::from_text(text, "a.yaml"));
}

std::string exchanged(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

void expect_six_refused(const std::string& from, const std::string& to, const std::string& part) {
  EXPECT_THAT([&] { read_six(exchanged(six_motor_text(), from, to)); },
              ThrowsMessage<InputError>(::testing::AllOf(StartsWith("a.yaml:"), HasSubstr(part))));
}

TEST(ArmCommands, SegmentsGetTheWeightedSum) {
  const ArmDescription arm = read_six(six_motor_text());
  ASSERT_EQ(arm.commands.size(), 6U);
  const Eigen::VectorXd motors{{1.0, -2.0, 3.0, 4.0, 5.0, 7.0}};
  const Eigen::VectorXd expected{{3.0, -0.5 - 0.5, -2.0}};
  EXPECT_TRUE(segment_commands(arm, motors).isApprox(expected, kRounding));
}

TEST(ArmCommands, AnArmWithoutThemHasOneForEachSegment) {
  const ArmDescription arm = arm_of(3);
  EXPECT_EQ(command_shares(arm), Eigen::MatrixXd::Identity(3, 3));
  const Eigen::VectorXd pressures{{1.0, -2.0, 3.0}};
  EXPECT_EQ(segment_commands(arm, pressures), pressures);
}

TEST(ArmCommands, GoBackToSegmentsExactlyAndAreSmallest) {
  const ArmDescription arm = read_six(six_motor_text());
  const Eigen::VectorXd wanted{{0.4, -1.1, 0.7}};
  const Eigen::VectorXd motors = commands_for(arm, wanted);
  EXPECT_TRUE(segment_commands(arm, motors).isApprox(wanted, kRounding));
  EXPECT_NEAR(motors[0], 0.2, kRounding);
  EXPECT_NEAR(motors[1], -0.2, kRounding);
  // What moves no segment is orthogonal to the smallest commands: both motors of a pair alike.
  for (Eigen::Index pair = 0; pair < 3; ++pair) {
    EXPECT_NEAR(motors[2 * pair] + motors[2 * pair + 1], 0.0, kRounding) << pair;
  }
}

TEST(ArmCommands, APairOfHalvesGetsTheWholeCommand) {
  ArmDescription arm = arm_of(1);
  arm.commands = {{"right", {0.5}}, {"left", {-0.5}}};
  const Eigen::VectorXd motors = commands_for(arm, Eigen::VectorXd::Constant(1, 0.8));
  EXPECT_NEAR(motors[0], 0.8, kRounding);
  EXPECT_NEAR(motors[1], -0.8, kRounding);
}

TEST(ArmCommands, OtherSizesAreRefused) {
  const ArmDescription arm = read_six(six_motor_text());
  EXPECT_THAT([&] { segment_commands(arm, Eigen::VectorXd::Zero(3)); },
              ThrowsMessage<InputError>(HasSubstr("3 commands; arm 'test_arm_of_3' has 6")));
  EXPECT_THAT([&] { commands_for(arm, Eigen::VectorXd::Zero(6)); },
              ThrowsMessage<InputError>(HasSubstr("6 commands of segments; arm 'test_arm_of_3'")));
}

TEST(ArmCommands, ReadAsPeopleWriteThem) {
  const ArmDescription arm = read_six(six_motor_text());
  EXPECT_EQ(command_sum(arm, 0), "motor_0 - motor_1");
  EXPECT_EQ(command_sum(arm, 1), "0.5 motor_2 - 0.5 motor_3 + 0.25 motor_4 - 0.25 motor_5");
}

TEST(ArmCommands, SurviveTheRoundTripExactly) {
  ArmDescription arm = read_six(six_motor_text());
  arm.commands[0].name = "tendon: \\ #0 °";
  arm.commands[4].shares[1] = 1.0 / 3.0;
  const ArmDescription back = read_six(arm_to_yaml(arm));
  EXPECT_EQ(arm_to_yaml(back), arm_to_yaml(arm));
  EXPECT_EQ(back.commands[0].name, arm.commands[0].name);
  EXPECT_EQ(back.commands[4].shares, arm.commands[4].shares);
}

TEST(ArmCommands, SharesMakeAnotherArmAndNamesDoNot) {
  const ArmDescription arm = read_six(six_motor_text());
  EXPECT_NE(arm.hash(), curvature_arm_of(3).hash());
  ArmDescription other = arm;
  other.commands[0].name = "m0";
  EXPECT_EQ(other.hash(), arm.hash());
  EXPECT_TRUE(arm_differences(other, arm).empty());
  other.commands[4].shares[1] = 0.3;
  EXPECT_NE(other.hash(), arm.hash());
  EXPECT_THAT(arm_differences(other, arm),
              ::testing::ElementsAre("commands[4].acts_on[1]: 0.3 there, 0.25 here"));
  EXPECT_THAT(arm_differences(curvature_arm_of(3), arm),
              ::testing::ElementsAre("commands: 0 there, 6 here"));
}

TEST(ArmCommands, FittedPolynomialsLeaveThemInTheFile) {
  ArmDescription arm = arm_of(1);
  arm.commands = {{"right", {1.0}}, {"left", {-1.0}}};
  const std::string text = arm_to_yaml(arm);
  arm.segments[0].strain_polynomial = {1.25e-3, 0.0, 0.0, 0.0};
  const std::string edited = with_strain_polynomials(text, arm);
  EXPECT_EQ(arm_to_yaml(read_six(edited)), arm_to_yaml(arm));
  arm.segments[0].width_m = 0.03;  // not edited in place
  EXPECT_EQ(read_six(with_strain_polynomials(text, arm)).commands.size(), 2U);
}

TEST(BrokenArmCommands, AreRefusedByNameAndLine) {
  expect_six_refused("name: motor_1", "name: motor_0", "'motor_0' is the name of another command");
  expect_six_refused("name: motor_1", "name: -motor_1", "without a sign");
  expect_six_refused("name: motor_1", "name: \"a,b\"", "commas");
  expect_six_refused("acts_on: {0: 1.0}", "acts_on: {3: 1.0}",
                     "commands[0].acts_on.3: no segment '3'; expected 0 to 2, the base first");
  expect_six_refused("acts_on: {0: 1.0}", "acts_on: {base: 1.0}", "no segment 'base'");
  expect_six_refused("acts_on: {0: 1.0}", "acts_on: {}", "the command acts on nothing");
  expect_six_refused("acts_on: {0: 1.0}", "acts_on: {0: 0}", "the command acts on nothing");
  expect_six_refused("acts_on: {0: 1.0}", "acts_on: {0: .nan}", "a share of the command");
  expect_six_refused("acts_on: {0: 1.0}", "moves: {0: 1.0}", "unknown key");
}

TEST(BrokenArmCommands, EverySegmentHasToBeMovedByItself) {
  const std::string arm = arm_to_yaml(curvature_arm_of(3));
  const auto refused = [&](const std::string& list, const std::string& part) {
    EXPECT_THAT([&] { read_six(arm + "commands:\n" + list); },
                ThrowsMessage<InputError>(HasSubstr(part)));
  };
  refused("  - {name: a, acts_on: {0: 1, 2: 1}}\n", "no command acts on segment 1");
  refused("  - {name: a, acts_on: {1: 1, 2: 1}}\n", "no command acts on segment 0");
  refused("  - {name: a, acts_on: {0: 1}}\n  - {name: b, acts_on: {1: 1, 2: 0.5}}\n",
          "2 commands can't move segment 2 apart from the segments before it. Where one command "
          "bends several discs, make them one segment with all their plates");
  refused(
      "  - {name: a, acts_on: {0: 1, 1: 2}}\n  - {name: b, acts_on: {0: 3, 1: 6}}\n"
      "  - {name: c, acts_on: {2: 1}}\n",
      "3 commands can't move segment 1");
}

}  // namespace
}  // namespace limber
