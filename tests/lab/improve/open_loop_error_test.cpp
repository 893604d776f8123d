#include "src/lab/improve/open_loop_error.hpp"

#include <gtest/gtest.h>

#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-6;  // [m]; float32 over a 0.7 m arm

/// What the model says of `frames` frames of slowly rising set points: motions of ten frames.
Episode predicted(const ArmDescription& arm, const MotionModel& model, int frames) {
  Episode episode;
  const Eigen::Index n = arm.segment_count();
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) * arm.frame_period_s());
  episode.setpoint_kpa = FrameMatrix::Zero(frames, n);
  episode.backbone.resize(frames, 3 * arm.point_count());
  Backbone rest(arm.point_count(), 3);
  model.no_load().backbone(Pressures::Zero(n), rest);
  MotionState state = model.settled_state(Pressures::Zero(n), rest);
  MotionModel::Workspace workspace;
  for (int t = 0; t < frames; ++t) {
    episode.setpoint_kpa.row(t).setConstant(static_cast<float>(t));
    if (t > 0) {
      model.step(episode.setpoint_kpa.row(t).transpose(), state, workspace);
    }
    episode.backbone.row(t) = state.backbone.reshaped<Eigen::RowMajor>().transpose();
    episode.motion_index.push_back(t / 10);
  }
  episode.pressure_kpa = episode.setpoint_kpa;
  return episode;
}

class OpenLoopErrors : public ::testing::Test {
 protected:
  const ArmDescription arm_ = sample_arm(3);
  const ForwardModel forward_{arm_};
  const MotionModel model_{forward_};
};

TEST_F(OpenLoopErrors, AreZeroOnTheModelsOwnMotions) {
  const Episode episode = predicted(arm_, model_, 31);
  const OpenLoopError plans = error_on_plans(model_, {episode, episode});
  EXPECT_EQ(plans.runs, 2);
  EXPECT_NEAR(plans.largest_m, 0.0, kRounding);
  const OpenLoopError motions = error_on_motions(model_, {episode});
  EXPECT_EQ(motions.runs, 4);  // frame 30 alone begins the fourth
  EXPECT_NEAR(motions.largest_m, 0.0, kRounding);
}

// All plates moved by 3 cm and 4 cm after the start: 5 cm off everywhere.
TEST_F(OpenLoopErrors, AreTheDistanceByWhichAllPlatesAreOff) {
  Episode episode = predicted(arm_, model_, 20);
  for (int t = 1; t < 20; ++t) {
    for (int plate = 0; plate < arm_.point_count(); ++plate) {
      episode.backbone(t, 3 * plate) += 0.03F;
      episode.backbone(t, 3 * plate + 1) += 0.04F;
    }
  }
  const OpenLoopError error = error_on_plans(model_, {episode});
  EXPECT_NEAR(error.mean_m, 0.05, kRounding);
  EXPECT_NEAR(error.largest_m, 0.05, kRounding);
}

TEST_F(OpenLoopErrors, UntrackedFramesDoNotCount) {
  Episode episode = predicted(arm_, model_, 20);
  episode.tracked.assign(20, 1);
  episode.tracked[7] = 0;
  episode.backbone.row(7).setConstant(9.0F);
  EXPECT_NEAR(error_on_plans(model_, {episode}).largest_m, 0.0, kRounding);
  episode.tracked[0] = 0;  // where it starts is not known
  EXPECT_EQ(error_on_plans(model_, {episode}).runs, 0);
}

}  // namespace
}  // namespace limber
