#include "src/training/training_tables.hpp"

#include <set>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/network/backbone_layout.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TrainingSettings settings_for(BackboneLayout layout, Scaling scaling,
                              OutputForm form = OutputForm::compensation) {
  TrainingSettings settings;
  settings.layout = layout;
  settings.scaling = scaling;
  settings.form = form;
  settings.reads_velocity = false;
  return settings;
}

constexpr float kRounding = 2e-4F;  // float32 through a subtraction of near numbers

TEST(TrainingTables, RangesFillZeroToOne) {
  const ArmDescription arm = three_segment_arm();
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 6, 20, 3)},
                           settings_for(BackboneLayout::base_poses, Scaling::unit_range));
  EXPECT_EQ(tables.input.scale.size(), 102);
  EXPECT_EQ(tables.output.scale.size(), 48);
  const Eigen::MatrixXf& state = tables.frames.state;
  EXPECT_NEAR(state.minCoeff(), 0.0F, kRounding);
  EXPECT_NEAR(state.maxCoeff(), 1.0F, kRounding);
  EXPECT_NEAR(tables.frames.pressure.row(1).maxCoeff(), 1.0F, kRounding);
}

// Of recorded and no-load poses together; an answer of 0 adds nothing to the no-load model.
TEST(TrainingTables, ASharedRangeLeavesTheNoLoadModelAtZero) {
  const ArmDescription arm = three_segment_arm();
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 6, 20, 3)},
                           settings_for(BackboneLayout::base_poses, Scaling::shared_range));
  EXPECT_TRUE(tables.output.offset.isZero(0.0F));
  EXPECT_EQ(tables.output.scale, tables.input.scale.tail(48));
  EXPECT_EQ(tables.input.scale.segment(6, 48), tables.input.scale.tail(48));
  EXPECT_EQ(tables.input.offset.segment(6, 48), tables.input.offset.tail(48));
  EXPECT_LT((tables.frames.uncompensated - tables.frames.no_load).lpNorm<Eigen::Infinity>(),
            kRounding);
  const float low = std::min(tables.frames.state.minCoeff(), tables.frames.no_load.minCoeff());
  const float high = std::max(tables.frames.state.maxCoeff(), tables.frames.no_load.maxCoeff());
  EXPECT_NEAR(low, 0.0F, kRounding);
  EXPECT_NEAR(high, 1.0F, kRounding);
}

TEST(TrainingTables, ARangeByUnitIsOneForAllPositionsAndOneForAllAngles) {
  const ArmDescription arm = three_segment_arm();
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 6, 20, 3)},
                           settings_for(BackboneLayout::base_poses, Scaling::range_by_unit));
  const Eigen::VectorXf scale = tables.input.scale.tail(48);
  for (Eigen::Index row = 3; row < 48; ++row) {
    EXPECT_EQ(scale[row], scale[row % 3 == 2 ? 2 : 0]);
  }
  EXPECT_NE(scale[0], scale[2]);
  EXPECT_EQ(tables.output.scale, scale);
  EXPECT_TRUE(tables.output.offset.isZero(0.0F));
  EXPECT_NEAR(std::max(tables.frames.state.maxCoeff(), tables.frames.no_load.maxCoeff()), 1.0F,
              kRounding);
  EXPECT_NEAR(std::min(tables.frames.state.minCoeff(), tables.frames.no_load.minCoeff()), 0.0F,
              kRounding);
}

// An error of 1 cm at a plate weighs as 1 cm, whatever the arm's range is there.
TEST(TrainingTables, ErrorsInUserUnitsAreMetresAndRadians) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = settings_for(BackboneLayout::base_poses, Scaling::unit_range);
  settings.form = OutputForm::compensation;
  const auto error_of_1_cm = [&] {
    TrainingTables tables = make_training_tables(arm, {toy_episode(arm, 6, 20, 3)}, settings);
    constexpr int kLanes = 64;  // at least those of any kernel
    Eigen::MatrixXf target = Eigen::MatrixXf::Zero(kLanes, 48);
    Eigen::MatrixXf state = target;
    state(0, 45) = 0.01F * tables.input.scale[6 + 45];
    const Eigen::VectorXf weight = Eigen::VectorXf::Unit(kLanes, 0);
    Eigen::MatrixXf gradient(kLanes, 48);
    return tables.map.error.compute(kLanes, state.data(), target.data(), weight.data(),
                                    gradient.data());
  };
  const float in_ranges = error_of_1_cm();
  settings.error_in_user_units = true;
  EXPECT_NEAR(error_of_1_cm(), 0.01F, 1e-6F);
  EXPECT_GT(in_ranges, 0.015F);
}

// The base plate never moves: its three columns are constant.
TEST(TrainingTables, ConstantColumnsKeepScaleOne) {
  const ArmDescription arm = three_segment_arm();
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 6, 20, 3)},
                           settings_for(BackboneLayout::base_poses, Scaling::unit_range));
  EXPECT_EQ(tables.output.scale.head(3), Eigen::Vector3f::Ones());
  EXPECT_TRUE(tables.frames.state.topRows(3).isZero());
  EXPECT_TRUE(tables.input.scale.allFinite());
}

TEST(TrainingTables, UnitSpreadHasMeanZeroAndDeviationOne) {
  const ArmDescription arm = three_segment_arm();
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 6, 20, 3)},
                           settings_for(BackboneLayout::gap_poses, Scaling::unit_spread));
  EXPECT_EQ(tables.input.scale.size(), 60);
  for (const Eigen::Index row : {2, 17, 44}) {
    const auto values = tables.frames.state.row(row).array();
    EXPECT_NEAR(values.mean(), 0.0F, kRounding);
    EXPECT_NEAR((values - values.mean()).square().mean(), 1.0F, kRounding);
  }
}

// The output that undoes normalisation exactly must lead back to the recorded backbone: (5).
TEST(TrainingTables, TheRightCompensationGivesTheRecordedState) {
  const ArmDescription arm = three_segment_arm();
  for (const auto kind : {BackboneLayout::base_poses, BackboneLayout::gap_poses}) {
    const Episode episode = toy_episode(arm, 6, 20, 3);
    const TrainingTables tables =
        make_training_tables(arm, {episode}, settings_for(kind, Scaling::unit_range));
    const NetworkLayout layout(kind, OutputForm::compensation, arm);
    const NoLoadModel no_load(arm);
    for (const int t : {0, 33, 100}) {
      Backbone unloaded(arm.point_count(), 3);
      no_load.backbone(episode.pressure_kpa.row(t).transpose(), unloaded);
      const Eigen::VectorXf prior = layout.encode(unloaded.reshaped<Eigen::RowMajor>());
      const Eigen::VectorXf recorded = layout.encode(episode.backbone.row(t).transpose());
      const Eigen::VectorXf output =
          (recorded - prior - tables.output.offset).cwiseProduct(tables.output.scale);
      const Eigen::VectorXf state =
          tables.frames.uncompensated.col(t) + tables.map.output_scale.cwiseProduct(output);
      EXPECT_LT((state - tables.frames.state.col(t)).lpNorm<Eigen::Infinity>(), kRounding);
    }
  }
}

// The change that was recorded, with the gate shut, must lead to the recorded backbone: (16).
TEST(TrainingTables, TheRightChangeGivesTheRecordedState) {
  const ArmDescription arm = three_segment_arm();
  const Episode episode = toy_episode(arm, 6, 20, 3);
  for (const Scaling scaling : {Scaling::unit_range, Scaling::unit_spread}) {
    const TrainingTables tables = make_training_tables(
        arm, {episode}, settings_for(BackboneLayout::gap_poses, scaling, OutputForm::gated_change));
    EXPECT_TRUE(tables.map.is_gated());
    EXPECT_EQ(tables.map.output_count(), 90);
    EXPECT_TRUE(tables.output.offset.isZero(0.0F));
    const NetworkLayout layout(BackboneLayout::gap_poses, OutputForm::gated_change, arm);
    const auto recorded = [&](int t) {
      return Eigen::VectorXf(layout.encode(episode.backbone.row(t).transpose()));
    };
    for (const int t : {1, 33, 100}) {
      const Eigen::VectorXf output =
          (recorded(t) - recorded(t - 1)).cwiseProduct(tables.output.scale);
      const Eigen::VectorXf state =
          tables.frames.state.col(t - 1) + tables.map.output_scale.cwiseProduct(output);
      EXPECT_LT((state - tables.frames.state.col(t)).lpNorm<Eigen::Infinity>(), kRounding);
    }
  }
}

// Where each episode begins nothing changed: its first frame does not follow the last one's last.
TEST(TrainingTables, ChangesDoNotReachFromEpisodeToEpisode) {
  const ArmDescription arm = three_segment_arm();
  const TrainingSettings settings =
      settings_for(BackboneLayout::gap_poses, Scaling::unit_range, OutputForm::gated_change);
  const Episode episode = toy_episode(arm, 6, 20, 3);
  const TrainingTables once = make_training_tables(arm, {episode}, settings);
  const TrainingTables twice = make_training_tables(arm, {episode, episode}, settings);
  EXPECT_EQ(once.output.scale, twice.output.scale);
}

TEST(TrainingTables, RefusesConstantPressures) {
  const ArmDescription arm = three_segment_arm();
  Episode still = toy_episode(arm, 2, 40, 3);
  still.pressure_kpa.setConstant(20.0F);
  EXPECT_THAT(
      [&] {
        make_training_tables(arm, {still},
                             settings_for(BackboneLayout::gap_poses, Scaling::unit_spread));
      },
      ThrowsMessage<InputError>(HasSubstr("no pressure changes in the training data (81 frames)")));
  EXPECT_THAT(
      [&] {
        make_training_tables(arm, {},
                             settings_for(BackboneLayout::gap_poses, Scaling::unit_spread));
      },
      ThrowsMessage<InputError>(HasSubstr("hold no frame")));
}

// A dropped frame is filled in between its neighbours: a guess, which must shape nothing.
// Behind the other inputs, not shifted: an arm that stands still has a change of 0.
TEST(TrainingTables, VelocitiesAreTheChangesOfTheFrameBefore) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = settings_for(BackboneLayout::gap_poses, Scaling::unit_spread);
  settings.reads_velocity = true;
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 6, 20, 3), toy_episode(arm, 6, 20, 4)}, settings);
  EXPECT_EQ(tables.input.scale.size(), 105);
  EXPECT_TRUE(tables.input.offset.tail(45).isZero(0.0F));
  const FrameTable<float>& frames = tables.frames;
  for (const EpisodeRange& episode : tables.episodes) {
    EXPECT_TRUE(frames.change.col(episode.first).isZero(0.0F)) << "nothing is known before";
    for (const int t : {1, 40, 100}) {
      const Eigen::VectorXf expected =
          tables.map.change_scale.array() *
          (frames.state.col(episode.first + t) - frames.state.col(episode.first + t - 1)).array();
      EXPECT_LT((frames.change.col(episode.first + t) - expected).lpNorm<Eigen::Infinity>(),
                10.0F * kRounding)
          << t;
    }
  }
  const auto tip = frames.change.row(43).array();
  EXPECT_NEAR((tip - tip.mean()).square().mean(), 1.0F, 0.05F);
}

TEST(TrainingTables, UntrackedFramesShapeNoRange) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = settings_for(BackboneLayout::gap_poses, Scaling::unit_spread);
  settings.reads_velocity = true;
  Episode dropped = toy_episode(arm, 6, 20, 3);
  dropped.tracked.assign(121, 1);
  dropped.tracked[30] = 0;
  const TrainingTables before = make_training_tables(arm, {dropped}, settings);
  dropped.backbone.row(30).setConstant(50.0F);
  const TrainingTables after = make_training_tables(arm, {dropped}, settings);
  EXPECT_EQ(before.input.scale, after.input.scale);
  EXPECT_EQ(before.output.offset, after.output.offset);
  EXPECT_EQ(after.frames.tracked[30], 0);
  EXPECT_EQ(after.frames.tracked[31], 1);
  dropped.tracked.assign(121, 0);
  EXPECT_THAT([&] { make_training_tables(arm, {dropped}, settings); },
              ThrowsMessage<InputError>(HasSubstr("tracked in none of the training data's 121")));
}

TEST(WindowStarts, AreFramesInWhichTheArmWasSeen) {
  std::vector<std::uint8_t> tracked(40, 1);
  tracked[0] = tracked[12] = tracked[13] = 0;
  const std::vector<EpisodeRange> episode = {{0, 40}};
  EXPECT_EQ(window_starts(episode, tracked, 4, 0),
            (std::vector<int>{1, 5, 9, 14, 18, 22, 26, 30, 34}));
  // Nothing is seen behind frame 20: no window has anything to learn there.
  std::fill(tracked.begin() + 21, tracked.end(), 0);
  EXPECT_EQ(window_starts(episode, tracked, 4, 0), (std::vector<int>{1, 5, 9, 14, 18}));
}

TEST(WindowStarts, DoNotOverlapAndStayInsideTheirEpisode) {
  const std::vector<EpisodeRange> episodes = {{0, 100}, {100, 20}, {120, 33}, {153, 65}};
  for (int shift = 0; shift < 32; ++shift) {
    std::set<int> predicted;
    for (const int start : window_starts(episodes, {}, 32, shift)) {
      for (int frame = start + 1; frame <= start + 32; ++frame) {
        EXPECT_TRUE(predicted.insert(frame).second) << "frame " << frame << ", shift " << shift;
      }
      bool inside = false;
      for (const EpisodeRange& episode : episodes) {
        inside |= start >= episode.first && start + 32 < episode.first + episode.count;
      }
      EXPECT_TRUE(inside) << start;
    }
    // An episode of exactly one window keeps it, whatever the shift.
    EXPECT_TRUE(predicted.contains(152));
  }
  EXPECT_EQ(window_starts(episodes, {}, 32, 0), (std::vector<int>{0, 32, 64, 120, 153, 185}));
}

}  // namespace
}  // namespace limber
