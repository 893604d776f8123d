#include <gtest/gtest.h>

#include "limber/trial/replanner.hpp"
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

  const ArmDescription arm_ = small_arm();
  const ForwardModel forward_{arm_, play_network(arm_, kPlayM)};
  const MotionModel model_{forward_};
  Environment environment_;
  Backbone resting_;
  Plan ended_;
};

TEST_F(ReplannerCreepTest, AnArmAtRestIsMovedByWhatIsMissingWhateverTheModelHasItCreep) {
  const Pose before = tip_pose(resting_);
  const Pose creeping = crept();
  ASSERT_GT(std::abs(creeping.y_m - before.y_m), 0.01) << "the model has it back in the goal";
  Replanner source(arm_, model_, environment_, ErrorRoom{}, ReplannerSettings{}, 1);
  const Pressures& held_kpa = ended_.frames.back().setpoint_kpa;
  const std::optional<Plan> next =
      source.next(ended_, ended_.frames.size() - 1, {0.0, held_kpa, std::nullopt, resting_});
  ASSERT_TRUE(next);
  const Pose end = tip_pose(next->frames.back().backbone);
  const double missing_m =
      std::hypot(environment_.goal.x_m - before.x_m, environment_.goal.y_m - before.y_m);
  EXPECT_NEAR(end.x_m - creeping.x_m, environment_.goal.x_m - before.x_m, 0.5 * missing_m);
  EXPECT_NEAR(end.y_m - creeping.y_m, environment_.goal.y_m - before.y_m, 0.5 * missing_m);
  EXPECT_EQ(next->waypoints_kpa.size(), 2U) << "straight, without a turn";
}

}  // namespace
}  // namespace limber
