// An arm file with fitted numbers: what people wrote beside them stays.
#include <filesystem>

#include <gmock/gmock.h>

#include "arm/small_arm_text.hpp"
#include "limber/arm/characterisation.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

TEST(WithStrainPolynomials, KeepsEveryCommentAndChangesNothingElse) {
  const std::filesystem::path file =
      std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/five_segment.yaml";
  const std::string text = read_file(file);
  ArmDescription arm = load_arm(file);
  EXPECT_EQ(with_strain_polynomials(text, arm), text);  // the same numbers: the same file
  arm.segments[3].strain_polynomial = {1.25e-3, 0.0, 0.0, 0.0};
  const std::string edited = with_strain_polynomials(text, arm);
  EXPECT_EQ(arm_to_yaml(read(edited)), arm_to_yaml(arm));
  EXPECT_THAT(edited, HasSubstr("[0.00125, 0, 0, 0]"));
  EXPECT_THAT(edited, HasSubstr("# [C] braid friction"));
}

TEST(WithStrainPolynomials, FillsAnArmThatWasNeverCharacterised) {
  const std::string empty = with("[1.0e-3, 1.0e-5, 0, 0]", "[]  # to be measured");
  EXPECT_THAT([&] { read(empty); },
              ThrowsMessage<InputError>(StartsWith(
                  "a.yaml:11: segments[0].strain_polynomial: 0 coefficients found; expected 4")));
  ArmDescription arm =
      read_arm(YamlReader::from_text(empty, "a.yaml"), PolynomialsOf::characterisation);
  arm.segments[0].strain_polynomial = {2e-3, 0.0, 0.0, 0.0};
  EXPECT_EQ(with_strain_polynomials(empty, arm),
            with("[1.0e-3, 1.0e-5, 0, 0]", "[0.002, 0, 0, 0]  # to be measured"));
  const std::string missing = with("    strain_polynomial: [1.0e-3, 1.0e-5, 0, 0]\n", "");
  const std::string filled = with_strain_polynomials(missing, arm);
  EXPECT_EQ(arm_to_yaml(read(filled)), arm_to_yaml(arm));
  EXPECT_THAT(filled, HasSubstr("  - strain_polynomial: [0.002, 0, 0, 0]\n    length_m: 0.2\n"));
}

// What it fits in space: a matrix for each segment, which the file may have or not.
TEST(WithStrainPolynomials, KeepsTheCommentsOfAnArmInSpace) {
  std::string text = std::string("# hangs from the ceiling\n") + testing_support::kSpaceArm;
  ArmDescription arm = testing_support::space_arm(text);
  arm.no_load = NoLoadKind::fitted;
  for (Segment& segment : arm.segments) {
    segment.shape_of_strains = Eigen::MatrixXd::Constant(3, 6, 0.25);
  }
  arm.segments[1].length_m = 0.17;
  for (const double share : {0.5, 0.75}) {
    arm.segments[0].shape_of_strains(2, 5) = share;
    text = with_strain_polynomials(text, arm);
    EXPECT_EQ(arm_to_yaml(testing_support::space_arm(text)), arm_to_yaml(arm));
    EXPECT_THAT(text, StartsWith("# hangs from the ceiling\n"));
  }
}

// What `characterize --recording` changes, in braces and on lines of their own.
TEST(WithStrainPolynomials, KeepsTheCommentsBesideLengthsAndCurvatures) {
  const std::string text = R"(# measured with a ruler
schema: limber/arm/1
name: motors
command: {name: motor angle, unit: 1/m, limit: 3, rate_limit_per_s: 2}
no_load: straight   # nothing is known yet
frame_rate_hz: 10
actuator_radius_m: 0.004
segments:
  - {length_m: 0.15, width_m: 0.040, gaps: 2}   # base
  - length_m: 0.14      # to the clamp
    width_m: 0.030
    gaps: 2
)";
  ArmDescription arm = read(text);
  arm.no_load = NoLoadKind::curvature;
  arm.segments[0].length_m = 0.1525;
  arm.segments[1].length_m = 0.1375;
  arm.segments[0].curvature_per_unit = -1.25;
  arm.segments[1].curvature_per_unit = -2.5;
  const std::string edited = with_strain_polynomials(text, arm);
  EXPECT_EQ(arm_to_yaml(read(edited)), arm_to_yaml(arm));
  EXPECT_THAT(edited, HasSubstr("# measured with a ruler\n"));
  EXPECT_THAT(edited, HasSubstr("no_load: curvature   # nothing is known yet\n"));
  EXPECT_THAT(edited, HasSubstr("- {curvature_per_unit: -1.25, length_m: 0.1525, width_m: 0.040, "
                                "gaps: 2}   # base\n"));
  EXPECT_THAT(edited, HasSubstr("  - curvature_per_unit: -2.5\n"
                                "    length_m: 0.1375      # to the clamp\n"));
  EXPECT_EQ(with_strain_polynomials(edited, arm), edited);
}

TEST(WithStrainPolynomials, APlaceholderMakesWayForTheFit) {
  const std::string text = with("[1.0e-3, 1.0e-5, 0, 0]", "[TODO, 0, 0, 0]");
  ArmDescription arm =
      read_arm(YamlReader::from_text(text, "a.yaml"), PolynomialsOf::characterisation);
  arm.segments[0].strain_polynomial = {2e-3, 0.0, 0.0, 0.0};
  EXPECT_EQ(with_strain_polynomials(text, arm), with("[1.0e-3, 1.0e-5, 0, 0]", "[0.002, 0, 0, 0]"));
}

TEST(WithStrainPolynomials, WritesAnewWhatCannotBeEditedInPlace) {
  ArmDescription arm = read(kGood);
  arm.segments[0].strain_polynomial = {2e-3, 0.0, 0.0, 0.0};
  const std::string block =
      with("[1.0e-3, 1.0e-5, 0, 0]", "\n      - 1.0e-3\n      - 1.0e-5\n      - 0\n      - 0");
  EXPECT_EQ(with_strain_polynomials(block, arm), arm_to_yaml(arm));
}

}  // namespace
}  // namespace limber
