#include "limber/arm/space_no_load.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using testing_support::kSpaceArm;
using testing_support::space_arm;

std::string replaced(std::string text, const std::string& piece, const std::string& by) {
  text.replace(text.find(piece), piece.size(), by);
  return text;
}

TEST(SpaceArm, ItsKeysSurviveTheRoundTrip) {
  const ArmDescription arm = space_arm();
  EXPECT_EQ(arm.channel_count(), 6);
  EXPECT_EQ(arm.point_count(), 6);
  EXPECT_EQ(arm.limits_of_channel(4).upper_kpa, 100.0);
  EXPECT_EQ(arm.chamber(5).angle_deg, 300.0);
  EXPECT_EQ(arm.gravity, Eigen::Vector3d(1.0, 0.0, 0.0));
  const ArmDescription again = read_arm_keys(arm_keys_to_yaml(arm), "again");
  EXPECT_EQ(again.hash(), arm.hash());
  EXPECT_EQ(arm_keys_to_yaml(again), arm_keys_to_yaml(arm));
}

struct SpaceBreakage {
  const char* piece;
  const char* replacement;
  const char* message;
};

class BrokenSpaceArm : public ::testing::TestWithParam<SpaceBreakage> {};

TEST_P(BrokenSpaceArm, IsRefusedWithLineAndReason) {
  const std::string text = replaced(kSpaceArm, GetParam().piece, GetParam().replacement);
  EXPECT_THAT(
      [&] { space_arm(text); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("space.yaml:"), HasSubstr(GetParam().message))));
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenSpaceArm,
    ::testing::Values(
        SpaceBreakage{"dimension: 3", "dimension: 4", "2, in a plane, or 3, in space"},
        SpaceBreakage{"no_load: chambers", "no_load: curvature",
                      "chambers, fitted or straight for an arm in space"},
        SpaceBreakage{"no_load: chambers", "no_load: fitted", "shape_of_strains"},
        SpaceBreakage{"gravity: [1, 0, 0]", "gravity: [1, 0]", "2 numbers found; expected 3"},
        SpaceBreakage{"gravity: [1, 0, 0]", "gravity: [0, 0, 0]", "expected a direction"},
        SpaceBreakage{"sense: extending", "sense: pulling", "extending or contracting"},
        SpaceBreakage{"radius_m: 0.02,", "radius_m: 0,", "distance from the segment's axis"},
        SpaceBreakage{"gaps: 3, chambers", "gaps: 3, strain_polynomial: [1, 0, 0, 0], chambers",
                      "unknown key"}));

TEST(SpaceNoLoad, OneChamberBendsAwayFromItself) {
  const ArmDescription arm = space_arm();
  const SpaceNoLoad no_load(arm);
  Eigen::VectorXd commands = Eigen::VectorXd::Zero(6);
  commands[0] = 50.0;  // at +y, extending: bends toward −y
  const SpaceSegmentShape shape = no_load.segment_shape(0, no_load.strains(commands));
  EXPECT_LT(shape.rotation_rad.z(), -0.1);
  EXPECT_NEAR(shape.rotation_rad.y(), 0.0, 1e-12);
  EXPECT_GT(shape.length_m, 0.18);
}

// SPATIAL: three alike at 120 degrees have this closed form.
TEST(SpaceNoLoad, ThreeAlikeChambersHaveTheirClosedForm) {
  const ArmDescription arm = space_arm();
  const SpaceNoLoad no_load(arm);
  Eigen::VectorXd commands(6);
  commands << 10.0, 40.0, 70.0, 0.0, 0.0, 0.0;
  const Eigen::VectorXd f = no_load.strains(commands);
  double curvature_z = 0.0;
  double curvature_y = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * std::numbers::pi / 3.0 * k;
    curvature_z -= 2.0 / (3.0 * 0.02) * f[k] * std::cos(angle);
    curvature_y += 2.0 / (3.0 * 0.02) * f[k] * std::sin(angle);
  }
  const SpaceSegmentShape shape = no_load.segment_shape(0, f);
  EXPECT_NEAR(shape.rotation_rad.z(), 0.18 * curvature_z, 1e-12);
  EXPECT_NEAR(shape.rotation_rad.y(), 0.18 * curvature_y, 1e-12);
  EXPECT_NEAR(shape.length_m, 0.18 * (1.0 + f.head<3>().mean()), 1e-12);
}

ArmDescription two_chambers(double second_deg) {
  return space_arm(fmt::format(R"(schema: limber/arm/1
name: tendons
dimension: 3
no_load: chambers
frame_rate_hz: 20
pressure_rate_limit_kpa_per_s: 100
actuator_radius_m: 0.004
segments:
  - {{length_m: 0.2, width_m: 0.05, gaps: 2, chambers: [
      {{angle_deg: 0, radius_m: 0.02, sense: extending, pressure_limit_kpa: [-100, 100],
       strain_polynomial: [0.002, 0, 0, 0]}},
      {{angle_deg: {}, radius_m: 0.02, sense: extending, pressure_limit_kpa: [-100, 100],
       strain_polynomial: [0.002, 0, 0, 0]}}]}}
)",
                               second_deg));
}

// Two motors that pull a pair each: nothing tells an extension, so that each bends its own way.
TEST(SpaceNoLoad, PairsOfTendonsAtRightAnglesBendItAndKeepItsLength) {
  const ArmDescription arm = two_chambers(90.0);
  const SpaceNoLoad no_load(arm);
  const Eigen::VectorXd f = no_load.strains(Eigen::Vector2d(50.0, -20.0));
  const SpaceSegmentShape shape = no_load.segment_shape(0, f);
  EXPECT_NEAR(shape.rotation_rad.z(), -0.2 * f[0] / 0.02, 1e-12);
  EXPECT_NEAR(shape.rotation_rad.y(), 0.2 * f[1] / 0.02, 1e-12);
  EXPECT_NEAR(shape.length_m, 0.2, 1e-12);
}

// Measured angles are seldom opposite to the digit: half a degree is no second direction.
TEST(SpaceNoLoad, ChambersThatAreNearlyOppositeBendItOneWay) {
  const ArmDescription opposite_arm = two_chambers(180.0), nearly_arm = two_chambers(180.5);
  const SpaceNoLoad opposite(opposite_arm), nearly(nearly_arm);
  const Eigen::VectorXd f = opposite.strains(Eigen::Vector2d(50.0, 20.0));
  const SpaceSegmentShape shape = opposite.segment_shape(0, f);
  const SpaceSegmentShape other = nearly.segment_shape(0, f);
  EXPECT_NEAR(shape.length_m, 0.2 * (1.0 + f.mean()), 1e-12);
  EXPECT_NEAR(other.length_m, shape.length_m, 1e-3);
  EXPECT_LT((other.rotation_rad - shape.rotation_rad).norm(), 0.02);
}

constexpr const char* kPlanar = R"(schema: limber/arm/1
name: flat
frame_rate_hz: 20
pressure_rate_limit_kpa_per_s: 100
actuator_radius_m: 0.004
segments:
  - {length_m: 0.235, width_m: 0.05, gaps: 5, pressure_limit_kpa: 100,
     strain_polynomial: [0.0016, 3.8e-05, -5.2e-07, 1.8e-09]}
  - {length_m: 0.2, width_m: 0.03, gaps: 4, pressure_limit_kpa: 100,
     strain_polynomial: [0.0016, 3.7e-05, -5.1e-07, 1.7e-09]}
)";

std::string side(double angle_deg, double width_m, const char* polynomial) {
  return fmt::format(
      "{{angle_deg: {}, radius_m: {}, sense: contracting, pressure_limit_kpa: [0, 100], "
      "strain_polynomial: {}}}",
      angle_deg, 0.5 * width_m, polynomial);
}

/// The same arm: a contracting chamber on the left of every segment, and one on the right.
std::string planar_in_space() {
  const char* const first = "[0.0016, 3.8e-05, -5.2e-07, 1.8e-09]";
  const char* const second = "[0.0016, 3.7e-05, -5.1e-07, 1.7e-09]";
  return fmt::format(
      "schema: limber/arm/1\nname: flat\ndimension: 3\nframe_rate_hz: 20\n"
      "pressure_rate_limit_kpa_per_s: 100\nactuator_radius_m: 0.004\nsegments:\n"
      "  - {{length_m: 0.235, width_m: 0.05, gaps: 5, chambers: [{}, {}]}}\n"
      "  - {{length_m: 0.2, width_m: 0.03, gaps: 4, chambers: [{}, {}]}}\n",
      side(0, 0.05, first), side(180, 0.05, first), side(0, 0.03, second), side(180, 0.03, second));
}

TEST(SpaceNoLoad, APlanarArmInSpaceIsThePlanarArm) {
  const NoLoadModel planar(read_arm(YamlReader::from_text(kPlanar, "flat.yaml")));
  const NoLoadModel spatial(space_arm(planar_in_space()));
  for (const auto& [first, second] : {std::pair{0.0, 0.0}, {60.0, -30.0}, {-90.0, 100.0}}) {
    Eigen::VectorXf flat(3 * planar.point_count());
    planar.poses(Eigen::Vector2f(float(first), float(second)), flat);
    Eigen::VectorXf commands(4);  // left and right of each segment; positive presses the right
    commands << float(std::max(-first, 0.0)), float(std::max(first, 0.0)),
        float(std::max(-second, 0.0)), float(std::max(second, 0.0));
    Eigen::VectorXf poses(7 * spatial.point_count());
    spatial.poses(commands, poses);
    for (int plate = 0; plate < planar.point_count(); ++plate) {
      const Eigen::Vector3f expected = flat.segment<3>(3 * plate);
      const SpacePoseOf<float> pose = space_pose_of(poses.segment<7>(7 * plate));
      EXPECT_NEAR(pose.position_m.x(), expected[0], 1e-6);
      EXPECT_NEAR(pose.position_m.y(), expected[1], 1e-6);
      EXPECT_NEAR(pose.position_m.z(), 0.0, 1e-7);
      EXPECT_NEAR(2.0 * std::atan2(pose.rotation.z(), pose.rotation.w()), expected[2], 1e-6);
    }
  }
}

TEST(SpaceNoLoad, ChambersWithoutAUsablePolynomialAreOnlyForCharacterisation) {
  for (const char* polynomial : {"[]", "[0.002, 0, -1e-6, 0]"}) {
    const std::string yaml = replaced(kSpaceArm, "[0.002, 1e-5, 0, 0]", polynomial);
    EXPECT_THROW(space_arm(yaml), InputError);
    const ArmDescription arm =
        read_arm(YamlReader::from_text(yaml, "arm"), PolynomialsOf::characterisation);
    EXPECT_EQ(arm.chamber(0).strain_polynomial, StrainPolynomial{});
    EXPECT_THAT([&] { NoLoadModel model(arm); },
                ThrowsMessage<InputError>(HasSubstr("chamber 0 of segment 0")));
  }
}

TEST(SpaceNoLoad, ShapesComeBackFromPoses) {
  const ArmDescription arm = space_arm();
  Eigen::VectorXd shapes(kShapeRows * arm.segment_count());
  shapes << 0.7, -0.4, 0.05, -1.2, 2.0, -0.08;
  Eigen::VectorXf poses(kSpacePoseSize * arm.point_count());
  SpaceNoLoad(arm).poses_of_shapes(shapes, poses);
  EXPECT_LT((shapes_of_poses(arm, poses.cast<double>()) - shapes).norm(), 1e-5);
}

TEST(SpaceNoLoad, PlanarOnlyUsesAreRefusedByName) {
  EXPECT_THAT([] { require_planar(space_arm(), "limber plan"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("limber plan"), HasSubstr("'hanging'"), HasSubstr("train"))));
}

}  // namespace
}  // namespace limber
