#include "limber/world/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kExact = 1e-8;  // [m], [rad]; Newton's 1e-10 m through the pressure inverse

/// The tip by the forward model, independent of the solver's own chain.
Pose tip_of(const NoLoadModel& model, const Eigen::VectorXd& pressures_kpa) {
  BackboneD backbone(model.point_count(), 3);
  model.backbone(pressures_kpa, backbone);
  return tip_pose(backbone);
}

Eigen::VectorXd random_pressures(const NoLoadModel& model, RandomStream& random) {
  Eigen::VectorXd pressures(model.segment_count());
  for (int i = 0; i < model.segment_count(); ++i) {
    pressures[i] = model.segment(i).pressure_limit_kpa.largest_kpa() * random.uniform(-1.0, 1.0);
  }
  return pressures;
}

class InverseKinematicsOfArm : public ::testing::TestWithParam<int> {};

// Every goal is the tip of some configuration, so a solution exists; each one found must reach it.
TEST_P(InverseKinematicsOfArm, FindsReachablePosesAndTheForwardModelAgrees) {
  const NoLoadModel model(arm_of(GetParam()));
  RandomStream random(21, 0);
  for (int trial = 0; trial < 40; ++trial) {
    const Pose tip = tip_of(model, random_pressures(model, random));
    const PoseGoal goal{tip.x_m, tip.y_m, tip.theta_rad, 1e-6, 1e-6};
    InverseKinematicsSettings settings;
    settings.starts = 200;
    settings.max_solutions = 3;
    const auto result = solve_inverse_kinematics(model, goal, settings, random);
    ASSERT_TRUE(result.reachable()) << "goal " << trial << ": " << result.reason;
    EXPECT_TRUE(result.reason.empty());
    for (const Eigen::VectorXd& pressures : result.pressures_kpa) {
      const PoseError error = pose_error(goal, tip_of(model, pressures));
      EXPECT_LT(error.position_m, kExact);
      EXPECT_LT(error.orientation_rad, kExact);
    }
  }
}

TEST_P(InverseKinematicsOfArm, FindsReachablePositionsWithinTheLimits) {
  const NoLoadModel model(arm_of(GetParam()));
  RandomStream random(22, 0);
  for (int trial = 0; trial < 40; ++trial) {
    const Pose tip = tip_of(model, random_pressures(model, random));
    const PoseGoal goal{tip.x_m, tip.y_m, std::nullopt, 1e-6, 0.05};
    const auto result = solve_inverse_kinematics(model, goal, {}, random);
    ASSERT_TRUE(result.reachable()) << result.reason;
    for (const Eigen::VectorXd& pressures : result.pressures_kpa) {
      EXPECT_LT(pose_error(goal, tip_of(model, pressures)).position_m, kExact);
      for (int i = 0; i < model.segment_count(); ++i) {
        EXPECT_LE(std::abs(pressures[i]), model.segment(i).pressure_limit_kpa.largest_kpa());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Segments, InverseKinematicsOfArm, ::testing::Values(1, 2, 3, 5));

// Goals that configurations within the limits reach are found within them, whichever side is the
// narrower one.
TEST_P(InverseKinematicsOfArm, StaysWithinTheLimitsOfEachSide) {
  const int n = GetParam();
  ArmDescription arm = arm_of(n);
  const std::vector<PressureLimits> narrow(std::size_t(n), PressureLimits(-20.0, 60.0));
  const NoLoadModel wide(arm);
  for (Segment& segment : arm.segments) {
    segment.pressure_limit_kpa = PressureLimits(-20.0, segment.pressure_limit_kpa.upper_kpa);
  }
  const NoLoadModel uneven(arm);
  RandomStream random(23, 0);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::VectorXd pressures(n);
    for (int i = 0; i < n; ++i) {
      pressures[i] = random.uniform(-20.0, 60.0);
    }
    const Pose tip = tip_of(wide, pressures);
    const PoseGoal goal{tip.x_m, tip.y_m, std::nullopt, 1e-6, 0.05};
    InverseKinematicsSettings settings;
    settings.starts = 200;
    settings.limits = narrow;
    const auto asked = solve_inverse_kinematics(wide, goal, settings, random);
    settings.limits.clear();
    const auto own = solve_inverse_kinematics(uneven, goal, settings, random);
    ASSERT_TRUE(asked.reachable()) << asked.reason;
    ASSERT_TRUE(own.reachable()) << own.reason;
    for (const Eigen::VectorXd& found : asked.pressures_kpa) {
      EXPECT_LT(pose_error(goal, tip_of(wide, found)).position_m, kExact);
      EXPECT_GE(found.minCoeff(), -20.0);
      EXPECT_LE(found.maxCoeff(), 60.0);
    }
    for (const Eigen::VectorXd& found : own.pressures_kpa) {
      EXPECT_GE(found.minCoeff(), -20.0);
    }
  }
}

TEST(InverseKinematics, SolutionsAreDistinct) {
  const NoLoadModel model(arm_of(3));
  RandomStream random(23, 0);
  InverseKinematicsSettings settings;
  settings.distinct_pressure = 0.05;  // of 100 kPa
  const auto result =
      solve_inverse_kinematics(model, {0.5, 0.2, std::nullopt, 0.001, 0.05}, settings, random);
  ASSERT_EQ(result.pressures_kpa.size(), 8u);  // three pressures for two coordinates: a curve
  for (std::size_t a = 0; a < result.pressures_kpa.size(); ++a) {
    for (std::size_t b = a + 1; b < result.pressures_kpa.size(); ++b) {
      EXPECT_GT((result.pressures_kpa[a] - result.pressures_kpa[b]).cwiseAbs().maxCoeff(), 5.0);
    }
  }
}

TEST(InverseKinematics, SolutionsAreAsManyInAnyUnit) {
  for (const double per_kpa : {1.0, 1e-3, 1e3}) {
    ArmDescription arm = arm_of(3);
    for (Segment& segment : arm.segments) {
      segment.pressure_limit_kpa = per_kpa * segment.pressure_limit_kpa.largest_kpa();
      double power = 1.0;
      for (double& coefficient : segment.strain_polynomial) {
        coefficient /= power *= per_kpa;
      }
    }
    RandomStream random(23, 0);
    const auto result = solve_inverse_kinematics(NoLoadModel(arm),
                                                 {0.5, 0.2, std::nullopt, 0.001, 0.05}, {}, random);
    EXPECT_EQ(result.pressures_kpa.size(), 8u) << per_kpa;
  }
}

// The straight arm sits on the kink of every segment: the step must cross or meet it.
TEST(InverseKinematics, FindsTheStraightArmOnItsKinks) {
  const NoLoadModel model(arm_of(3));
  const Pose tip = tip_of(model, Eigen::VectorXd::Zero(3));
  RandomStream random(24, 0);
  const PoseGoal goal{tip.x_m, 0.0, 0.0, 1e-5, 1e-4};
  const auto result = solve_inverse_kinematics(model, goal, {}, random);
  ASSERT_TRUE(result.reachable()) << result.reason;
  EXPECT_LT(result.pressures_kpa.front().cwiseAbs().maxCoeff(), 2.0);
}

TEST(InverseKinematics, MirroredGoalsHaveMirroredSolutions) {
  const NoLoadModel model(arm_of(2));
  RandomStream random(25, 0);
  const Pose tip = tip_of(model, Eigen::Vector2d(60.0, -30.0));
  const auto right = solve_inverse_kinematics(model, {tip.x_m, tip.y_m, {}, 1e-6, 1.0}, {}, random);
  const auto left = solve_inverse_kinematics(model, {tip.x_m, -tip.y_m, {}, 1e-6, 1.0}, {}, random);
  ASSERT_TRUE(right.reachable() && left.reachable());
  for (const Eigen::VectorXd& pressures : right.pressures_kpa) {
    const bool mirrored = std::any_of(
        left.pressures_kpa.begin(), left.pressures_kpa.end(), [&](const Eigen::VectorXd& other) {
          return (other + pressures).cwiseAbs().maxCoeff() < 1e-4;  // [kPa]
        });
    EXPECT_TRUE(mirrored) << pressures.transpose();
  }
}

TEST(InverseKinematics, OrientationsAreComparedModuloAFullTurn) {
  const PoseGoal goal{0.0, 0.0, 3.1, 0.01, 0.1};
  EXPECT_NEAR(pose_error(goal, {0.0, 0.0, 3.1 - 2.0 * std::numbers::pi}).orientation_rad, 0.0,
              1e-12);
  EXPECT_NEAR(pose_error(goal, {0.0, 0.0, -3.1}).orientation_rad, 2.0 * std::numbers::pi - 6.2,
              1e-12);
}

TEST(InverseKinematics, SaysByHowMuchAGoalIsOutOfReach) {
  const NoLoadModel model(arm_of(3));  // 0.235 + 0.215 + 0.195 = 0.645 m
  RandomStream random(26, 0);
  const auto result = solve_inverse_kinematics(model, {0.745, 0.0, {}, 0.01, 0.05}, {}, random);
  EXPECT_FALSE(result.reachable());
  EXPECT_NEAR(result.best_error.position_m, 0.1, 1e-3);
  EXPECT_NEAR(pose_error({0.745, 0.0, {}}, tip_of(model, result.best_pressures_kpa)).position_m,
              result.best_error.position_m, kExact);
  EXPECT_THAT(result.reason, AllOf(HasSubstr("10.0 cm from the goal (tolerance 1.0 cm)"),
                                   HasSubstr("74.5 cm from the base, the arm is 64.5 cm long")));
}

// A strip of the goal's region is in reach although its centre is not.
TEST(InverseKinematics, AcceptsTheNearestPointWithinTheTolerance) {
  const NoLoadModel model(arm_of(2));
  RandomStream random(27, 0);
  const auto result = solve_inverse_kinematics(model, {0.46, 0.0, {}, 0.02, 0.05}, {}, random);
  ASSERT_TRUE(result.reachable());
  EXPECT_NEAR(result.best_error.position_m, 0.01, 1e-3);
}

TEST(InverseKinematics, SameSeedSameSolutions) {
  const NoLoadModel model(arm_of(3));
  RandomStream first(28, 5);
  RandomStream second(28, 5);
  const PoseGoal goal{0.4, 0.3, 1.5, 0.01, 0.05};
  const auto a = solve_inverse_kinematics(model, goal, {}, first);
  const auto b = solve_inverse_kinematics(model, goal, {}, second);
  ASSERT_TRUE(a.reachable());
  EXPECT_EQ(a.pressures_kpa, b.pressures_kpa);
}

TEST(InverseKinematics, RefusesGoalsThatAreNoNumbersAndSettingsThatCannotWork) {
  const NoLoadModel model(arm_of(2));
  RandomStream random(29, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto solve = [&](const PoseGoal& goal, const InverseKinematicsSettings& settings = {}) {
    (void)solve_inverse_kinematics(model, goal, settings, random);
  };
  EXPECT_THAT(
      [&] {
        solve({nan, 0.0});
      },
      ThrowsMessage<InputError>(HasSubstr("expected finite metres and radians")));
  EXPECT_THAT(
      [&] {
        solve({0.1, 0.0, {}, -0.01});
      },
      ThrowsMessage<InputError>(HasSubstr("goal tolerances -0.01 m")));
  for (const InverseKinematicsSettings& settings :
       {InverseKinematicsSettings{.starts = 0}, InverseKinematicsSettings{.max_solutions = 0},
        InverseKinematicsSettings{.iterations = 0}, InverseKinematicsSettings{.convergence_m = 0.0},
        InverseKinematicsSettings{.distinct_pressure = -1.0}}) {
    EXPECT_THAT(
        [&] {
          solve({0.1, 0.0}, settings);
        },
        ThrowsMessage<InputError>(HasSubstr("must be positive")));
  }
}

TEST(InverseKinematics, LimitsAreOneForEachSegment) {
  const NoLoadModel model(arm_of(3));
  RandomStream random(23, 0);
  InverseKinematicsSettings settings;
  settings.limits = {PressureLimits(50.0)};
  EXPECT_THAT(
      [&] {
        (void)solve_inverse_kinematics(model, {0.5, 0.2, std::nullopt, 0.001, 0.05}, settings,
                                       random);
      },
      ThrowsMessage<InputError>(HasSubstr("1 limits; the arm has 3 segments")));
}

}  // namespace
}  // namespace limber
