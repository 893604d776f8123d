#include "limber/arm/arm_description.hpp"

#include <functional>

#include <gmock/gmock.h>

#include "arm/small_arm_text.hpp"
#include "arm/test_arms.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

TEST(ArmDescription, ReadsEveryKey) {
  const ArmDescription arm = read(kGood);
  EXPECT_EQ(arm.name, "small");
  EXPECT_EQ(arm.frame_rate_hz, 20.0);
  EXPECT_EQ(arm.pressure_step_limit_kpa(), 5.0);
  EXPECT_EQ(arm.actuator_radius_m, 0.006);
  ASSERT_EQ(arm.segment_count(), 1);
  EXPECT_EQ(arm.segments[0].length_m, 0.2);
  EXPECT_EQ(arm.segments[0].width_m, 0.05);
  EXPECT_EQ(arm.segments[0].gaps, 4);
  EXPECT_EQ(arm.segments[0].pressure_limit_kpa, 80.0);
  EXPECT_EQ(arm.segments[0].strain_polynomial, (StrainPolynomial{1e-3, 1e-5, 0.0, 0.0}));
  std::string lines_before_it(11, '\n');
  EXPECT_EQ(arm.virtual_arm.yaml,
            lines_before_it.append("virtual_arm:\n  friction_coefficient: 0.2\n"
                                   "  strength_seed: 3\n"));
  EXPECT_EQ(arm.virtual_arm.file, "a.yaml");
  EXPECT_EQ(arm.point_count(), 5);
}

struct Breakage {
  const char* piece;
  const char* replacement;
  const char* message;  // from its beginning
};

class BrokenArm : public ::testing::TestWithParam<Breakage> {};

TEST_P(BrokenArm, GetsOneMessageWithFileLineFieldFoundAndAllowed) {
  const Breakage& broken = GetParam();
  EXPECT_THAT([&] { read(with(broken.piece, broken.replacement)); },
              ThrowsMessage<InputError>(StartsWith(broken.message)));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BrokenArm,
    ::testing::Values(
        Breakage{"schema: limber/arm/1\n", "", "a.yaml:1: the key 'schema' is missing"},
        Breakage{"limber/arm/1", "limber/arm/2",
                 "a.yaml:1: schema: 'limber/arm/2' found; this program reads 'limber/arm/1'"},
        Breakage{"name: small\n", "", "a.yaml:1: the key 'name' is missing"},
        Breakage{"name: small", "name: ''", "a.yaml:2: name: an empty text found"},
        Breakage{"name: small", "name: [a, b]",
                 "a.yaml:2: name: a list of 2 found; expected a text"},
        Breakage{"frame_rate_hz: 20\n", "", "a.yaml:1: the key 'frame_rate_hz' is missing"},
        Breakage{"frame_rate_hz: 20", "frame_rate_hz: 0",
                 "a.yaml:3: frame_rate_hz: 0 found; expected frames per second, from 1 to 1000"},
        Breakage{"actuator_radius_m: 0.006", "actuator_radius_m: -0.006",
                 "a.yaml:5: actuator_radius_m: -0.006 found; "
                 "expected a length in metres, at least 0"},
        Breakage{"actuator_radius_m: 0.006", "actuator_radius_m: 6",
                 "a.yaml:5: actuator_radius_m: 6 found; expected a length in metres, from 0 to 1. "
                 "Is it in millimetres?"},
        Breakage{"frame_rate_hz", "framerate_hz", "a.yaml:3: framerate_hz: unknown key; allowed"},
        Breakage{"name: small\n", "name: small\nname: other\n",
                 "a.yaml:3: name: the key occurs twice"}));

INSTANTIATE_TEST_SUITE_P(
    Segments, BrokenArm,
    ::testing::Values(
        Breakage{"    width_m: 0.05\n", "", "a.yaml:7: segments[0]: the key 'width_m' is missing"},
        Breakage{"length_m: 0.2", "length_m: 20 cm",
                 "a.yaml:7: segments[0].length_m: '20 cm' found; "
                 "expected a length in metres, a plain finite number"},
        Breakage{"length_m: 0.2", "length_m: 200",
                 "a.yaml:7: segments[0].length_m: 200 found; expected a length in metres, > 0 and "
                 "at most 10. Is it in millimetres?"},
        Breakage{"width_m: 0.05", "width_m: 50",
                 "a.yaml:8: segments[0].width_m: 50 found; expected a length in metres, > 0 and at "
                 "most 10. Is it in millimetres?"},
        Breakage{"width_m: 0.05", "width_m: -0.05",
                 "a.yaml:8: segments[0].width_m: -0.05 found; expected a length in metres, > 0"},
        Breakage{"width_m: 0.05", "width_m: .nan",
                 "a.yaml:8: segments[0].width_m: '.nan' found; expected a length in metres"},
        Breakage{"width_m: 0.05", "width_m:",
                 "a.yaml:8: segments[0].width_m: nothing found; expected a length in metres"},
        Breakage{"gaps: 4", "gaps: 4.5",
                 "a.yaml:9: segments[0].gaps: 4.5 found; expected the number "
                 "of gaps between plates, a whole number"},
        Breakage{"gaps: 4", "gaps: 0", "a.yaml:9: segments[0].gaps: 0 found"},
        Breakage{"pressure_limit_kpa: 80", "pressure_limit_kpa: 0",
                 "a.yaml:10: segments[0].pressure_limit_kpa: 0 "
                 "found; expected a gauge pressure in kPa, > 0"},
        Breakage{"    gaps: 4", "    gaps: 4\n    gaps: 5",
                 "a.yaml:10: segments[0].gaps: the key occurs twice"},
        Breakage{"    gaps: 4", "    plates: 4",
                 "a.yaml:9: segments[0].plates: unknown key; allowed here: length_m"}));

INSTANTIATE_TEST_SUITE_P(
    StrainPolynomials, BrokenArm,
    ::testing::Values(
        Breakage{"[1.0e-3, 1.0e-5, 0, 0]", "[1.0e-3, 1.0e-5, 0]",
                 "a.yaml:11: segments[0].strain_polynomial: 3 coefficients found; expected 4"},
        Breakage{"[1.0e-3, 1.0e-5, 0, 0]", "1.0e-3",
                 "a.yaml:11: segments[0].strain_polynomial: '1.0e-3' found; expected a list"},
        Breakage{"[1.0e-3, 1.0e-5, 0, 0]", "[1.0e-3, big, 0, 0]",
                 "a.yaml:11: segments[0].strain_polynomial[1]: "
                 "'big' found; expected a coefficient"},
        Breakage{"[1.0e-3, 1.0e-5, 0, 0]", "[4.0e-3, -3.0e-5, 0, 0]",
                 "a.yaml:11: segments[0].strain_polynomial: falls at 80 kPa; expected strain that "
                 "never falls between 0 and the limit of 80 kPa"},
        Breakage{"[1.0e-3, 1.0e-5, 0, 0]", "[1.0e-1, 0, 0, 0]",
                 "a.yaml:11: segments[0].strain_polynomial: gives a strain of 8 at the limit"},
        Breakage{"[1.0e-3, 1.0e-5, 0, 0]", "[0, 0, 0, 0]",
                 "a.yaml:11: segments[0].strain_polynomial: gives a strain of 0 at the limit"}));

INSTANTIATE_TEST_SUITE_P(
    VirtualArm, BrokenArm,
    ::testing::Values(Breakage{"strength_seed: 3", "strength_seed: 3\n  strength_seed: 4",
                               "a.yaml:15: virtual_arm.strength_seed: the key occurs twice"},
                      Breakage{"\n  friction_coefficient: 0.2\n  strength_seed: 3\n", " 3\n",
                               "a.yaml:12: virtual_arm: '3' found; expected a mapping"}));

TEST(BrokenArm, EmptyTruncatedOrOtherFiles) {
  constexpr const char* kEmpty = "a.yaml:1: expected a mapping (key: value …), found an empty file";
  EXPECT_THAT([] { read(""); }, ThrowsMessage<InputError>(HasSubstr(kEmpty)));
  EXPECT_THAT([] { read("- 1\n- 2\n"); }, ThrowsMessage<InputError>(HasSubstr("a.yaml:1: ")));
  EXPECT_THAT([] { read("{\"schema\": "); }, ThrowsMessage<InputError>(StartsWith("a.yaml:1:")));
  const std::string text = kGood;
  // Cut anywhere: either an arm without its virtual part, or one message that names the file.
  const std::size_t complete = text.find("virtual_arm");
  for (std::size_t length = 0; length < complete - 1; ++length) {
    try {
      read(text.substr(0, length));
      // A shortened last number or list is another valid file only on the last line.
      EXPECT_GT(length, text.find("strain_polynomial")) << length;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith("a.yaml:")) << length;
    }
  }
}

TEST(BrokenArm, NoSegmentsOrTooMany) {
  const std::string head = std::string(kGood).substr(0, std::string(kGood).find("segments:"));
  EXPECT_THAT([&] { read(head + "segments: []\n"); },
              ThrowsMessage<InputError>("a.yaml:6: segments: 0 segments found; expected 1 to 64"));
  EXPECT_THAT([&] { read(head + "segments: 3\n"); },
              ThrowsMessage<InputError>("a.yaml:6: segments: '3' found; expected a list"));
  EXPECT_THAT([&] { read(arm_to_yaml(arm_of(1)) + "  {"); },
              ThrowsMessage<InputError>(HasSubstr("a.yaml:")));
}

TEST(BrokenArm, MissingFileIsNamed) {
  EXPECT_THAT([] { load_arm("no/such/arm.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("no/such/arm.yaml")));
}

TEST(ArmDescription, SurvivesTheRoundTripExactly) {
  ArmDescription arm = arm_of(5);
  arm.frame_rate_hz = 1000.0 / 7.0;
  arm.actuator_radius_m = 0.1 + 0.2;  // 0.30000000000000004
  arm.segments[2].strain_polynomial = {1.0 / 3.0e3, 1e-300, 0.0, 5e-324};
  arm.virtual_arm.yaml = "virtual_arm:\n  friction_coefficient: 0.33333333333333331\n";
  arm.safety_yaml = "safety:\n  jump_m: 0.02\n  fence: {x_m: [-0.1, 0.4], y_m: [-0.3, 0.3]}\n";
  const ArmDescription back = read(arm_to_yaml(arm));
  EXPECT_EQ(arm_to_yaml(back), arm_to_yaml(arm));
  EXPECT_EQ(back.hash(), arm.hash());
  EXPECT_EQ(back.frame_rate_hz, arm.frame_rate_hz);
  EXPECT_EQ(back.actuator_radius_m, arm.actuator_radius_m);
  EXPECT_EQ(back.segments[2].strain_polynomial, arm.segments[2].strain_polynomial);
  EXPECT_THAT(back.virtual_arm.yaml, ::testing::EndsWith(arm.virtual_arm.yaml));
  EXPECT_THAT(back.safety_yaml,
              ::testing::HasSubstr("fence: {x_m: [-0.1, 0.4], y_m: [-0.3, 0.3]}"));
}

TEST(ArmDescription, ARateAtWhichNoMotionEndsIsRefused) {
  ArmDescription arm = arm_of(2);
  arm.pressure_rate_limit_kpa_per_s = 1e-6;
  EXPECT_THAT([&] { (void)read(arm_to_yaml(arm)); },
              ThrowsMessage<InputError>(HasSubstr(
                  "pressure_rate_limit_kpa_per_s: 1e-06 found; expected a rate at which")));
}

TEST(ArmDescription, AnyNameSurvivesTheRoundTrip) {
  for (const char* name : {"plain",
                           "two words",
                           "a: b",
                           "# no comment",
                           "- dash",
                           "[x]",
                           "{y}",
                           "&a",
                           "*b",
                           "!t",
                           "%d",
                           "@at",
                           "'q'",
                           "\"dq\"",
                           "back\\slash",
                           "null",
                           "~",
                           "true",
                           "3.5",
                           "été 臂",
                           "tab\there",
                           "line\nbreak",
                           " lead and trail "}) {
    ArmDescription arm = arm_of(1);
    arm.name = name;
    EXPECT_EQ(read(arm_to_yaml(arm)).name, name);
  }
}

TEST(ArmDescription, ForCharacterisationPolynomialsAreReadWhereTheyCanBeUsed) {
  const auto polynomial = [](const std::string& text) {
    return read_arm(YamlReader::from_text(text, "a.yaml"), PolynomialsOf::characterisation)
        .segments[0]
        .strain_polynomial;
  };
  EXPECT_EQ(polynomial(kGood), (StrainPolynomial{1e-3, 1e-5, 0.0, 0.0}));
  const std::string key = "strain_polynomial: [1.0e-3, 1.0e-5, 0, 0]";
  for (const char* outdated :
       {"strain_polynomial: []", "strain_polynomial: [-1, 0, 0, 0]", "strain_polynomial:"}) {
    EXPECT_EQ(polynomial(with(key, outdated)), StrainPolynomial{}) << outdated;
  }
}

TEST(ArmDescription, HashDependsOnTheShapeAloneAndOnAllOfIt) {
  const ArmDescription arm = arm_of(2);
  ArmDescription other = arm;
  other.name = "renamed";
  other.virtual_arm.yaml = "virtual_arm:\n  friction_coefficient: 0.7\n";
  EXPECT_EQ(other.hash(), arm.hash());
  other.segments[1].strain_polynomial[3] += 1e-15;
  EXPECT_NE(other.hash(), arm.hash());
}

constexpr const char* kMotor = R"(schema: limber/arm/1
name: motors
command: {name: motor angle, unit: rad, limit: 1.5, rate_limit_per_s: 3}
no_load: curvature
frame_rate_hz: 20
actuator_radius_m: 0.004
segments:
  - {length_m: 0.2, width_m: 0.04, gaps: 4, curvature_per_unit: 4}
  - {length_m: 0.2, width_m: 0.03, gaps: 4, curvature_per_unit: -5, limit: 1.2}
)";

TEST(ArmOfAnotherCommand, IsReadAndSurvivesTheRoundTrip) {
  const ArmDescription arm = read(kMotor);
  EXPECT_EQ(arm.command.name, "motor angle");
  EXPECT_EQ(arm.command.unit, "rad");
  EXPECT_EQ(arm.no_load, NoLoadKind::curvature);
  EXPECT_EQ(arm.segments[0].pressure_limit_kpa, 1.5);
  EXPECT_EQ(arm.segments[1].pressure_limit_kpa, 1.2);
  EXPECT_EQ(arm.segments[1].curvature_per_unit, -5.0);
  EXPECT_EQ(arm.pressure_rate_limit_kpa_per_s, 3.0);
  const ArmDescription again = read(arm_to_yaml(arm));
  EXPECT_EQ(again.hash(), arm.hash());
  EXPECT_EQ(arm_to_yaml(again), arm_to_yaml(arm));
}

TEST(ArmOfAnotherCommand, MayTurnByHalfATurnInEachGap) {
  std::string text = kMotor;
  const std::string piece = "gaps: 4, curvature_per_unit: 4}";
  text.replace(text.find(piece), piece.size(), "gaps: 2, curvature_per_unit: 12}");
  EXPECT_EQ(read(text).segments[0].curvature_per_unit, 12.0);
}

TEST(ArmOfAnotherCommand, HashesEverythingThatItSays) {
  const ArmDescription arm = read(kMotor);
  for (const auto& change : std::vector<std::function<void(ArmDescription&)>>{
           [](ArmDescription& a) { a.command.unit = "deg"; },
           [](ArmDescription& a) { a.no_load = NoLoadKind::straight; },
           [](ArmDescription& a) { a.segments[0].curvature_per_unit = 4.1; },
           [](ArmDescription& a) { a.segments[1].pressure_limit_kpa = 1.3; }}) {
    ArmDescription other = arm;
    change(other);
    EXPECT_NE(other.hash(), arm.hash());
  }
}

TEST(ArmOfAnotherCommand, NamesWhatDoesNotBelong) {
  const auto refuses = [](const std::string& piece, const std::string& replacement,
                          const std::string& message) {
    std::string text = kMotor;
    text.replace(text.find(piece), piece.size(), replacement);
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<InputError>(HasSubstr(message))) << message;
  };
  refuses("frame_rate_hz: 20", "frame_rate_hz: 20\npressure_rate_limit_kpa_per_s: 100",
          "has its rate in command.rate_limit_per_s");
  refuses("limit: 1.2", "pressure_limit_kpa: 1.2",
          "unknown key; allowed here: length_m, width_m, gaps, limit, curvature_per_unit");
  refuses("curvature_per_unit: 4}", "curvature_per_unit: 0}", "or 'no_load: straight'");
  refuses(", curvature_per_unit: 4}", "}", "the key 'curvature_per_unit' is missing");
  refuses("limit: 1.5", "limit: 15",
          "would turn the segment by 12 rad; expected at most 6.283, a full turn");
  refuses("gaps: 4, curvature_per_unit: 4}", "gaps: 1, curvature_per_unit: 12}",
          "would turn the segment by 3.6 rad; expected at most 3.142, half a turn for its gap");
  refuses("no_load: curvature", "no_load: bent",
          "expected strain_polynomial, curvature or straight");
  refuses("limit: 1.5,", "", "the key 'limit' is missing");
  refuses("no_load: curvature", "no_load: curvature\nvirtual_arm: {}",
          "driven by pressures in kPa");
}

// Models and recordings store these: an arm file without newer keys must keep its hash.
TEST(ArmDescription, FindsTheSegmentOfAGap) {
  const ArmDescription arm = arm_of(3);  // 3, 4 and 5 gaps
  const std::vector<int> expected = {0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 2};
  for (int gap = 0; gap < int(expected.size()); ++gap) {
    EXPECT_EQ(arm.segment_of_gap(gap), expected[std::size_t(gap)]) << gap;
  }
}

}  // namespace
}  // namespace limber
