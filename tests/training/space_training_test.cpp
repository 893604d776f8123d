// Arms in space through training: a toy arm whose answer is known, and its model's file.
#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/arm/space_no_load.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/data/space_fit.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/past_commands.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/yardsticks.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"
#include "training/space_toy_arm.hpp"

namespace limber {
namespace {

using testing_support::space_arm;
using testing_support::space_toy_episode;

TEST(SpaceFit, FindsLagDeadTimeAndWhatEveryChamberDoes) {
  const ArmDescription arm = space_arm();
  const std::vector<Episode> episodes = {space_toy_episode(arm, 800, 1, 2)};
  const SpaceFit fit = fit_space_model(arm, episodes);
  EXPECT_NEAR(fit.dead_time_s + fit.lag_s, 0.3, 0.05);  // one stands in for the other, a little
  EXPECT_LT(fit.tip_mm, 5.0);
  for (const ChamberFinding& found : chamber_findings(arm, fit)) {
    EXPECT_EQ(found.suspicion, "") << found.name;
  }
}

TEST(SpaceFit, FindsHowLongSegmentsAreAtRest) {
  const ArmDescription arm = space_arm();
  ArmDescription shorter = arm;
  shorter.segments[0].length_m *= 0.8;
  const SpaceFit fit = fit_space_model(shorter, {space_toy_episode(arm, 800, 1, 2)});
  const SegmentAtRest rest = segment_at_rest(fit, shorter, 0);
  EXPECT_GT(rest.length_sd_m, 0.0);
  EXPECT_NEAR(rest.length_m, arm.segments[0].length_m, 4.0 * rest.length_sd_m);
  EXPECT_NEAR(rest.length_m, arm.segments[0].length_m, 0.002);
  const ArmDescription fitted = with_space_fit(shorter, fit);
  EXPECT_NEAR(fitted.segments[0].length_m, rest.length_m, 1e-6);
  // What a chamber adds to the length is the same, whatever the file had.
  const ArmDescription of_right_file =
      with_space_fit(arm, fit_space_model(arm, {space_toy_episode(arm, 800, 1, 2)}));
  EXPECT_NEAR(fitted.segments[0].shape_of_strains(2, 0),
              of_right_file.segments[0].shape_of_strains(2, 0), 1e-3);
}

// It is tried in steps of half a frame, 25 ms, and lies between them.
TEST(SpaceFit, FindsADeadTimeBetweenItsSteps) {
  const ArmDescription arm = space_arm();
  Episode episode = space_toy_episode(arm, 800, 1, 2);
  SpaceFit truth = fit_space_model(arm, {episode});
  truth.dead_time_s = 0.11;
  truth.lag_s = 0.22;
  episode.backbone = predict(truth, arm, episode);
  const SpaceFit found = fit_space_model(arm, {episode});
  EXPECT_EQ(found.lag_s, truth.lag_s);
  EXPECT_NEAR(found.dead_time_s, truth.dead_time_s, 0.005);
}

TEST(SpaceFit, IsSurerOfTheDeadTimeTheMoreItHasSeen) {
  const ArmDescription arm = space_arm();
  const SpaceFit little = fit_space_model(arm, {space_toy_episode(arm, 200, 1, 2)});
  const SpaceFit much = fit_space_model(arm, {space_toy_episode(arm, 3200, 1, 2)});
  EXPECT_GT(much.dead_time_sd_s, 0.0);
  EXPECT_LT(much.dead_time_sd_s, 0.5 * little.dead_time_sd_s);
  EXPECT_LT(little.dead_time_sd_s, arm.frame_period_s());
}

TEST(SpaceFit, KeepsWhatNeverMovesAsTheArmFileHasIt) {
  const ArmDescription arm = space_arm();
  std::vector<Episode> episodes = {space_toy_episode(arm, 800, 1, 2)};
  RandomStream random(7, 0);
  const NoLoadModel no_load(arm);
  for (int t = 0; t < episodes[0].frame_count(); ++t) {  // a sensor's noise about a pretension
    episodes[0].pressure_kpa(t, 1) = float(0.5 + 0.1 * random.normal());
    Eigen::VectorXf poses(episodes[0].backbone.cols());
    no_load.poses(episodes[0].pressure_kpa.row(t).transpose(), poses);
    episodes[0].backbone.row(t) = poses.transpose();
  }
  const SpaceFit fit = fit_space_model(arm, episodes);
  EXPECT_EQ(fit.shape.col(1), SpaceNoLoad(arm).shape_of_strains().col(1));
  EXPECT_THAT(chamber_findings(arm, fit)[1].suspicion, testing::StartsWith("hardly changes"));
  EXPECT_EQ(chamber_findings(arm, fit)[2].suspicion, "");
}

TEST(SpaceFit, NamesColumnsInAnotherOrder) {
  const ArmDescription arm = space_arm();
  std::vector<Episode> episodes = {space_toy_episode(arm, 800, 1, 2)};
  for (FrameMatrix* commands : {&episodes[0].setpoint_kpa, &episodes[0].pressure_kpa}) {
    commands->col(0).swap(commands->col(1));
  }
  const std::vector<ChamberFinding> findings =
      chamber_findings(arm, fit_space_model(arm, episodes));
  EXPECT_NE(findings[0].suspicion.find("another order"), std::string::npos);
  EXPECT_NE(findings[1].suspicion.find("another order"), std::string::npos);
  EXPECT_EQ(findings[3].suspicion, "");
}

TEST(SpaceTraining, ANetworkLearnsWhatTheSimpleModelsLack) {
  const ArmDescription arm = space_arm();
  TrainingData data;
  constexpr int kLate = 3;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    data.training.push_back(space_toy_episode(arm, 1500, seed, kLate));
  }
  data.validation = {space_toy_episode(arm, 400, 5, kLate)};
  TrainingSettings settings = best_preset();
  set_window_frames(settings, {16});
  set_epoch_count(settings, 100);
  settings.hidden_units = {60};
  settings.optimiser = Optimiser::adam;  // of five minutes SOAP makes networks that lean on bounds
  settings.jobs = 2;
  const TrainingResult result = train(arm, data, settings);
  ASSERT_EQ(result.status, TrainingStatus::finished);
  ASSERT_TRUE(result.model.bounds.has_value());
  EXPECT_EQ(result.model.bounds->max_bend_rad.size(), arm.point_count() - 1);

  const TemporaryFolder folder;
  write_model(folder.path() / "m.safetensors", result.model);
  const CompensationModel read = read_model(folder.path() / "m.safetensors");
  EXPECT_EQ(read.dimension, Dimension::space);
  EXPECT_EQ(read.channel_count(), 6);
  EXPECT_EQ(read.past_commands, default_past_commands(arm));

  const std::vector<Episode> unseen = {space_toy_episode(arm, 600, 6, kLate)};
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, read);
  const Evaluation errors = evaluate(no_load, &network, unseen);
  EXPECT_LT(errors.network->window_32.position_cm.mean,
            0.3 * errors.no_load_open_loop.position_cm.mean);

  settings.reads_past_commands = false;
  const ForwardModel forgetful(arm, train(arm, data, settings).model);
  EXPECT_LT(errors.network->window_32.position_cm.mean,
            0.7 * evaluate(no_load, &forgetful, unseen).network->window_32.position_cm.mean);
  EXPECT_TRUE(errors.long_rollout.bounded);
}

// Column j of a batch is what the query alone gives, to the bit.
TEST(SpaceForward, ManyQueriesAreAsOne) {
  const ArmDescription arm = space_arm();
  TrainingData data;
  data.training = {space_toy_episode(arm, 300, 1)};
  data.validation = {space_toy_episode(arm, 200, 3)};
  TrainingSettings settings = best_preset();
  set_window_frames(settings, {8});
  set_epoch_count(settings, 2);
  const ForwardModel model(arm, train(arm, data, settings).model);
  constexpr Eigen::Index kQueries = 150;
  const Episode& episode = data.training.front();
  const Eigen::MatrixXf told = model.told_commands(episode.pressure_kpa.transpose());
  const Eigen::MatrixXf before_kpa = told.leftCols(kQueries);
  const Eigen::MatrixXf now_kpa = told.middleCols(1, kQueries);
  const Eigen::MatrixXf before = episode.backbone.topRows(kQueries).transpose();
  const Eigen::MatrixXf previous = episode.backbone.middleRows(1, kQueries).transpose();
  Eigen::MatrixXf next(previous.rows(), kQueries);
  ForwardModel::Workspace workspace;
  model.step_batch(before_kpa, now_kpa, before, previous, next, workspace);
  for (Eigen::Index j = 0; j < kQueries; ++j) {
    Eigen::MatrixXf one(previous.rows(), 1);
    model.step_batch(before_kpa.col(j), now_kpa.col(j), before.col(j), previous.col(j), one,
                     workspace);
    ASSERT_EQ(one.col(0), next.col(j)) << j;
  }
}

TEST(SpaceForward, ARolloutIsToldTheCommandsOfBefore) {
  const ArmDescription arm = space_arm();
  const std::vector<int> past = {1, 3};
  const ForwardModel model(arm, untrained_model(arm, BackboneLayout::gap_poses, {20}, 1,
                                                OutputForm::gated_change, true, past));
  EXPECT_EQ(model.command_size(), 3 * arm.channel_count());
  const Eigen::MatrixXf commands = space_toy_episode(arm, 8, 1).pressure_kpa.transpose();
  Eigen::MatrixXf shapes = space_toy_episode(arm, 8, 2).backbone.transpose();
  ForwardModel::Workspace workspace;
  model.rollout(commands, shapes, workspace);
  Eigen::MatrixXf before = shapes.col(0), now = shapes.col(0);
  for (int t = 1; t < 8; ++t) {
    const auto told = [&](int at) {
      Eigen::VectorXf all(model.command_size());
      all << commands.col(at), commands.col(std::max(at - 1, 0)), commands.col(std::max(at - 3, 0));
      return all;
    };
    Eigen::MatrixXf next(now.rows(), 1);
    model.step_batch(told(t - 1), told(t), before, now, next, workspace);
    ASSERT_EQ(next.col(0), shapes.col(t)) << t;
    before = now;
    now = next;
  }
}

// The batch's no-load kernel shares no code with NoLoadModel::poses.
TEST(SpaceForward, NoLoadBatchesAgreeWithTheModel) {
  const ArmDescription arm = space_arm();
  const ForwardModel model(arm);
  const Episode episode = space_toy_episode(arm, 100, 1);
  const Eigen::MatrixXf commands = episode.pressure_kpa.transpose() * 1.3F;  // beyond limits too
  const Eigen::MatrixXf shapes = episode.backbone.transpose();
  Eigen::MatrixXf next(shapes.rows(), shapes.cols());
  ForwardModel::Workspace workspace;
  model.step_batch(commands, commands, shapes, next, workspace);
  for (Eigen::Index j = 0; j < next.cols(); ++j) {
    Eigen::VectorXf expected(shapes.rows());
    model.no_load().poses(commands.col(j), expected);
    EXPECT_LT((next.col(j) - expected).cwiseAbs().maxCoeff(), 2e-6F);
  }
}

}  // namespace
}  // namespace limber
