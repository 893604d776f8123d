// Families, fine-tuning and measured errors of arms in space, on toy arms whose answer is known.
#include <cmath>

#include <gtest/gtest.h>

#include "limber/arm/space_pose.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/arm_gain.hpp"
#include "limber/training/adaptation.hpp"
#include "limber/training/arm_fit.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"
#include "training/space_toy_arm.hpp"

namespace limber {
namespace {

using testing_support::space_arm;
using testing_support::space_toy_episode;

constexpr int kArms = 14;

double bends_of(double share) {
  return 0.7 + 0.6 * share;
}

/// Arms that differ in how far their first segment bends, and a network of all of them.
class SpaceFamily : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    TrainingData data;
    for (int i = 0; i < kArms; ++i) {
      data.training.push_back(space_toy_episode(arm(), 400, static_cast<std::uint64_t>(i), 0,
                                                bends_of(double(i) / (kArms - 1))));
    }
    TrainingSettings settings = best_preset();
    set_family_size(settings, 1);
    settings.hidden_units = {40};
    settings.stages = {{2, 32, 40}, {8, 16, 60}, {24, 16, 60}};
    settings.jobs = 2;
    family_ = new CompensationModel(train(arm(), data, settings).model);
  }
  static void TearDownTestSuite() {
    delete family_;
    family_ = nullptr;
  }

  static const ArmDescription& arm() {
    static const ArmDescription arm = space_arm();
    return arm;
  }
  static const CompensationModel& family() { return *family_; }
  static std::vector<Episode> motions_of(double share, std::uint64_t seed, int frames = 600) {
    return {space_toy_episode(arm(), frames, seed, 0, bends_of(share))};
  }
  static AdaptationSettings without_weights() {
    AdaptationSettings settings;
    settings.weights = AdaptWeights::never;
    settings.jobs = 2;
    return settings;
  }

 private:
  static CompensationModel* family_;
};

CompensationModel* SpaceFamily::family_ = nullptr;

TEST_F(SpaceFamily, AnArmThatItHasNeverSeenIsFoundFromItsMotions) {
  ASSERT_TRUE(is_family(family()));
  EXPECT_FALSE(family().past_commands.empty());
  const CompensationModel middle =
      model_of_arm(family(), {"", Eigen::VectorXf::Zero(1), Eigen::MatrixXf::Identity(1, 1)});
  for (const double share : {0.12, 0.9}) {
    const Adaptation done = adapt(arm(), family(), motions_of(share, 100), without_weights());
    EXPECT_LT(done.fitted_error_m, 0.5 * done.middle_error_m) << share;
    const std::vector<Episode> others = motions_of(share, 200);
    EXPECT_LT(error_on_other_arms_m(arm(), done.model, others),
              0.5 * error_on_other_arms_m(arm(), middle, others))
        << share;
    ASSERT_TRUE(done.model.prediction_error);
    EXPECT_LE(done.model.prediction_error->off_path_m, done.model.prediction_error->max_position_m);
    EXPECT_FALSE(done.model.tube);
  }
}

TEST_F(SpaceFamily, TheVectorFollowsWhatTellsArmsApart) {
  std::vector<float> e;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    e.push_back(fit_arm(arm(), family(), motions_of(share, 300)).model.member_of_family->e[0]);
  }
  const bool rises = e.back() > e.front();
  EXPECT_TRUE(std::ranges::is_sorted(e, [&](float a, float b) { return rises ? a < b : a > b; }))
      << testing::PrintToString(e);
}

// The adapted file is that of a network whose hidden units have other gains and shifts.
TEST_F(SpaceFamily, TheAdaptedFileIsTheFamilyWithThatVectorInItsLayers) {
  const CompensationModel one =
      adapt(arm(), family(), motions_of(0.3, 400), without_weights()).model;
  const TemporaryFolder folder;
  write_model(folder.path() / "one.safetensors", one);
  const CompensationModel read = read_model_of_one_arm(folder.path() / "one.safetensors");
  EXPECT_EQ(read.shape(), family().shape());
  CompensationModel by_hand = family();
  for (Eigen::Index unit = 0; unit < by_hand.layers[0].bias.size(); ++unit) {
    const float e = read.member_of_family->e[0];
    const float g = by_hand.family->log_gains(unit, 0);
    const float gain = std::exp(log_arm_gain(g + by_hand.family->log_gains(unit, 1) * e)) /
                       std::exp(log_arm_gain(g));
    float& bias = by_hand.layers[0].bias[unit];
    bias = gain * (bias + by_hand.family->shifts(unit, 0) * e);
    by_hand.layers[0].weight.row(unit) *= gain;
  }
  for (std::size_t i = 0; i < by_hand.layers.size(); ++i) {
    EXPECT_TRUE(read.layers[i].weight.isApprox(by_hand.layers[i].weight, 1e-5F));
    EXPECT_TRUE(read.layers[i].bias.isApprox(by_hand.layers[i].bias, 1e-5F));
  }
}

// A sign that jumps, as foreign files have it, is made continuous where files are read.
TEST_F(SpaceFamily, SignsOfQuaternionsChangeNoFitAndNoError) {
  Recording recording = make_recording(arm(), "test", 1);
  recording.episodes = motions_of(0.6, 600);
  const TemporaryFolder folder;
  write_recording(folder.path() / "own.h5", recording);
  Episode& flipped = recording.episodes[0];
  for (int t = 0; t < flipped.frame_count(); ++t) {
    for (int plate = 0; plate < flipped.point_count(); ++plate) {
      if ((t / 7 + plate) % 2 == 0) {
        flipped.backbone.row(t).segment<4>(kSpacePoseSize * plate + 3) *= -1.0F;
      }
    }
  }
  write_recording(folder.path() / "foreign.h5", recording);
  const std::vector<Episode> own = read_recording(folder.path() / "own.h5").episodes;
  const std::vector<Episode> foreign = read_recording(folder.path() / "foreign.h5").episodes;
  EXPECT_EQ(foreign[0].backbone, own[0].backbone);
  EXPECT_EQ(fit_arm(arm(), family(), foreign).model.member_of_family->e,
            fit_arm(arm(), family(), own).model.member_of_family->e);
}

TEST_F(SpaceFamily, FineTuningGoesOnFromAModelInSpace) {
  CompensationModel start = adapt(arm(), family(), motions_of(0.5, 700), without_weights()).model;
  TrainingData data;
  data.training = {space_toy_episode(arm(), 1000, 701, 0, bends_of(1.5))};
  data.validation = {space_toy_episode(arm(), 300, 702, 0, bends_of(1.5))};
  TrainingSettings settings = fine_tuning_of(best_preset());
  settings.stages = {{16, 16, 60}};
  settings.jobs = 2;
  const TrainingResult tuned = fine_tune(arm(), data, settings, start);
  ASSERT_EQ(tuned.status, TrainingStatus::finished);
  EXPECT_EQ(tuned.model.past_commands, start.past_commands);
  const std::vector<Episode> unseen = {space_toy_episode(arm(), 600, 703, 0, bends_of(1.5))};
  const auto error_m = [&](const CompensationModel& model) {
    return measure_prediction_error(arm(), model, unseen)->max_position_m;
  };
  EXPECT_LT(error_m(tuned.model), 0.7 * error_m(start));
  const GapBounds& wide = *tuned.model.bounds;
  EXPECT_TRUE((wide.max_bend_rad.array() >= start.bounds->max_bend_rad.array()).all());
}

// A rotation that nobody measured has no error; places have.
TEST_F(SpaceFamily, OfLiftedRotationsNoHeadingIsMeasured) {
  CompensationModel one = adapt(arm(), family(), motions_of(0.5, 800), without_weights()).model;
  std::vector<Episode> unseen = motions_of(0.5, 801);
  unseen[0].lifted = true;
  note_unseen(arm(), one, unseen);
  ASSERT_TRUE(one.prediction_error);
  EXPECT_FALSE(one.prediction_error->end_orientation_rad);
  EXPECT_GT(one.prediction_error->end_position_m, 0.0);
  const TemporaryFolder folder;
  write_model(folder.path() / "one.safetensors", one);
  const CompensationModel read = read_model(folder.path() / "one.safetensors");
  EXPECT_FALSE(read.prediction_error->end_orientation_rad);
  EXPECT_EQ(read.prediction_error->end_position_m, one.prediction_error->end_position_m);
  EXPECT_EQ(to_text(*read.prediction_error).find("rad"), std::string::npos);
}

}  // namespace
}  // namespace limber
