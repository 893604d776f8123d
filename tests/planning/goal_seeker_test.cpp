#include "src/planning/search/goal_seeker.hpp"

#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "planning/random_shapes.hpp"

namespace limber {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kDamping = 1e-3;  // of the trace, as docs/planning.md has it

class GoalSeeker : public ::testing::Test {
 protected:
  Pose tip_at(const Eigen::VectorXd& kpa) const {
    BackboneD b(model_.point_count(), 3);
    model_.backbone(kpa, b);
    return {b(b.rows() - 1, 0), b(b.rows() - 1, 1), b(b.rows() - 1, 2)};
  }

  Eigen::VectorXd curvatures_at(const Eigen::VectorXd& kpa) const {
    Eigen::VectorXd curvatures(kpa.size());
    for (int i = 0; i < kpa.size(); ++i) {
      curvatures[i] = model_.segment_shape(i, kpa[i]).curvature_per_m;
    }
    return curvatures;
  }

  /// Pressures of curvatures by bisection: knows nothing of the model's own inverse.
  Eigen::VectorXd pressures_at(const Eigen::VectorXd& curvatures) const {
    Eigen::VectorXd kpa(curvatures.size());
    for (int i = 0; i < kpa.size(); ++i) {
      double low = -100.0, high = 100.0;  // curvature falls with pressure
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (model_.segment_shape(i, middle).curvature_per_m > curvatures[i] ? low : high) = middle;
      }
      kpa[i] = 0.5 * (low + high);
    }
    return kpa;
  }

  /// Motion of the tip per curvature, by central differences of the backbone.
  Eigen::MatrixXd differences(const Eigen::VectorXd& curvatures) const {
    constexpr double kStep = 1e-4;  // [1/m]
    Eigen::MatrixXd jacobian(3, curvatures.size());
    for (int i = 0; i < curvatures.size(); ++i) {
      Eigen::VectorXd up = curvatures, down = curvatures;
      up[i] += kStep;
      down[i] -= kStep;
      const Pose a = tip_at(pressures_at(up));
      const Pose b = tip_at(pressures_at(down));
      jacobian.col(i) << a.x_m - b.x_m, a.y_m - b.y_m, a.theta_rad - b.theta_rad;
    }
    return jacobian / (2.0 * kStep);
  }

  /// Within `share` of the limits, no segment straight, where the length has a kink.
  Pressures bent(RandomStream& random, double share) const {
    Pressures kpa(3);
    for (float& one : kpa) {
      one = static_cast<float>(random.uniform(5.0, 100.0 * share) *
                               (random.uniform() < 0.5 ? -1.0 : 1.0));
    }
    return kpa;
  }

  Pressures step(const PoseGoal& goal, const Pressures& from, const Pose& tip) const {
    return step_toward_goal(model_, goal, arm_.length_m(), from, tip);
  }

  ArmDescription arm_ = three_segment_arm();
  NoLoadModel model_{arm_};
};

// The damped step in its other form, (JᵀJ + λ)⁻¹ Jᵀ e, with J by finite differences.
TEST_F(GoalSeeker, StepIsTheDampedNewtonStepOfFiniteDifferences) {
  RandomStream random(1, 1);
  for (int k = 0; k < 60; ++k) {
    const Pressures from = bent(random, 0.7);
    const Pose tip = tip_at(from.cast<double>());
    PoseGoal goal{tip.x_m + random.uniform(-0.02, 0.02), tip.y_m + random.uniform(-0.02, 0.02),
                  std::nullopt, 0.01, 0.1};
    const bool with_heading = k % 2 == 0;
    if (with_heading) {
      goal.theta_rad = tip.theta_rad + random.uniform(-0.05, 0.05);
    }
    Eigen::MatrixXd jacobian = differences(curvatures_at(from.cast<double>()));
    jacobian.row(2) *= with_heading ? arm_.length_m() : 0.0;
    Eigen::Vector3d error(goal.x_m - tip.x_m, goal.y_m - tip.y_m, 0.0);
    if (with_heading) {
      error.z() = arm_.length_m() * (*goal.theta_rad - tip.theta_rad);
    }
    Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    const double trace = normal.trace();
    normal.diagonal().array() += kDamping * trace;
    const Eigen::VectorXd expected = pressures_at(curvatures_at(from.cast<double>()) +
                                                  normal.inverse() * jacobian.transpose() * error);
    constexpr double kToleranceKpa = 2e-2;  // the differences' error, grown by the damped inverse
    EXPECT_LT((step(goal, from, tip).cast<double>() - expected).cwiseAbs().maxCoeff(),
              kToleranceKpa)
        << "case " << k;
  }
}

TEST_F(GoalSeeker, StepsContractTheDistanceToAGoalNearby) {
  RandomStream random(2, 1);
  int nearly_there = 0;
  constexpr int kCases = 200;
  for (int k = 0; k < kCases; ++k) {
    Eigen::VectorXd at = bent(random, 0.7).cast<double>();
    Eigen::VectorXd there = at;
    for (double& one : there) {
      one += random.uniform(-3.0, 3.0);
    }
    const Pose target = tip_at(there);
    const PoseGoal goal{target.x_m, target.y_m, std::nullopt, 1e-3, 0.1};
    const double first_m = pose_error(goal, tip_at(at)).position_m;
    double before_m = first_m;
    for (int i = 0; i < 6; ++i) {
      at = step(goal, at.cast<float>(), tip_at(at)).cast<double>();
      const double after_m = pose_error(goal, tip_at(at)).position_m;
      constexpr double kRoundingM = 1e-6;  // pressures are float32
      EXPECT_LE(after_m, before_m + kRoundingM) << "case " << k << ", step " << i;
      before_m = after_m;
    }
    nearly_there += before_m < 0.05 * first_m ? 1 : 0;
  }
  EXPECT_GT(nearly_there, 9 * kCases / 10) << "damping slows those that hardly move one way";
}

TEST_F(GoalSeeker, AtTheGoalThePressuresStay) {
  RandomStream random(3, 1);
  for (int k = 0; k < 50; ++k) {
    const Pressures from = bent(random, 0.9);
    // Of another model the tip lies elsewhere; what counts is where it is.
    const Pose tip{random.uniform(0.2, 0.6), random.uniform(-0.3, 0.3), random.uniform(-2.0, 2.0)};
    const PoseGoal goal{tip.x_m, tip.y_m, tip.theta_rad, 0.01, 0.1};
    constexpr float kToleranceKpa = 1e-3F;
    EXPECT_LT((step(goal, from, tip) - from).cwiseAbs().maxCoeff(), kToleranceKpa);
  }
}

TEST_F(GoalSeeker, HeadingsCountModuloATurnAndNotAtAllWithoutOne) {
  RandomStream random(4, 1);
  for (int k = 0; k < 20; ++k) {
    const Pressures from = bent(random, 0.7);
    Pose tip = tip_at(from.cast<double>());
    PoseGoal goal{tip.x_m + 0.01, tip.y_m, tip.theta_rad + 0.1, 0.01, 0.1};
    const Pressures to = step(goal, from, tip);
    *goal.theta_rad += kTurn;
    constexpr float kToleranceKpa = 1e-3F;
    EXPECT_LT((step(goal, from, tip) - to).cwiseAbs().maxCoeff(), kToleranceKpa);
    EXPECT_NEAR(goal_error(goal, tip), 1.0 + 1.0, 1e-9) << "a tolerance each way";
    goal.theta_rad.reset();
    const Pressures without = step(goal, from, tip);
    tip.theta_rad += 1.0;
    EXPECT_EQ(step(goal, from, tip), without);
    EXPECT_NEAR(goal_error(goal, tip), 1.0, 1e-9);
  }
}

class GoalAims : public ::testing::Test {
 protected:
  ArmDescription arm_ = three_segment_arm();
  ForwardModel model_{arm_};
  Environment environment_;
  PlanningProblem problem_{arm_, model_, environment_};

  GoalAims() { environment_.goal = {0.4, 0.2, 0.5, 0.02, 0.2}; }
  Pose tip(double along_m, double turn_rad) const { return {0.4 + along_m, 0.2, 0.5 + turn_rad}; }
};

TEST_F(GoalAims, WithoutAnAimAllInTheGoalIsAlike) {
  const GoalAim aim(problem_);
  EXPECT_EQ(aim.merit_kpa(50.0, tip(0.0, 0.0)), 50.0);
  EXPECT_EQ(aim.merit_kpa(50.0, tip(0.019, 0.19)), 50.0);
}

// Arriving well comes before costing little: within the goal, a thousandth of its tolerance is
// worth two kPa.
TEST_F(GoalAims, WithOneMeritGrowsWithTheDistanceBeyondIt) {
  problem_.aim = PoseError{0.005, 0.05};
  const GoalAim aim(problem_);
  EXPECT_EQ(aim.merit_kpa(50.0, tip(0.0049, 0.049)), 50.0);
  EXPECT_NEAR(aim.beyond(tip(0.015, 0.0)), 0.5, 1e-9) << "1 cm of the goal's 2 cm";
  EXPECT_NEAR(aim.beyond(tip(0.015, -0.15)), 1.0, 1e-9);
  double before_kpa = 0.0;
  for (double along_m = 0.006; along_m < 0.02; along_m += 0.001) {
    const double merit_kpa = aim.merit_kpa(50.0, tip(along_m, 0.0));
    EXPECT_NEAR(merit_kpa, 50.0 + 2000.0 * (along_m - 0.005) / 0.02, 1e-6);
    EXPECT_GT(merit_kpa, before_kpa);
    before_kpa = merit_kpa;
  }
}

// What is a tenth of a tolerance worth to plans whose costs are in MPa? As much of their costs.
TEST_F(GoalAims, AMeritIsOfTheCommandsUnit) {
  problem_.aim = PoseError{0.005, 0.05};
  const double in_kpa = GoalAim(problem_).merit_kpa(50.0, tip(0.015, 0.0));
  for (Segment& segment : arm_.segments) {
    segment.pressure_limit_kpa = 1e-3 * segment.pressure_limit_kpa.largest_kpa();
  }
  EXPECT_NEAR(GoalAim(problem_).merit_kpa(0.05, tip(0.015, 0.0)), 1e-3 * in_kpa, 1e-6);
}

TEST_F(GoalAims, AnAimWiderThanTheGoalIsTheGoal) {
  problem_.aim = PoseError{0.5, 3.0};
  const GoalAim aim(problem_);
  EXPECT_EQ(aim.inner().position_tolerance_m, environment_.goal.position_tolerance_m);
  EXPECT_EQ(aim.inner().orientation_tolerance_rad, environment_.goal.orientation_tolerance_rad);
}

// Uniform in a disc of radius R: the squared distance from its centre is R²/2 in the mean.
TEST_F(GoalSeeker, SampledConfigurationsFillTheGoalsRegion) {
  const Pose centre = tip_at(Eigen::Vector3d(-30.0, -30.0, -30.0));
  const PoseGoal goal{centre.x_m, centre.y_m, std::nullopt, 0.03, 0.1};
  constexpr int kSamples = 200;
  GoalSampler sampler(model_, goal, kSamples);
  RandomStream random(5, 1);
  double squares = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const Pressures& kpa = sampler.sample(random);
    EXPECT_LE(kpa.cwiseAbs().maxCoeff(), 100.0F);
    const double off_m = pose_error(goal, tip_at(kpa.cast<double>())).position_m;
    constexpr double kNewtonM = 1e-3;
    EXPECT_LE(off_m, goal.position_tolerance_m + kNewtonM);
    squares += off_m * off_m;
  }
  const double share = squares / kSamples / (goal.position_tolerance_m * goal.position_tolerance_m);
  constexpr double kFiveDeviations = 5.0 * 0.289 / 14.1;  // of a uniform number, over √200
  EXPECT_NEAR(share, 0.5, kFiveDeviations);
}

TEST_F(GoalSeeker, AfterSoManySamplesTheSameAreUsedAgain) {
  const Pose centre = tip_at(Eigen::Vector3d(-30.0, -30.0, -30.0));
  const PoseGoal goal{centre.x_m, centre.y_m, std::nullopt, 0.03, 0.1};
  GoalSampler sampler(model_, goal, 100);
  sampler.draw_at_most(4);
  RandomStream random(6, 1);
  std::set<std::vector<float>> kinds;
  for (int k = 0; k < 40; ++k) {
    const Pressures& kpa = sampler.sample(random);
    kinds.insert({kpa.begin(), kpa.end()});
  }
  EXPECT_EQ(kinds.size(), 4U);
}

}  // namespace
}  // namespace limber
