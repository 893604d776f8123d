#include "src/lab/improve/run_roles.hpp"

#include <map>

#include <gtest/gtest.h>

#include "limber/network/untrained_model.hpp"
#include "limber/training/unseen_error.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

/// `frames` frames of an arm that begins straight and at rest, then moves; motions of 7 frames.
Episode moving(const ArmDescription& arm, int frames, float offset) {
  Episode episode;
  const Eigen::Index points = arm.point_count();
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) * arm.frame_period_s());
  episode.pressure_kpa = FrameMatrix::Zero(frames, arm.segment_count());
  episode.setpoint_kpa = FrameMatrix::Zero(frames, arm.segment_count());
  episode.backbone = FrameMatrix::Zero(frames, 3 * points);
  for (int t = 0; t < frames; ++t) {
    episode.setpoint_kpa(t, 0) = episode.pressure_kpa(t, 0) = static_cast<float>(t);
    for (Eigen::Index plate = 0; plate < points; ++plate) {
      episode.backbone(t, 3 * plate) = 0.04F * static_cast<float>(plate);
      episode.backbone(t, 3 * plate + 1) = offset * static_cast<float>(t * plate);
    }
    episode.motion_index.push_back(t / 7);
  }
  return episode;
}

TEST(RunRoles, OfTenRunsOneValidatesAndTwoAreHeldBack) {
  for (int first = 0; first < 30; first += 10) {
    std::map<RunRole, int> count;
    for (int k = first; k < first + 10; ++k) {
      ++count[role_of(k)];
    }
    EXPECT_EQ(count[RunRole::training], 7);
    EXPECT_EQ(count[RunRole::validation], 1);
    EXPECT_EQ(count[RunRole::held_back], 2);
  }
}

TEST(RunRoles, ThreeRunsHaveOneOfEach) {
  EXPECT_EQ(role_of(0), RunRole::training);
  EXPECT_EQ(role_of(1), RunRole::validation);
  EXPECT_EQ(role_of(2), RunRole::held_back);
}

// Each run's first set point of segment 1 is its mark; no mark may be in two places.
TEST(RunRoles, HeldBackRunsNeitherTrainNorChooseInAnyRound) {
  const ArmDescription arm = sample_arm(3);
  RoundData rounds;
  std::map<float, int> seen;
  float mark = 1.0F;
  for (int round = 0; round < 3; ++round) {
    for (const bool plans : {true, false}) {
      std::vector<Episode> episodes;
      for (int k = 0; k < 13; ++k) {
        episodes.push_back(moving(arm, 10, 0.0F));
        episodes.back().setpoint_kpa(0, 1) = mark++;
      }
      if (plans) {
        rounds.add_plans(episodes, arm.frame_period_s());
      } else {
        rounds.add_exploration(episodes);
      }
    }
  }
  for (const std::vector<Episode>* part :
       {&rounds.data.training, &rounds.data.validation, &rounds.data.unseen}) {
    for (const Episode& episode : *part) {
      ++seen[episode.setpoint_kpa(0, 1)];
    }
  }
  EXPECT_EQ(seen.size(), 3U * 2U * 13U);
  for (const auto& [run, times] : seen) {
    EXPECT_EQ(times, 1) << run;
  }
  EXPECT_TRUE(rounds.data.replay.empty());
}

TEST(RunRoles, RunsOfFiguresAreHeldBackAndNothingElse) {
  const ArmDescription arm = sample_arm(3);
  RoundData rounds;
  rounds.hold_back({moving(arm, 10, 0.0F), moving(arm, 12, 0.0F)}, {moving(arm, 30, 0.0F)},
                   arm.frame_period_s());
  EXPECT_EQ(rounds.data.unseen.size(), 3U);
  EXPECT_TRUE(rounds.data.training.empty());
  EXPECT_TRUE(rounds.data.validation.empty());
}

TEST(RunRoles, PlanFromRestKeepsItsFramesBehindStillOnes) {
  const ArmDescription arm = sample_arm(3);
  Episode plan = moving(arm, 20, 1e-3F);
  plan.tracked.assign(20, 1);
  plan.tracked[3] = 0;
  const Episode whole = as_motions_from_rest(plan, arm.frame_period_s());
  const int added = whole.frame_count() - plan.frame_count();
  ASSERT_GT(added, 0);
  for (int t = 0; t < added; ++t) {
    EXPECT_EQ(whole.backbone.row(t), plan.backbone.row(0));
    EXPECT_EQ(whole.setpoint_kpa.row(t), plan.setpoint_kpa.row(0));
  }
  EXPECT_EQ(whole.backbone.bottomRows(20), plan.backbone);
  EXPECT_EQ(whole.pressure_kpa.bottomRows(20), plan.pressure_kpa);
  EXPECT_FALSE(whole.was_tracked(added + 3));
  EXPECT_EQ(whole.untracked_count(), 1);
  for (int t = 1; t < whole.frame_count(); ++t) {
    EXPECT_NEAR(whole.time_s[t] - whole.time_s[t - 1], arm.frame_period_s(), 1e-9);
  }
}

// Two plans, after each of which the arm stands still: each is a run of the stored error, whatever
// its waypoints.
TEST(RunRoles, EachPlanOfAChainIsOneRunOfTheModelsError) {
  const ArmDescription arm = sample_arm(3);
  Episode chain = moving(arm, 21, 1e-3F);
  for (int t = 0; t < 21; ++t) {
    chain.motion_index[static_cast<std::size_t>(t)] = t / 11;
    if (t > 4 && t <= 10) {
      chain.backbone.row(t) = chain.backbone.row(4);
    }
  }
  std::vector<Episode> chains(13, as_motions_from_rest(chain, arm.frame_period_s()));
  const CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {8}, 1);
  const std::optional<PredictionError> error = measure_prediction_error(arm, model, chains, 1);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->runs, 26);
  EXPECT_NEAR(error->run_s, 10 * arm.frame_period_s(), 1e-9);
}

}  // namespace
}  // namespace limber
