#include "limber/forward/motion_model.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Slow, with a dead time of one frame and a half: three set points are under way at most.
ValveParameters slow_valves(int segments) {
  return {true, std::vector<SegmentValves>(static_cast<std::size_t>(segments),
                                           {{0.2, 100.0}, {0.3, 100.0}, 0.075, 0.1})};
}

class MotionModelOfArm : public ::testing::Test {
 protected:
  Pressures pressures() {
    return Pressures::NullaryExpr(
        3, [this] { return static_cast<float>(random_.uniform(-90.0, 90.0)); });
  }

  ArmDescription arm_ = sample_arm(3);
  ForwardModel forward_{arm_, untrained_model(arm_, BackboneLayout::gap_poses, {32, 32}, 1)};
  ForwardModel no_load_{arm_};
  ValveModel valves_{arm_, slow_valves(3)};
  RandomStream random_{4, 0};
};

/// Of a network that reads velocities, or does not.
class MotionModelOfNetwork : public MotionModelOfArm, public testing::WithParamInterface<bool> {
 protected:
  ForwardModel forward_{arm_, untrained_model(arm_, BackboneLayout::gap_poses, {32, 32}, 1,
                                              OutputForm::gated_change, GetParam())};
};

INSTANTIATE_TEST_SUITE_P(ReadsVelocity, MotionModelOfNetwork, testing::Bool());

TEST_P(MotionModelOfNetwork, BehindIdealValvesIsTheForwardModel) {
  const MotionModel model(forward_);
  ForwardModel::Workspace workspace;
  const Pressures from = pressures();
  Backbone backbone(arm_.point_count(), 3);
  forward_.no_load().backbone(from, backbone);
  MotionState state = model.settled_state(from, backbone);
  Pressures before = from;
  Backbone earlier = backbone;
  for (int k = 0; k < 20; ++k) {
    const Pressures now = pressures();
    const Backbone last = backbone;
    forward_.step(before, now, earlier, last, backbone, workspace);
    model.step(now, state, workspace);
    EXPECT_EQ(state.backbone, backbone);
    EXPECT_EQ(Pressures(state.pressure_kpa()), now);
    before = now;
    earlier = last;
  }
}

// Valves would count twice before a network that has learnt them along with the arm.
TEST_F(MotionModelOfArm, TakesNoValvesBeforeANetworkThatLearntFromSetPoints) {
  CompensationModel network = untrained_model(arm_, BackboneLayout::gap_poses, {32, 32}, 1);
  network.learnt_from_setpoints = true;
  const ForwardModel of_setpoints(arm_, network);
  EXPECT_THAT([&] { MotionModel(of_setpoints, valves_); },
              ThrowsMessage<InputError>(HasSubstr("without valves")));
  EXPECT_NO_THROW(MotionModel(of_setpoints, ValveModel::ideal(3)));
  EXPECT_TRUE(MotionModel(of_setpoints).valves().is_ideal());
}

TEST_P(MotionModelOfNetwork, FeedsTheForwardModelWithWhatTheValvesLetThrough) {
  const MotionModel model(forward_, valves_);
  ForwardModel::Workspace workspace;
  const Pressures from = pressures();
  Backbone backbone(arm_.point_count(), 3);
  forward_.no_load().backbone(from, backbone);
  MotionState state = model.settled_state(from, backbone);
  Eigen::VectorXf valves = valves_.settled_state(from);
  Backbone earlier = backbone;
  for (int k = 0; k < 20; ++k) {
    const Pressures setpoint = pressures();
    const Pressures before = valves.head(3);
    const Backbone last = backbone;
    valves_.step(setpoint, valves);
    forward_.step(before, valves.head(3), earlier, last, backbone, workspace);
    earlier = last;
    model.step(setpoint, state, workspace);
    EXPECT_EQ(state.backbone, backbone);
    EXPECT_EQ(state.valves, valves);
  }
}

TEST_P(MotionModelOfNetwork, ABatchOfMotionsIsToTheBitTheModelsSteps) {
  const MotionModel model(forward_, valves_);
  ForwardModel::Workspace workspace;
  RolloutBatch batch(model);
  std::vector<MotionState> alone;
  std::vector<Pressures> to;
  constexpr int kMotions = 70;
  constexpr int kFrames = 12;
  for (int i = 0; i < kMotions; ++i) {
    const Pressures from = pressures();
    Backbone backbone(arm_.point_count(), 3);
    forward_.no_load().backbone(from, backbone);
    alone.push_back(model.settled_state(from, backbone));
    model.step(pressures(), alone.back(), workspace);  // in the middle of a motion
    to.push_back(pressures());
    batch.add(i, alone.back(), to.back(), kFrames);
  }
  for (int i = 0; i < kMotions; ++i) {
    MotionState& state = alone[static_cast<std::size_t>(i)];
    const Pressures from = state.setpoint_kpa();
    Pressures setpoint(3);
    for (int k = 1; k <= kFrames; ++k) {
      motion_setpoint(from, to[static_cast<std::size_t>(i)], k, kFrames, setpoint);
      model.step(setpoint, state, workspace);
    }
  }
  for (int k = 0; k < kFrames; ++k) {
    batch.step();
  }
  for (int column = 0; column < batch.size(); ++column) {
    EXPECT_TRUE(batch.state(column) == alone[static_cast<std::size_t>(batch.label(column))]);
  }
}

TEST_F(MotionModelOfArm, ATipAtRestIsWhereItIs) {
  const MotionModel model(no_load_, valves_);
  const Pressures kpa = pressures();
  Backbone backbone(arm_.point_count(), 3);
  no_load_.no_load().backbone(kpa, backbone);
  const MotionState state = model.settled_state(kpa, backbone);
  const Pose tip = tip_pose(backbone);
  const Pose settled = model.settled_tip(state.valves, state.backbone);
  EXPECT_EQ(settled.x_m, tip.x_m);
  EXPECT_EQ(settled.y_m, tip.y_m);
  EXPECT_EQ(settled.theta_rad, tip.theta_rad);
}

// The guess against the truth: the same set points held until the pressures have arrived.
TEST_F(MotionModelOfArm, ASettledTipIsNearWhereHoldingLeads) {
  const MotionModel model(no_load_, valves_);
  ForwardModel::Workspace workspace;
  double off_now = 0.0;
  double off_settled = 0.0;
  double turned_off = 0.0;
  constexpr int kMotions = 100;
  for (int i = 0; i < kMotions; ++i) {
    const Pressures from = pressures();
    const Pressures to = pressures();
    Backbone backbone(arm_.point_count(), 3);
    no_load_.no_load().backbone(from, backbone);
    MotionState state = model.settled_state(from, backbone);
    Pressures setpoint(3);
    constexpr int kFrames = 20;
    for (int k = 1; k <= kFrames; ++k) {
      motion_setpoint(from, to, k, kFrames, setpoint);
      model.step(setpoint, state, workspace);
    }
    const Pose now = tip_pose(state.backbone);
    const Pose guess = model.settled_tip(state.valves, state.backbone);
    for (int k = 0; k < 60; ++k) {
      model.step(to, state, workspace);
    }
    const Pose truth = tip_pose(state.backbone);
    off_now += std::hypot(now.x_m - truth.x_m, now.y_m - truth.y_m) / kMotions;
    off_settled += std::hypot(guess.x_m - truth.x_m, guess.y_m - truth.y_m) / kMotions;
    turned_off = std::max(turned_off, std::abs(guess.theta_rad - truth.theta_rad));
  }
  constexpr double kPart = 0.1;          // of the way that the tip still has to go
  constexpr double kDeadBandRad = 0.01;  // the valves stop 0.1 kPa short
  EXPECT_GT(off_now, 0.02) << "there is something to guess";
  EXPECT_LT(off_settled, kPart * off_now);
  EXPECT_LT(turned_off, kDeadBandRad) << "headings add up, whatever the shape";
}

// Loops behind it pass shapes and pressures on without asking for their sizes again.
TEST_F(MotionModelOfArm, OfAnotherArmIsRefusedByBothNames) {
  ArmDescription finer = arm_;
  finer.name = "finer";
  finer.segments[1].gaps += 2;
  EXPECT_NO_THROW(require_model_of_arm(arm_, no_load_, "here"));
  EXPECT_THAT([&] { require_model_of_arm(finer, no_load_, "here"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("here: the model is of arm '" + arm_.name),
                                              HasSubstr("arm 'finer' has 3 and"))));
  ArmDescription moved = arm_;  // as many plates, elsewhere
  moved.segments[0].gaps += 1;
  moved.segments[1].gaps -= 1;
  EXPECT_THROW(require_model_of_arm(moved, no_load_, "here"), InputError);
}

TEST_F(MotionModelOfArm, ValvesOfAnotherArmAreRefused) {
  EXPECT_THAT([&] { MotionModel(no_load_, ValveModel::ideal(2)); },
              ThrowsMessage<InputError>(HasSubstr("valves of 2 channels; the model of arm")));
}

}  // namespace
}  // namespace limber
