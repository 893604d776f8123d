// Laws of the virtual arm in space, seen from outside: docs/virtual-arm.md, "In space".
#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "space_arms.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kGravity = 25.0;  // [m/s²], so that a short rod sags a lot

Eigen::Vector3d tip_m(const VirtualArm& arm) {
  return arm.true_plates().bottomRows<1>().leftCols<3>().transpose();
}

Pressures random_setpoints(const ArmDescription& arm, RandomStream& random) {
  Pressures result(arm.channel_count());
  for (int i = 0; i < arm.channel_count(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(i);
    result[i] = static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
  }
  return result;
}

TEST(SpacePhysics, FreeSegmentTakesTheShapeOfConstantStrain) {
  constexpr double kTolerance =
      0.006;  // of the length; an extended gap has its hinge off its middle
  const ArmDescription arm = ideal_segment(12);
  const NoLoadModel model(arm);
  VirtualArm virtual_arm(arm);
  for (const auto& [first, second, third] :
       {std::array{100.0F, 0.0F, 0.0F}, {60.0F, 80.0F, 10.0F}, {50.0F, 50.0F, 50.0F}}) {
    const Pressures setpoint = Eigen::Vector3f(first, second, third);
    virtual_arm.settle(setpoint, 6.0);
    Eigen::VectorXf expected(kSpacePoseSize * arm.point_count());
    model.poses(setpoint, expected);
    const SpaceBackboneD plates = virtual_arm.true_plates();
    for (Eigen::Index plate = 0; plate < plates.rows(); ++plate) {
      const Eigen::VectorXd pose =
          expected.segment<kSpacePoseSize>(kSpacePoseSize * plate).cast<double>();
      EXPECT_LT((plates.row(plate).transpose().head<3>() - pose.head<3>()).norm(),
                kTolerance * arm.length_m())
          << "plate " << plate;
      EXPECT_GT(std::abs(plates.row(plate).tail<4>().dot(pose.tail<4>())), 0.9999);
    }
  }
}

/// Of a rod of bending stiffness `ei` that carries point loads at these places: its shape by
/// EI θ'' = −W(s) cos θ, from θ(0) = 0 to θ'(L) = 0. The slow reference: shooting, small steps.
Eigen::Vector2d cantilever_tip_m(double length_m, double ei, double weight_n, int loads) {
  constexpr int kSteps = 20'000;
  const double step = length_m / kSteps;
  const auto shoot = [&](double curvature, Eigen::Vector2d& tip) {
    double angle = 0.0;
    tip.setZero();
    for (int i = 0; i < kSteps; ++i) {
      const double s = (i + 0.5) * step;
      const double beyond = loads - std::floor(s / length_m * loads);
      curvature -= step * weight_n * beyond * std::cos(angle) / ei;
      angle += step * curvature;
      tip += step * Eigen::Vector2d(std::cos(angle), -std::sin(angle));
    }
    return curvature;
  };
  double low = 0.0;
  double high = 50.0;
  Eigen::Vector2d tip;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(middle, tip) > 0.0 ? high : low) = middle;
  }
  return tip;
}

TEST(SpacePhysics, SagsUnderItsOwnWeightAsACosseratRod) {
  constexpr double kTolerance = 0.01;  // of the length
  constexpr int kGaps = 15;
  for (const Eigen::Vector3d& down : {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0.6, -0.8)}) {
    ArmDescription arm = ideal_segment(kGaps);
    arm.gravity = down;
    change_virtual_arm(arm, [](VirtualArmParameters& p) { p.gravity_m_per_s2 = kGravity; });
    const VirtualArmParameters physics = virtual_arm_parameters(arm);
    const double ei = physics.side_elasticity_n * 1.5 * 0.02 * 0.02;  // sum of K y²
    const Eigen::Vector2d expected =
        cantilever_tip_m(0.3, ei, physics.plate_mass_kg * kGravity, kGaps);
    ASSERT_LT(expected.y(), -0.1) << "it sags a lot";
    VirtualArm virtual_arm(arm);
    virtual_arm.settle(Pressures::Zero(3), 20.0);
    const Eigen::Vector3d tip = tip_m(virtual_arm);
    EXPECT_NEAR(tip.x(), expected.x(), kTolerance * 0.3);
    EXPECT_NEAR(tip.dot(down), -expected.y(), kTolerance * 0.3);
    EXPECT_NEAR((tip - tip.dot(down) * down).tail<2>().norm(), 0.0, kTolerance * 0.3);
  }
}

// A side in the plane is a chamber at 0 or 180 degrees, strengths included.
TEST(SpacePhysics, PlanarArmInSpaceMovesAsThePlanarArm) {
  constexpr double kTolerance_m = 1e-4;  // what is left of the motion; there is no history
  ArmDescription planar =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms" / "three_segment.yaml");
  change_virtual_arm(planar, [](VirtualArmParameters& p) {
    p.friction_coefficient = 0.0;
    p.hysteresis_fraction = 0.0;
    p.hysteresis_floor_n = 0.0;
    p.pressure_dead_band_kpa = 0.0;
  });
  ArmDescription spatial = planar;
  spatial.dimension = Dimension::space;
  spatial.no_load = NoLoadKind::chambers;
  for (Segment& segment : spatial.segments) {
    for (const double angle_deg : {0.0, 180.0}) {
      segment.chambers.push_back({angle_deg, 0.5 * segment.width_m, -1, PressureLimits(0.0, 100.0),
                                  segment.strain_polynomial});
    }
  }
  set_virtual_arm_parameters(spatial, virtual_arm_parameters(planar));
  VirtualArm in_plane(planar);
  VirtualArm in_space(spatial);
  for (const auto& [a, b, c] : {std::array{80.0F, -60.0F, 30.0F}, {-20.0F, 0.0F, 90.0F}}) {
    in_plane.settle(Eigen::Vector3f(a, b, c), 15.0);
    Pressures sides(6);  // left, right of each segment; positive is right
    sides << std::max(-a, 0.0F), std::max(a, 0.0F), std::max(-b, 0.0F), std::max(b, 0.0F),
        std::max(-c, 0.0F), std::max(c, 0.0F);
    in_space.settle(sides, 15.0);
    const BackboneD expected = in_plane.true_backbone();
    const SpaceBackboneD plates = in_space.true_plates();
    EXPECT_LT((plates.leftCols<2>() - expected.leftCols<2>()).rowwise().norm().maxCoeff(),
              kTolerance_m);
    EXPECT_LT(plates.col(2).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(SpacePhysics, MirroredCommandsGiveMirroredShapes) {
  constexpr double kTolerance = 1e-7;  // rounding of the chambers' places, over two seconds
  ArmDescription arm = own_space_arm("hanging_3x2");
  change_virtual_arm(arm, [](VirtualArmParameters& p) { p.strength_spread = 0.0; });
  Pressures setpoint(6);
  setpoint << 20.0F, 90.0F, 10.0F, 70.0F, 0.0F, 30.0F;
  Pressures mirrored(6);  // z to -z: chambers at 120 and 240 degrees change places, 60 and 300 too
  mirrored << 20.0F, 10.0F, 90.0F, 30.0F, 0.0F, 70.0F;
  VirtualArm one(arm);
  VirtualArm other(arm);
  one.settle(setpoint, 2.0);
  other.settle(mirrored, 2.0);
  SpaceBackboneD expected = one.true_plates();
  for (const Eigen::Index column : {2, 3, 4}) {
    expected.col(column) *= -1.0;
  }
  EXPECT_GT(tip_m(one).tail<2>().cwiseAbs().minCoeff(), 0.01);
  EXPECT_LT((other.true_plates() - expected).cwiseAbs().maxCoeff(), kTolerance);
}

TEST(SpacePhysics, TwoBendsAtOnceDoNotTwist) {
  constexpr double kLargestTwist_rad = 0.02;
  const ArmDescription arm = ideal_segment(6);
  VirtualArm virtual_arm(arm);
  virtual_arm.settle(Eigen::Vector3f(100.0F, 40.0F, 0.0F), 6.0);
  const Eigen::VectorXd tip = virtual_arm.true_plates().bottomRows<1>().transpose();
  EXPECT_GT(std::hypot(tip[4], tip[5]), 0.3);
  EXPECT_NEAR(2.0 * std::atan2(tip[3], tip[6]), 0.0, kLargestTwist_rad);
}

class OwnSpaceArm : public testing::TestWithParam<const char*> {};

TEST_P(OwnSpaceArm, LosesEnergyUntilItRestsWhereNothingIsCommanded) {
  constexpr double kRounding_j = 1e-5;
  constexpr double kStill_m = 1e-6;
  const ArmDescription arm = own_space_arm(GetParam());
  VirtualArm virtual_arm(arm);
  const Pressures none = Pressures::Zero(arm.channel_count());
  double energy = virtual_arm.energy_j();
  for (int frame = 0; frame < 200; ++frame) {
    virtual_arm.command(none);
    EXPECT_LE(virtual_arm.energy_j(), energy + kRounding_j) << "frame " << frame;
    energy = virtual_arm.energy_j();
  }
  const SpaceBackboneD rest = virtual_arm.true_plates();
  virtual_arm.settle(none, 2.0);
  EXPECT_LT((virtual_arm.true_plates() - rest).cwiseAbs().maxCoeff(),
            virtual_arm_parameters(arm).creep_fraction > 0.0 ? 1e-4 : kStill_m);
  EXPECT_NEAR(tip_m(virtual_arm).x(), arm.length_m(), 0.03 * arm.length_m());
}

TEST_P(OwnSpaceArm, HasTheStrainsOfItsBenchTest) {
  constexpr double kMisfit = 0.02;  // of full strain: quartics don't follow braids below that
  const ArmDescription arm = own_space_arm(GetParam());
  const StrainPolynomial& polynomial = arm.chamber(0).strain_polynomial;
  const double full = strain_at(polynomial, arm.limits_of_channel(0).upper_kpa);
  for (const BenchPoint& point : bench_test_of_chamber(arm, 0, 4)) {
    EXPECT_NEAR(strain_at(polynomial, point.pressure_kpa), -point.strain, kMisfit * full);
  }
}

// 2 to 3 % is what real arms show; with few targets, the median is less certain.
TEST_P(OwnSpaceArm, RemembersWhereItCameFrom) {
  constexpr int kTargets = 10;
  const ArmDescription arm = own_space_arm(GetParam());
  VirtualArm virtual_arm(arm);
  RandomStream random(5, 0);
  std::vector<double> shares;
  for (int target = 0; target < kTargets; ++target) {
    const Pressures setpoint = random_setpoints(arm, random);
    std::vector<Eigen::Vector3d> ends;
    for (int history = 0; history < 3; ++history) {
      virtual_arm.settle(random_setpoints(arm, random), 3.0);
      virtual_arm.settle(setpoint, 3.0);
      for (const Eigen::Vector3d& other : ends) {
        shares.push_back((tip_m(virtual_arm) - other).norm() / arm.length_m());
      }
      ends.push_back(tip_m(virtual_arm));
    }
  }
  std::sort(shares.begin(), shares.end());
  const double median = shares[shares.size() / 2];
  EXPECT_GT(median, 0.016);
  EXPECT_LT(median, 0.036);
}

TEST_P(OwnSpaceArm, HalfTheStepMovesTheTipLittle) {
  constexpr double kMean = 0.002;  // of the length
  const ArmDescription arm = own_space_arm(GetParam());
  ArmDescription fine = arm;
  change_virtual_arm(fine, [](VirtualArmParameters& p) { p.time_step_s *= 0.5; });
  VirtualArm coarse(arm);
  VirtualArm halved(fine);
  RandomStream random(6, 0);
  double sum_m = 0.0;
  int frames = 0;
  for (int motion = 0; motion < 10; ++motion) {
    const Pressures setpoint = random_setpoints(arm, random);
    for (int frame = 0; frame < 20; ++frame, ++frames) {
      coarse.command(setpoint);
      halved.command(setpoint);
      sum_m += (tip_m(coarse) - tip_m(halved)).norm();
    }
  }
  EXPECT_LT(sum_m / frames, kMean * arm.length_m());
}

TEST_P(OwnSpaceArm, RestoredStateRepeatsTheMotionToTheBit) {
  const ArmDescription arm = own_space_arm(GetParam());
  VirtualArm one(arm);
  RandomStream random(7, 0);
  one.settle(random_setpoints(arm, random), 0.5);
  const VirtualArmState state = one.save();
  const Pressures setpoint = random_setpoints(arm, random);
  one.settle(setpoint, 0.5);
  VirtualArm other(arm);
  other.restore(state);
  other.settle(setpoint, 0.5);
  EXPECT_EQ(one.true_plates(), other.true_plates());
}

INSTANTIATE_TEST_SUITE_P(Shipped, OwnSpaceArm,
                         testing::Values("hanging_3x2", "hanging_3x3", "upright_4x2"));

TEST(SpacePhysics, ContractingChambersTakeNoVacuum) {
  ArmDescription arm = ideal_segment(3);
  arm.segments[0].chambers[1].sense = -1;
  arm.segments[0].chambers[1].limit_kpa = PressureLimits(-50.0, 100.0);
  EXPECT_THAT([&] { VirtualArm refused(arm); },
              ThrowsMessage<InputError>(HasSubstr("chamber 1 of segment 0 contracts, and takes "
                                                  "pressures from -50 kPa; expected from 0")));
}

TEST(SpacePhysics, NamesTheChamberOfASetPointBeyondItsLimit) {
  VirtualArm arm(ideal_segment(3));
  EXPECT_THAT([&] { arm.command(Eigen::Vector3f(0.0F, 0.0F, -5.0F)); },
              ThrowsMessage<InputError>(HasSubstr("set point of chamber 2 of segment 0 is -5 kPa; "
                                                  "expected 0 to 100 kPa")));
}

TEST(SpacePhysics, PlanarQuestionsAreRefused) {
  const VirtualArm arm(ideal_segment(3));
  EXPECT_THAT([&] { (void)arm.true_backbone(); },
              ThrowsMessage<InputError>(HasSubstr("true_backbone can't use an arm in space")));
}

}  // namespace
}  // namespace limber
