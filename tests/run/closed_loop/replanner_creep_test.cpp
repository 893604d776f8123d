#include <cmath>

#include <gtest/gtest.h>

#include "limber/run/replanner.hpp"
#include "planning/play_model.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr float kPlayM = 0.002F;

/// An arm at rest where the model has none: farther from its no-load shape than the play allows, so
/// that the model has it creep back while it is held.
class ReplannerCreepTest : public ::testing::Test {
 protected:
  ReplannerCreepTest() {
    environment_.name = "a goal beside the arm";
    const Pressures held_kpa = Pressures::Constant(2, 40.0F);
    resting_ = Backbone(arm_.point_count(), 3);
    NoLoadModel(arm_).backbone(Eigen::Ref<const Eigen::VectorXf>(held_kpa),
                               Eigen::Ref<Backbone>(resting_));
    const Pose free = tip_pose(resting_);
    environment_.goal = {free.x_m, free.y_m, std::nullopt, 0.02, 0.1};
    ended_.environment_name = environment_.name;
    ended_.hold_frame_count = 3;
    ended_.frames.assign(4, PlanFrame{held_kpa, held_kpa, resting_});
    ended_.waypoints_kpa = {held_kpa, held_kpa};
    for (Eigen::Index i = 1; i < resting_.rows(); ++i) {
      resting_(i, 1) += 0.015F;
    }
  }

  Pose crept() const {
    MotionState state = model_.settled_state(ended_.frames.back().setpoint_kpa, resting_);
    MotionModel::Workspace workspace;
    for (int k = 0; k < ended_.hold_frame_count; ++k) {
      model_.step(ended_.frames.back().setpoint_kpa, state, workspace);
    }
    return tip_pose(state.backbone);
  }

  /// At rest where it was, whatever the plan had in mind.
  std::optional<Plan> next(Replanner& source, const Plan& plan, std::size_t frame) const {
    return source.next(plan, frame, plan.frames[frame].setpoint_kpa, resting_, source.missed());
  }

  std::optional<Plan> plan_from(const Backbone& shape) const {
    Replanner source(arm_, model_, environment_, ErrorRoom{}, ReplannerSettings{}, 1);
    return source.next(ended_, ended_.frames.size() - 1, ended_.frames.back().setpoint_kpa, shape,
                       {});
  }

  const ArmDescription arm_ = small_arm();
  const ForwardModel forward_{arm_, play_network(arm_, kPlayM)};
  const MotionModel model_{forward_};
  Environment environment_;
  Backbone resting_;
  Plan ended_;
};

/// Half of the creep is believed. What is missing is moved, to within the rest of it.
TEST_F(ReplannerCreepTest, AnArmAtRestIsMovedByWhatIsMissingAndHalfOfTheCreep) {
  const Pose before = tip_pose(resting_);
  const Pose creeping = crept();
  ASSERT_GT(std::abs(creeping.y_m - before.y_m), 0.01) << "the model has it back in the goal";
  const std::optional<Plan> next = plan_from(resting_);
  ASSERT_TRUE(next);
  const Pose end = tip_pose(next->frames.back().backbone);
  const PoseGoal& goal = environment_.goal;
  EXPECT_NEAR(end.x_m, goal.x_m + 0.5 * (creeping.x_m - before.x_m), 0.003);
  EXPECT_NEAR(end.y_m, goal.y_m + 0.5 * (creeping.y_m - before.y_m), 0.003);
}

TEST_F(ReplannerCreepTest, AnArmThatIsNearEnoughIsLeftAloneAndOneThatIsNotIsMoved) {
  const Backbone off = resting_;
  for (const double distance_m : {0.0005, 0.0015}) {
    resting_ = off;
    environment_.goal.x_m = double(off(off.rows() - 1, 0)) + distance_m;
    environment_.goal.y_m = double(off(off.rows() - 1, 1));
    EXPECT_FALSE(plan_from(resting_)) << distance_m << " of a tolerance of 0.02";
  }
  environment_.goal.x_m += 0.004;
  EXPECT_TRUE(plan_from(resting_));
}

TEST_F(ReplannerCreepTest, AnArmThatWasHaltedInTheGoalIsCorrectedAsAtItsEnd) {
  Replanner source(arm_, model_, environment_, ErrorRoom{}, ReplannerSettings{}, 1);
  const std::optional<Plan> found = next(source, ended_, 1);
  ASSERT_TRUE(found);
  EXPECT_TRUE(source.is_correction());
  environment_.goal.y_m -= 0.03;  // it stands outside
  Replanner outside(arm_, model_, environment_, ErrorRoom{}, ReplannerSettings{}, 1);
  ASSERT_TRUE(next(outside, ended_, 1));
  EXPECT_FALSE(outside.is_correction());
}

TEST_F(ReplannerCreepTest, AnArmThatDidNotMoveIsMovedByMore) {
  Replanner source(arm_, model_, environment_, ErrorRoom{}, ReplannerSettings{}, 1);
  Plan plan = ended_;
  std::vector<double> costs_kpa;
  for (int k = 0; k < 4; ++k) {
    const std::optional<Plan> found = next(source, plan, plan.frames.size() - 1);
    ASSERT_TRUE(found) << k;
    costs_kpa.push_back(found->cost_kpa);
    plan = *found;
  }
  for (std::size_t k = 0; k < costs_kpa.size(); ++k) {
    EXPECT_GE(costs_kpa[k], std::ldexp(5.0, static_cast<int>(k))) << k << " moved nothing";
  }
}

}  // namespace
}  // namespace limber
