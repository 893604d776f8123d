#include "src/run/closed_loop/sampled_motions.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "planning/play_model.hpp"
#include "src/run/closed_loop/plan_repair.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr std::uint64_t kQueries = 6000;

/// A tip at rest at 40 kPa in a model with play, 1.5 cm from its goal.
class SampledMotionsTest : public ::testing::Test {
 protected:
  SampledMotionsTest() {
    const Pressures held_kpa = Pressures::Constant(2, 40.0F);
    Backbone resting(arm_.point_count(), 3);
    NoLoadModel(arm_).backbone(Eigen::Ref<const Eigen::VectorXf>(held_kpa),
                               Eigen::Ref<Backbone>(resting));
    const Pose tip = tip_pose(resting);
    environment_.start = ArmStart{held_kpa, resting};
    environment_.goal = {tip.x_m + 0.005, tip.y_m + 0.014, std::nullopt, 0.02, 0.1};
  }

  PlanningProblem problem() const { return {arm_, model_, environment_}; }

  double error_m(const Pose& tip) const {
    return as_length_m(environment_.goal, pose_error(environment_.goal, tip));
  }

  /// As the motion's own simulation, one frame after another.
  Pose end_of(const SampledMotion& motion) const {
    MotionState state = start_of(problem());
    MotionModel::Workspace workspace;
    Pressures now_kpa(2);
    const std::vector<Pressures>& way = motion.waypoints_kpa;
    for (std::size_t w = 1; w < way.size(); ++w) {
      const int frames = motion_frame_count(way[w - 1], way[w], arm_.pressure_step_limit_kpa());
      for (int k = 1; k <= frames; ++k) {
        motion_setpoint(way[w - 1], way[w], k, frames, now_kpa);
        model_.step(now_kpa, state, workspace);
      }
    }
    for (int k = 0; k < arm_.frames_in(kHoldS); ++k) {
      model_.step(way.back(), state, workspace);
    }
    return tip_pose(state.backbone);
  }

  static std::optional<Plan> planned(const PlanningProblem& problem, const SampledPlanAsked& asked,
                                     const PlanCheck& check) {
    return sampled_plan(problem, sampled_motions(problem, kQueries, 5), asked, 5, check);
  }

  const PlanCheck accept_ = [](Plan&, const Environment&) { return true; };
  const ArmDescription arm_ = small_arm();
  const ForwardModel forward_{arm_, play_network(arm_, 0.002F)};
  const MotionModel model_{forward_};
  Environment environment_;
};

TEST_F(SampledMotionsTest, EndWhereTheModelHasThemEndAndTheBestIsNear) {
  const std::vector<SampledMotion> all = sampled_motions(problem(), kQueries, 5);
  ASSERT_GT(all.size(), 100U);
  EXPECT_LT(all.front().error_m, 0.002);
  bool has_straight = false;
  bool has_turn = false;
  for (std::size_t k = 0; k < all.size(); k += 10) {
    EXPECT_NEAR(all[k].error_m, error_m(end_of(all[k])), 1e-6) << k;
    EXPECT_NEAR(all[k].effort, path_cost_kpa(all[k].waypoints_kpa) / 100.0, 1e-6) << k;
    has_straight = has_straight || all[k].waypoints_kpa.size() == 2;
    has_turn = has_turn || all[k].waypoints_kpa.size() == 3;
  }
  EXPECT_TRUE(has_straight && has_turn);
  const double worth_m = 0.0014 * arm_.length_m();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return a.error_m + worth_m * a.effort < b.error_m + worth_m * b.effort;
  }));
}

TEST_F(SampledMotionsTest, StayWithinTheProblemsLimitsAndAreTheSameForTheSameSeed) {
  PlanningProblem narrow = problem();
  narrow.limits.assign(2, PressureLimits(30.0, 45.0));
  const std::vector<SampledMotion> all = sampled_motions(narrow, kQueries, 5);
  for (const SampledMotion& motion : all) {
    for (const Pressures& kpa : motion.waypoints_kpa) {
      EXPECT_GE(kpa.minCoeff(), 30.0F);
      EXPECT_LE(kpa.maxCoeff(), 45.0F);
    }
  }
  const std::vector<SampledMotion> again = sampled_motions(narrow, kQueries, 5);
  ASSERT_EQ(again.size(), all.size());
  EXPECT_EQ(again.front().waypoints_kpa, all.front().waypoints_kpa);
  EXPECT_NE(sampled_motions(narrow, kQueries, 6).front().waypoints_kpa, all.front().waypoints_kpa);
}

TEST_F(SampledMotionsTest, APlanOfThemIsCheckedAndAsAskedFor) {
  int checks = 0;
  const PlanCheck third = [&](Plan&, const Environment&) { return ++checks == 3; };
  const SampledPlanAsked asked{0.004, 0.5};
  const std::optional<Plan> plan = planned(problem(), asked, third);
  ASSERT_TRUE(plan);
  EXPECT_EQ(checks, 3) << "the first two were refused";
  EXPECT_LE(plan->goal_distance_m, asked.max_error_m + 1e-6);
  EXPECT_GE(plan->cost_kpa, 100.0 * asked.least_effort);
  EXPECT_FALSE(planned(problem(), {1e-7, 0.5}, accept_)) << "none is that near";
}

TEST_F(SampledMotionsTest, APlanOfMoreEffortIsPreferredWhereThereIsOne) {
  const auto cost_kpa = [&](double better_effort) {
    return planned(problem(), {0.01, 0.05, better_effort}, accept_).value().cost_kpa;
  };
  const double least_kpa = cost_kpa(0.0);
  EXPECT_GE(least_kpa, 5.0);
  EXPECT_GE(cost_kpa(0.02 * least_kpa), 2.0 * least_kpa);
  EXPECT_EQ(cost_kpa(1e6), least_kpa) << "there is none";
}

TEST_F(SampledMotionsTest, APlanOfThemKeepsTheMarginOrMostOfTheClearanceNow) {
  const Pose tip = tip_pose(environment_.start->backbone);
  environment_.obstacles = {Circle{tip.x_m + 0.06, tip.y_m, 0.02}};
  const double now_m = CollisionChecker(arm_, environment_.obstacles)
                           .clearance(environment_.start->backbone)
                           .value_m;
  ASSERT_GT(now_m, 0.005);
  ASSERT_LT(now_m, 0.05);
  PlanningProblem far = problem();
  far.margin_m = 1.0;
  const std::optional<Plan> plan = planned(far, {0.02, 0.0}, accept_);
  ASSERT_TRUE(plan);
  EXPECT_GE(plan->clearance_m, 0.9 * now_m);
}

}  // namespace
}  // namespace limber
