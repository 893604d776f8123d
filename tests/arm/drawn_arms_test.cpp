// Laws of the arm for arms of any size, drawn by a number.
#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "support/drawn_arm.hpp"
#include "support/property.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-12;         // [m], [rad]; double over an arm of 2 m
constexpr double kPressureRounding = 1e-9;  // of the limit; bisection on a slope far from 0

BackboneD shape_of(const ArmDescription& arm, const Pressures& kpa) {
  BackboneD shape(arm.point_count(), kPoseSize);
  NoLoadModel(arm).backbone(Eigen::VectorXd(kpa.cast<double>()), shape);
  return shape;
}

TEST(DrawnArms, FilesComeBackExactly) {
  expect_law("an arm that is written and read is the arm", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm =
        *rc::gen::arbitrary<bool>() ? drawn::arm(number, random) : drawn::space_arm(number, random);
    const std::string text = arm_to_yaml(arm);
    const ArmDescription again = read_arm(YamlReader::from_text(text, "again.yaml"));
    RC_ASSERT(again.hash() == arm.hash());
    RC_ASSERT(arm_to_yaml(again) == text);
    RC_ASSERT(read_arm_keys(arm_keys_to_yaml(arm), "keys").hash() == arm.hash());
  });
}

TEST(DrawnArms, OppositeCommandsGiveMirrorImages) {
  expect_law("of opposite commands, shapes are mirror images", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::arm(number, random);
    const Pressures kpa = drawn::pressures(arm, random);
    BackboneD mirrored = shape_of(arm, -kpa);
    mirrored.rightCols<2>() *= -1.0;
    RC_ASSERT(mirrored == shape_of(arm, kpa));
  });
}

/// By which a plate can move at most for a change of the commands: a segment that turns by more
/// moves what is behind it about its own base, and its own length changes by half its strain.
double largest_motion_m(const ArmDescription& arm, const Pressures& change) {
  double motion_m = 0.0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& s = arm.segments[std::size_t(i)];
    const double moved = std::abs(double(change[i]));
    const double limit = s.pressure_limit_kpa.largest_kpa();
    const double strain = moved * strain_slope_at(s.strain_polynomial, limit);  // steepest there
    const bool bends_by_command = arm.no_load == NoLoadKind::curvature;
    const double turn = bends_by_command ? moved * std::abs(s.curvature_per_unit) * s.length_m
                                         : strain * s.length_m / s.width_m;
    motion_m += turn * arm.length_m() + 0.5 * strain * s.length_m;
  }
  return motion_m;
}

// Also where segments pass through being straight, and for steps of any size.
TEST(DrawnArms, ShapesAreContinuousInTheCommands) {
  expect_law("no plate jumps", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::arm(number, random);
    const float size = std::pow(10.0F, -float(*rc::gen::inRange(0, 7)));
    const bool across_zero = *rc::gen::arbitrary<bool>();
    const Pressures step = size * drawn::pressures(arm, random);
    const Pressures from = across_zero ? Pressures(-0.5F * step)
                                       : Pressures((1.0F - size) * drawn::pressures(arm, random));
    const Pressures to = from + step;
    const double moved =
        (shape_of(arm, to) - shape_of(arm, from)).leftCols<2>().rowwise().norm().maxCoeff();
    RC_ASSERT(moved <= largest_motion_m(arm, to - from) + kRounding);
  });
}

TEST(DrawnArms, CommandsComeBackFromTheirCurvatures) {
  expect_law("the command for a command's curvature is the command", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::arm(number, random);
    const Pressures kpa = drawn::pressures(arm, random);
    const NoLoadModel model(arm);
    for (int i = 0; i < arm.segment_count(); ++i) {
      const double curvature = model.segment_shape(i, double(kpa[i])).curvature_per_m;
      const SegmentPressure found = model.pressure_for_curvature(i, curvature);
      RC_ASSERT(found.reachable);
      RC_ASSERT(std::abs(found.pressure_kpa - double(kpa[i])) <=
                kPressureRounding * arm.segments[std::size_t(i)].pressure_limit_kpa.largest_kpa());
    }
  });
}

}  // namespace
}  // namespace limber
