// Laws of the simulated arm, seen from outside: docs/virtual-arm.md.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

ArmDescription own_arm(const char* name) {
  return load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms" / name);
}

/// Identical actuators, no friction, no hysteresis; more damping changes how fast it settles, not
/// where.
ArmDescription ideal(ArmDescription arm) {
  change_virtual_arm(arm, [&](VirtualArmParameters& p) {
    p.strength_spread = 0.0;
    p.friction_coefficient = 0.0;
    p.hysteresis_fraction = 0.0;
    p.hysteresis_floor_n = 0.0;
    p.hinge_damping_n_m_s_per_rad *= 6.0;
    p.pressure_dead_band_kpa = 0.0;
  });
  return arm;
}

Pressures uniform(const ArmDescription& arm, double fraction) {
  Pressures result(arm.segment_count());
  for (int s = 0; s < arm.segment_count(); ++s) {
    result[s] = static_cast<float>(
        fraction * arm.segments[static_cast<std::size_t>(s)].pressure_limit_kpa.largest_kpa());
  }
  return result;
}

double tip_distance(const BackboneD& a, const BackboneD& b) {
  return (a.bottomRows(1).leftCols(2) - b.bottomRows(1).leftCols(2)).norm();
}

class ArmPhysicsOf : public testing::TestWithParam<const char*> {};

// Below a seventh of the limit the quartic's own misfit, 0.7 % of full strain, exceeds 5 %.
TEST_P(ArmPhysicsOf, SettlesInTheShapeOfTheNoLoadModel) {
  constexpr double kTolerance = 0.05;
  const ArmDescription arm = ideal(own_arm(GetParam()));
  const NoLoadModel model(arm);
  for (const double fraction : {-1.0, -0.6, -0.3, 0.15, 0.2, 0.45, 0.8, 1.0}) {
    VirtualArm virtual_arm(arm);
    virtual_arm.settle(uniform(arm, fraction), 12.0);
    const BackboneD backbone = virtual_arm.true_backbone();
    const Eigen::VectorXd pressure = virtual_arm.true_pressure_kpa();
    int first = 0;
    for (int s = 0; s < arm.segment_count(); ++s) {
      const Segment& segment = arm.segments[static_cast<std::size_t>(s)];
      const double angle = backbone(first + segment.gaps, 2) - backbone(first, 2);
      const double length =
          segment.length_m *
          (1.0 + 0.5 * (virtual_arm.left_strain(s) + virtual_arm.right_strain(s)));
      const SegmentShape expected = model.segment_shape(s, pressure[s]);
      EXPECT_NEAR(angle / length / expected.curvature_per_m, 1.0, kTolerance)
          << "segment " << s << " at " << pressure[s] << " kPa";
      EXPECT_NEAR(length / expected.length_m, 1.0, kTolerance);
      first += segment.gaps;
    }
  }
}

/// Everything that tables and builds have beside Coulomb friction, far from nothing.
void make_worse(VirtualArmParameters& p) {
  p.friction_static_excess = 0.6;
  p.friction_stribeck_m_per_s = 0.02;
  p.friction_viscous_s_per_m = 0.2;
  p.table_tilt_rad = 0.17;
  p.table_downhill_rad = 2.0;
  p.tip_load_kg = 0.08;
  p.gap_length_spread = 0.03;
  p.actuator_strain_scale = 1.2;
  p.actuator_bow = 0.4;
  p.creep_fraction = 0.15;
}

// Once the valves are shut and vented, nothing but friction and damping acts.
TEST_P(ArmPhysicsOf, LosesEnergyWhileNothingIsInflated) {
  constexpr double kRipple = 3e-3;  // of semi-implicit Euler, at the shock of losing all air
  const ArmDescription arm = own_arm(GetParam());
  const double own = virtual_arm_parameters(arm).friction_coefficient;
  for (const auto& choice : {std::pair(0.0, false), {own, false}, {0.0, true}, {own, true}}) {
    const double friction = choice.first;
    const bool worse = choice.second;
    ArmDescription on_table = arm;
    change_virtual_arm(on_table, [&](VirtualArmParameters& p) {
      if (worse) {
        make_worse(p);
      }
      p.friction_coefficient = friction;
      p.time_step_s = 1e-4;  // the integrator's own ripple goes with it
    });
    VirtualArm virtual_arm(on_table);
    virtual_arm.settle(uniform(arm, 0.9), 0.7);
    VirtualArmState state = virtual_arm.save();  // bent, and from here on without air
    state.pressure_kpa.assign(state.pressure_kpa.size(), 0.0);
    state.flow_kpa_per_s.assign(state.flow_kpa_per_s.size(), 0.0);
    virtual_arm.restore(state);
    const double start = virtual_arm.energy_j();
    ASSERT_GT(start, 0.1);
    double lowest = start;
    double rise = 0.0;
    virtual_arm.set_observer([&](double, const BackboneD&) {
      const double now = virtual_arm.energy_j();
      rise = std::max(rise, now - lowest);
      lowest = std::min(lowest, now);
    });
    virtual_arm.settle(uniform(arm, 0.0), 0.5);
    EXPECT_LT(rise, kRipple * start) << "friction " << friction << ", worse " << worse;
    EXPECT_LT(virtual_arm.energy_j(), 0.9 * start);
  }
}

TEST_P(ArmPhysicsOf, RingsDownBelowACentimetreWithinThreeSecondsOfVenting) {
  const ArmDescription arm = own_arm(GetParam());
  VirtualArm virtual_arm(arm);
  virtual_arm.settle(uniform(arm, 1.0), 4.0);
  virtual_arm.settle(uniform(arm, 0.0), 3.0);
  const BackboneD after_three_seconds = virtual_arm.true_backbone();
  double farthest = 0.0;
  virtual_arm.set_observer([&](double, const BackboneD& backbone) {
    farthest = std::max(farthest, tip_distance(backbone, after_three_seconds));
  });
  virtual_arm.settle(uniform(arm, 0.0), 5.0);
  EXPECT_LT(farthest, 0.01);
}

TEST_P(ArmPhysicsOf, StandsStillAtConstantPressure) {
  const ArmDescription arm = own_arm(GetParam());
  VirtualArm virtual_arm(arm);
  virtual_arm.settle(uniform(arm, 0.8), 3.0);
  virtual_arm.settle(uniform(arm, -0.5), 6.0);
  const BackboneD settled = virtual_arm.true_backbone();
  double farthest = 0.0;
  virtual_arm.set_observer([&](double, const BackboneD& backbone) {
    farthest = std::max(farthest, (backbone - settled).leftCols(2).rowwise().norm().maxCoeff());
  });
  virtual_arm.settle(uniform(arm, -0.5), 10.0);
  EXPECT_LT(farthest, 1e-5);
}

// The paper's Fig. 1: inflated and vented, the arm does not come back, and that is friction's
// doing.
TEST_P(ArmPhysicsOf, DoesNotReturnToStraight) {
  const ArmDescription arm = own_arm(GetParam());
  VirtualArm virtual_arm(arm);
  const BackboneD straight = virtual_arm.true_backbone();
  virtual_arm.settle(uniform(arm, 1.0), 4.0);
  virtual_arm.settle(uniform(arm, 0.0), 5.0);
  EXPECT_GT(tip_distance(virtual_arm.true_backbone(), straight), 0.03);
  VirtualArm frictionless(ideal(arm));
  frictionless.settle(uniform(arm, 1.0), 4.0);
  frictionless.settle(uniform(arm, 0.0), 20.0);
  EXPECT_LT(tip_distance(frictionless.true_backbone(), straight), 0.002);
}

TEST_P(ArmPhysicsOf, SurvivesRandomCommands) {
  const ArmDescription arm = own_arm(GetParam());
  VirtualArm virtual_arm(arm);
  RandomStream random(11, 0);
  for (int motion = 0; motion < 60; ++motion) {
    Pressures setpoint(arm.segment_count());
    for (int s = 0; s < arm.segment_count(); ++s) {
      const double limit =
          arm.segments[static_cast<std::size_t>(s)].pressure_limit_kpa.largest_kpa();
      setpoint[s] = static_cast<float>(random.uniform(-limit, limit));
    }
    ASSERT_NO_THROW(virtual_arm.settle(setpoint, random.uniform(0.05, 1.0)));
    const BackboneD backbone = virtual_arm.true_backbone();
    ASSERT_LT(backbone.leftCols(2).rowwise().norm().maxCoeff(), 1.2 * arm.length_m());
  }
}

INSTANTIATE_TEST_SUITE_P(Arms, ArmPhysicsOf,
                         testing::Values("two_segment.yaml", "three_segment.yaml",
                                         "five_segment.yaml"),
                         [](const auto& name) {
                           const std::string file = name.param;
                           return file.substr(0, file.find('_')) + "Segments";
                         });

// What families learn from twice (add_mirrored_arms): the sides change places, and the table tilts
// the other way.
TEST(ArmPhysics, MirroredArmsMoveAsMirrorImages) {
  const auto tilted = [](int weak_side, double downhill_rad) {
    ArmDescription arm = sample_arm(3);
    change_virtual_arm(arm, [&](VirtualArmParameters& p) {
      p.strength_spread = 0.0;
      p.weak_side_loss = 0.2;
      p.weak_side = weak_side;
      p.table_tilt_rad = 0.1;
      p.table_downhill_rad = downhill_rad;
      p.tip_load_kg = 0.05;
    });
    return arm;
  };
  const ArmDescription arm = tilted(2, 0.8);
  VirtualArm right(arm);
  VirtualArm left(tilted(3, -0.8));
  for (const double share : {0.7, -0.3, 0.5}) {
    right.settle(uniform(arm, share), 1.0);
    left.settle(uniform(arm, -share), 1.0);
    BackboneD mirrored = left.true_backbone();
    mirrored.rightCols(2) *= -1.0;
    EXPECT_LT((mirrored - right.true_backbone()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ArmPhysics, NoTwoActuatorsAreAlike) {
  const ArmDescription arm = sample_arm(3);
  ArmDescription other = arm;
  change_virtual_arm(other, [&](VirtualArmParameters& p) { p.strength_seed = 2; });
  VirtualArm first(arm);
  VirtualArm second(other);
  first.settle(uniform(arm, 0.7), 3.0);
  second.settle(uniform(arm, 0.7), 3.0);
  EXPECT_GT(tip_distance(first.true_backbone(), second.true_backbone()), 1e-3);
}

TEST(ArmPhysics, CreepsAndIsBuiltAskewWhereAsked) {
  ArmDescription arm = ideal(sample_arm(2));
  change_virtual_arm(arm, [&](VirtualArmParameters& p) {
    p.creep_fraction = 0.5;
    p.creep_time_s = 5.0;
    p.base_misalignment_rad = 0.1;
    p.plate_offset_rad = 0.02;
  });
  VirtualArm creeping(arm);
  EXPECT_NEAR(creeping.true_backbone()(0, 2), 0.1, 1e-12);
  EXPECT_NE(creeping.true_backbone()(1, 2), 0.1);
  creeping.settle(uniform(arm, 0.8), 4.0);
  const double early = creeping.right_strain(1);
  creeping.settle(uniform(arm, 0.8), 20.0);
  EXPECT_LT(creeping.right_strain(1), early - 1e-3);
}

/// Straight and vented for `seconds`; where the tip is then.
Eigen::Vector2d tip_after_rest(const ArmDescription& arm, double seconds) {
  VirtualArm virtual_arm(arm);
  virtual_arm.settle(uniform(arm, 0.0), seconds);
  return virtual_arm.true_backbone().bottomRows(1).leftCols(2).transpose();
}

TEST(ArmPhysics, SinksDownhillOnATiltedTableWithoutFriction) {
  ArmDescription arm = ideal(sample_arm(3));
  for (const double downhill :
       {0.5 * std::numbers::pi, -0.5 * std::numbers::pi, 0.0, std::numbers::pi}) {
    change_virtual_arm(arm, [&](VirtualArmParameters& p) {
      p.table_tilt_rad = 0.1;
      p.table_downhill_rad = downhill;
    });
    const Eigen::Vector2d sunk = tip_after_rest(arm, 5.0) - Eigen::Vector2d(arm.length_m(), 0.0);
    const Eigen::Vector2d direction(std::cos(downhill), std::sin(downhill));
    EXPECT_GT(sunk.dot(direction), 1e-4) << downhill;
  }
}

// tan(0.15) = 0.151 is more than sliding friction holds, and less than what breaks it away.
TEST(ArmPhysics, StaysOnATiltedTableByItsStaticFrictionAlone) {
  constexpr double kPreSlidingM = 2e-3;  // of the friction's springs, over a few plates
  ArmDescription arm = sample_arm(3);
  change_virtual_arm(arm, [&](VirtualArmParameters& p) {
    p.friction_coefficient = 0.1;
    p.friction_static_excess = 1.5;
    p.table_tilt_rad = 0.15;
    p.table_downhill_rad = 0.5 * std::numbers::pi;
  });
  EXPECT_LT(tip_after_rest(arm, 3.0).y(), kPreSlidingM);
  change_virtual_arm(arm, [&](VirtualArmParameters& p) { p.friction_static_excess = 0.0; });
  EXPECT_GT(tip_after_rest(arm, 3.0).y(), 10.0 * kPreSlidingM);
}

// What an undamped, vented arm loses in height it gains in speed and in its springs.
TEST(ArmPhysics, KeepsItsEnergyOnATiltedTableWithoutLosses) {
  constexpr double kRipple = 0.01;  // of the height that the arm trades
  ArmDescription arm = ideal(sample_arm(3));
  change_virtual_arm(arm, [&](VirtualArmParameters& p) {
    p.slide_damping_n_s_per_m = 0.0;
    p.hinge_damping_n_m_s_per_rad = 0.0;
    p.table_tilt_rad = 0.17;
    p.table_downhill_rad = 0.5 * std::numbers::pi;
    p.tip_load_kg = 0.05;
    p.time_step_s = 2e-5;
  });
  VirtualArm virtual_arm(arm);
  const double start_j = virtual_arm.energy_j();
  double drift_j = 0.0;
  double fallen_m = 0.0;
  virtual_arm.set_observer([&](double, const BackboneD& backbone) {
    drift_j = std::max(drift_j, std::abs(virtual_arm.energy_j() - start_j));
    fallen_m = std::max(fallen_m, backbone(backbone.rows() - 1, 1));
  });
  virtual_arm.settle(uniform(arm, 0.0), 0.3);
  ASSERT_GT(fallen_m, 0.01);
  EXPECT_LT(drift_j, kRipple * 0.05 * 9.81 * std::sin(0.17) * fallen_m);
}

TEST(ArmPhysics, LosesMoreEnergyWithViscousFriction) {
  std::vector<double> left_j;
  for (const double viscous : {0.0, 0.2}) {
    ArmDescription arm = sample_arm(3);
    change_virtual_arm(arm, [&](VirtualArmParameters& p) {
      p.friction_coefficient = 0.0;
      p.friction_viscous_s_per_m = viscous;
    });
    VirtualArm virtual_arm(arm);
    virtual_arm.settle(uniform(arm, 0.9), 3.0);
    virtual_arm.settle(uniform(arm, 0.0), 2.0);
    left_j.push_back(virtual_arm.energy_j());
  }
  EXPECT_LT(left_j[1], 0.8 * left_j[0]);
}

struct StrainCurve {
  double full = 0.0;          ///< strain at the pressure limit
  double middle_share = 0.0;  ///< of it at half of the limit
};

StrainCurve strain_curve(double scale, double bow) {
  ArmDescription arm = sample_arm(1);
  change_virtual_arm(arm, [&](VirtualArmParameters& p) {
    p.actuator_strain_scale = scale;
    p.actuator_bow = bow;
  });
  const std::vector<BenchPoint> points = bench_test(arm, 0, 4);
  return {-points[4].strain, points[2].strain / points[4].strain};
}

TEST(BenchTest, AmountAndShapeOfTheStrainCurveVaryByAFifth) {
  constexpr double kShare = 0.025;  // of what is asked
  const StrainCurve usual = strain_curve(1.0, 0.0);
  EXPECT_NEAR(strain_curve(0.75, 0.0).full / usual.full, 0.8, kShare);
  EXPECT_NEAR(strain_curve(1.3, 0.0).full / usual.full, 1.2, kShare);
  for (const double bow : {-0.4, 0.4}) {
    const StrainCurve bowed = strain_curve(1.0, bow);
    EXPECT_NEAR(bowed.full, usual.full, 1e-6) << "the limit's strain stays";
    EXPECT_NEAR(bowed.middle_share / usual.middle_share, 1.0 + 0.5 * bow, kShare);
  }
}

TEST(BenchTest, ContractsMoreWithPressureFromNothing) {
  const std::vector<BenchPoint> points = bench_test(sample_arm(2), 1, 5);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points[0].strain, 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].pressure_kpa, 20.0 * static_cast<double>(i), 1e-2);
    EXPECT_LT(points[i].strain, points[i - 1].strain);
  }
  EXPECT_NEAR(points.back().strain, -0.205, 0.01);
}

}  // namespace
}  // namespace limber
