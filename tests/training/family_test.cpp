#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/training/adaptation.hpp"
#include "limber/training/arm_fit.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "support/temporary_folder.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr float kLeastPlayKpa = 5.0F;
constexpr float kMostPlayKpa = 45.0F;

/// Toy arms that differ in their play alone, and a network of all of them.
class FamilyOfPlays : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    constexpr int kArms = 24;
    TrainingData data;
    for (int i = 0; i < kArms; ++i) {
      const float play =
          kLeastPlayKpa + (kMostPlayKpa - kLeastPlayKpa) * static_cast<float>(i) / (kArms - 1);
      data.training.push_back(toy_episode(arm(), 24, 20, static_cast<std::uint64_t>(i), play));
    }
    TrainingSettings settings = best_preset();
    settings.family_size = 1;
    settings.hidden_units = {32, 32};
    settings.stages = {{2, 32, 60}, {8, 16, 80}, {32, 16, 80}};
    result_ = new TrainingResult(train(arm(), data, settings));
  }
  static void TearDownTestSuite() {
    delete result_;
    result_ = nullptr;
  }

  static const ArmDescription& arm() {
    static const ArmDescription arm = three_segment_arm();
    return arm;
  }
  static const TrainingResult& result() { return *result_; }
  static const CompensationModel& family() { return result_->model; }
  static std::vector<Episode> motions_of(float play_kpa, int motions, std::uint64_t seed) {
    return {toy_episode(arm(), motions, 20, seed, play_kpa)};
  }
  static ArmFit fit_to(float play_kpa, int motions, std::uint64_t seed) {
    return fit_arm(arm(), family(), motions_of(play_kpa, motions, seed));
  }
  static double spread(const CompensationModel& model) {
    return static_cast<double>(model.member_of_family->covariance.trace());
  }

 private:
  static TrainingResult* result_;
};

TrainingResult* FamilyOfPlays::result_ = nullptr;

TEST_F(FamilyOfPlays, ItsArmsHaveMeanZeroAndUnitCovariance) {
  ASSERT_EQ(result().status, TrainingStatus::finished);
  ASSERT_TRUE(is_family(family()));
  const Eigen::MatrixXf& arms = family().family->arms;
  ASSERT_EQ(arms.cols(), 24);
  EXPECT_LT(arms.rowwise().mean().norm(), 1e-4F);
  const Eigen::MatrixXf covariance = arms * arms.transpose() / 24.0F;
  EXPECT_LT((covariance - Eigen::MatrixXf::Identity(1, 1)).norm(), 1e-2F);
}

TEST_F(FamilyOfPlays, FoldsAnArmItSawIntoAnOrdinaryNetworkOfTheSameSize) {
  const CompensationModel one =
      model_of_arm(family(), {"", family().family->arms.col(3), Eigen::MatrixXf::Identity(1, 1)});
  EXPECT_FALSE(is_family(one));
  EXPECT_EQ(one.shape(), family().shape());
  EXPECT_LT((family_of(one).layers[0].bias - family().layers[0].bias).norm(), 1e-5F);
}

TEST_F(FamilyOfPlays, AnArmThatItHasNeverSeenIsFoundFromItsMotions) {
  for (const float play : {9.0F, 41.0F}) {
    const ArmFit fit = fit_to(play, 6, 100);
    const std::vector<Episode> others = motions_of(play, 20, 200);
    const CompensationModel middle =
        model_of_arm(family(), {"", Eigen::VectorXf::Zero(1), Eigen::MatrixXf::Identity(1, 1)});
    EXPECT_LT(error_on_other_arms_m(arm(), fit.model, others),
              0.6 * error_on_other_arms_m(arm(), middle, others))
        << play;
  }
}

// The play is all that tells these arms apart, so one number that rises with it, or falls.
TEST_F(FamilyOfPlays, TheVectorFollowsWhatTellsArmsApart) {
  std::vector<float> e;
  for (const float play : {8.0F, 17.0F, 26.0F, 35.0F, 44.0F}) {
    e.push_back(fit_to(play, 10, 300).model.member_of_family->e[0]);
  }
  const bool rises = e.back() > e.front();
  EXPECT_TRUE(std::ranges::is_sorted(e, [&](float a, float b) { return rises ? a < b : a > b; }))
      << testing::PrintToString(e);
}

TEST_F(FamilyOfPlays, MoreMotionsLeaveLessOfTheFamilysSpread) {
  const double little = spread(fit_to(20.0F, 2, 400).model);
  const double much = spread(fit_to(20.0F, 20, 400).model);
  EXPECT_LT(little, 1.0) << "1 is the family's own";
  EXPECT_LT(much, little);
}

TEST_F(FamilyOfPlays, ARestTellsNothing) {
  Episode rest = toy_episode(arm(), 4, 20, 1, 20.0F);
  rest.pressure_kpa.setZero();
  for (int t = 1; t < rest.frame_count(); ++t) {
    rest.backbone.row(t) = rest.backbone.row(0);
  }
  EXPECT_TRUE(adapt(arm(), family(), {rest}).tells_too_little());
}

TEST_F(FamilyOfPlays, AMotionIsAsLongWhereEverySecondFrameWasTracked) {
  AdaptationSettings settings;
  settings.measures_errors = false;
  std::vector<Episode> minute = motions_of(20.0F, 12, 500);
  const double moving_s = adapt(arm(), family(), minute, settings).moving_s;
  for (int t = 0; t < minute.front().frame_count(); ++t) {
    minute.front().tracked.push_back(t % 2 == 0 ? 1 : 0);
  }
  constexpr double kFrameOfEachMotion_s = 12 * 0.05;  // its ends lie between tracked frames
  EXPECT_GT(moving_s, Adaptation::kLeastMovingS);
  EXPECT_NEAR(adapt(arm(), family(), minute, settings).moving_s, moving_s,
              2.0 * kFrameOfEachMotion_s);
}

TEST_F(FamilyOfPlays, AdaptIsTheSameForAnyNumberOfThreads) {
  const std::vector<Episode> minute = motions_of(30.0F, 12, 500);
  AdaptationSettings settings;
  settings.weights = AdaptWeights::never;
  settings.jobs = 1;
  const Adaptation one = adapt(arm(), family(), minute, settings);
  settings.jobs = 3;
  const Adaptation three = adapt(arm(), family(), minute, settings);
  EXPECT_EQ(one.model.layers[0].bias, three.model.layers[0].bias);
  EXPECT_EQ(one.fitted_error_m, three.fitted_error_m);
  EXPECT_LT(one.fitted_error_m, one.middle_error_m);
  EXPECT_TRUE(one.model.prediction_error);
}

// A network's shapes are a little off those of every arm: that is no reason to warn of plans.
TEST_F(FamilyOfPlays, ShapesThatTheAdaptedNetworkPredictsAreNotNovelToIt) {
  CompensationModel with_region = family();
  const Episode minute = motions_of(20.0F, 40, 710).front();
  with_region.learnt = learnt_region_of(
      TrainingData{{motions_of(10.0F, 100, 708).front(), motions_of(40.0F, 100, 709).front()}, {}});
  const Episode other = motions_of(20.0F, 40, 711).front();
  AdaptationSettings settings;
  settings.weights = AdaptWeights::never;
  const CompensationModel adapted = adapt(arm(), with_region, {minute}, settings).model;
  const FrameMatrix predicted =
      predict(ForwardModel(arm(), adapted), other, Restart::at_the_start_only);
  const auto novel_share = [&](const LearntRegion& region) {
    int novel = 0;
    for (int t = 1; t < other.frame_count(); ++t) {
      const double novelty =
          region.novelty(other.pressure_kpa.row(t).transpose(), backbone_at(predicted, t),
                         other.pressure_kpa.row(t - 1).transpose(), backbone_at(predicted, t - 1));
      novel += novelty > 1.0 ? 1 : 0;
    }
    return static_cast<double>(novel) / other.frame_count();
  };
  const double before = novel_share(*with_region.learnt);
  EXPECT_GT(before, 0.1);
  EXPECT_LT(novel_share(*adapted.learnt), 0.3 * before);
}

TEST_F(FamilyOfPlays, ItsTubeIsWiderForAnArmThatItPredictsWorse) {
  CompensationModel with_tube = family();
  with_tube.tube.emplace();
  with_tube.tube->plate_scale_m.assign(static_cast<std::size_t>(arm().point_count()), 0.01);
  with_tube.tube->end_scale_m = 0.02;
  with_tube.tube->end_heading_scale_rad = 0.1;
  with_tube.tube->levels.push_back({0.95, 1.2, 100, 1, 0.95});
  constexpr double kUsualM = 0.005;
  note_expected_error_of_tube(with_tube, kUsualM);
  AdaptationSettings settings;
  settings.weights = AdaptWeights::never;
  const Adaptation inside = adapt(arm(), with_tube, motions_of(20.0F, 30, 700), settings);
  std::vector<Episode> weak = motions_of(20.0F, 30, 700);
  weak.front().pressure_kpa *= 1.5F;  // as if it bent less than any arm of the family
  const Adaptation outside = adapt(arm(), with_tube, weak, settings);
  EXPECT_GT(outside.expected_error_m, 1.5 * inside.expected_error_m);
  EXPECT_GE(inside.expected_error_m, 0.5 * inside.fitted_error_m);
  for (const Adaptation& done : {inside, outside}) {
    ASSERT_TRUE(done.model.tube);
    EXPECT_NEAR(done.model.tube->end_scale_m, 0.02 * done.expected_error_m / kUsualM, 1e-12);
    EXPECT_NEAR(done.model.tube->plate_scale_m[3], 0.01 * done.expected_error_m / kUsualM, 1e-12);
  }
  EXPECT_FALSE(adapt(arm(), family(), motions_of(20.0F, 2, 700), settings).model.tube);
}

TEST_F(FamilyOfPlays, AnArmOutsideGetsWeightsOfItsOwnWhereThatIsBetter) {
  const Adaptation done = adapt(arm(), family(), motions_of(90.0F, 30, 600));
  EXPECT_FALSE(done.is_of_family());
  ASSERT_FALSE(std::isnan(done.trained_error_m)) << "weights were tried";
  constexpr double kWorthIt = 0.9;
  EXPECT_EQ(done.has_trained_weights, done.trained_error_m < kWorthIt * done.fitted_error_m);
  EXPECT_FALSE(is_family(done.model));
}

// Weights learn from windows of 32 frames behind another.
TEST_F(FamilyOfPlays, AnArmOutsideKeepsItsVectorAloneWhereEpisodesAreTooShortForWeights) {
  const Episode whole = motions_of(90.0F, 30, 600).front();
  std::vector<Episode> parts;
  for (int first = 0; first + 32 <= whole.frame_count(); first += 32) {
    parts.push_back(slice(whole, first, 32));
  }
  const Adaptation done = adapt(arm(), family(), parts);
  EXPECT_GT(done.distance, Adaptation::kFarFromFamily);
  EXPECT_GT(done.held_back_s, 0.0);
  EXPECT_TRUE(std::isnan(done.trained_error_m));
  EXPECT_FALSE(done.has_trained_weights);
}

TEST_F(FamilyOfPlays, NothingIsHeldBackWhereTheArmWasTrackedAtTheEndAlone) {
  Episode late = motions_of(20.0F, 12, 500).front();
  const auto frames = static_cast<std::size_t>(late.frame_count());
  late.tracked.assign(frames, 0);
  std::fill(late.tracked.end() - 45, late.tracked.end(), std::uint8_t{1});  // a fifth is 48
  const Adaptation done = adapt(arm(), family(), {late});
  EXPECT_EQ(done.held_back_s, 0.0);
  EXPECT_TRUE(std::isnan(done.fitted_error_m));
  EXPECT_FALSE(done.has_trained_weights);
}

TEST_F(FamilyOfPlays, IsRefusedWhereOneArmIsAskedFor) {
  EXPECT_THAT([&] { require_one_arm(family(), "family.safetensors"); },
              ThrowsMessage<InputError>(HasSubstr("limber adapt --model family.safetensors")));
  CompensationModel ordinary = family();
  ordinary.family.reset();
  EXPECT_THAT([&] { (void)adapt(arm(), ordinary, motions_of(20.0F, 4, 1)); },
              ThrowsMessage<InputError>(HasSubstr("limber family")));
}

TEST_F(FamilyOfPlays, FineTuningMakesNoFamily) {
  const CompensationModel start = fit_to(20.0F, 4, 1).model;
  TrainingSettings settings = best_preset();
  settings.family_size = 2;
  EXPECT_THAT(
      [&] {
        (void)fine_tune(arm(), {motions_of(20.0F, 4, 1), {}}, settings, start);
      },
      ThrowsMessage<InputError>(HasSubstr("family_size = 2; expected 0")));
}

// As a camera that finds the arm late records it: one tracked frame predicts nothing to fit to.
TEST_F(FamilyOfPlays, AnArmThatWasSeenTooLateIsLeftOutOfTheMean) {
  std::vector<Episode> episodes = motions_of(20.0F, 6, 900);
  const double error_m = error_on_other_arms_m(arm(), family(), episodes);
  Episode late = motions_of(20.0F, 6, 901).front();
  late.tracked.assign(static_cast<std::size_t>(late.frame_count()), 1);
  std::fill_n(late.tracked.begin() + 1, late.frame_count() / 2, std::uint8_t{0});
  episodes.push_back(late);
  EXPECT_EQ(error_on_other_arms_m(arm(), family(), episodes), error_m);
  EXPECT_TRUE(tells_of_other_arms(episodes));
  EXPECT_FALSE(tells_of_other_arms({late}));
}

TEST_F(FamilyOfPlays, AModelThatRunsOffOnAnArmIsNotJudgedByTheOthers) {
  CompensationModel model = fit_to(20.0F, 4, 1).model;
  model.bounds.reset();
  model.layers.back().weight *= 1e18F;
  model.layers.back().bias.setConstant(1e18F);
  EXPECT_TRUE(std::isinf(error_on_other_arms_m(arm(), model, motions_of(20.0F, 6, 900))));
}

// Arms held back are fitted for long: a run stopped meanwhile keeps what it has, and goes on.
TEST(TrainFamily, StopsWithinAValidationAndGoesOnToTheSameBits) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingData data;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    data.training.push_back(toy_episode(arm, 4, 20, seed, 10.0F * static_cast<float>(seed)));
  }
  data.validation = {toy_episode(arm, 4, 20, 9, 25.0F)};
  TrainingSettings settings = best_preset();
  settings.family_size = 1;
  settings.hidden_units = {8};
  settings.stages = {{8, 16, 4}};
  settings.validation_interval = 2;
  const TrainingResult unbroken = train(arm, data, settings);
  settings.checkpoint = folder.path() / "run.checkpoint";
  settings.checkpoint_interval_s = 1e6;
  std::atomic<bool> stop = false;
  int epochs = 0;
  TrainingHooks hooks;
  hooks.on_epoch = [&](const LearningCurvePoint&) { ++epochs; };
  hooks.should_stop = [&] {
    stop = epochs == 3;  // seen behind the epoch, where it is validated
    return false;
  };
  {
    const StopScope scope(&stop);
    const TrainingResult stopped = train(arm, data, settings, hooks);
    EXPECT_EQ(stopped.status, TrainingStatus::interrupted);
    EXPECT_EQ(stopped.best_epoch, 2);
    EXPECT_EQ(stopped.curve.size(), 4U);
  }
  settings.resume = true;
  const TrainingResult resumed = train(arm, data, settings);
  ASSERT_EQ(resumed.status, TrainingStatus::finished);
  EXPECT_EQ(resumed.best_epoch, unbroken.best_epoch);
  EXPECT_EQ(resumed.model.layers[0].weight, unbroken.model.layers[0].weight);
  EXPECT_EQ(resumed.curve[3].validation_position_error_cm,
            unbroken.curve[3].validation_position_error_cm);
}

TEST(HoldBackArms, WholeArmsGo) {
  std::vector<Episode> episodes;
  std::vector<int> arms;
  for (int i = 0; i < 40; ++i) {
    episodes.push_back(toy_episode(three_segment_arm(), 1, 10, 1));
    arms.push_back(100 + i / 2);  // 20 arms of two episodes each
  }
  const TrainingData data = hold_back_arms(episodes, arms, 0.1, 1);
  ASSERT_EQ(data.held_back.size(), 4U);
  EXPECT_EQ(data.validation.size(), 4U);
  EXPECT_EQ(data.arms.size(), 36U);
  EXPECT_EQ(*std::ranges::max_element(data.arms), 17);
  for (std::size_t i = 0; i < 4; i += 2) {
    EXPECT_EQ(data.held_back[i] % 2, 0);
    EXPECT_EQ(data.held_back[i + 1], data.held_back[i] + 1) << "of the same arm";
  }
  EXPECT_TRUE(hold_back_arms({episodes.begin(), episodes.begin() + 18},
                             {arms.begin(), arms.begin() + 18}, 0.1, 1)
                  .validation.empty())
      << "nine arms are too few";
}

TEST(AddMirroredArms, EveryArmGetsAnImageThatDoesWhatItDoesLeftForRight) {
  const ArmDescription arm = three_segment_arm();
  TrainingData data;
  data.training = {toy_episode(arm, 1, 10, 1), toy_episode(arm, 1, 10, 2),
                   toy_episode(arm, 1, 10, 3)};
  data.arms = {0, 0, 1};
  add_mirrored_arms(arm, data);
  EXPECT_EQ(data.arms, (std::vector{0, 0, 1, 2, 2, 3}));
  ASSERT_EQ(data.training.size(), 6U);
  const Episode& one = data.training[2];
  const Episode& image = data.training[5];
  EXPECT_EQ(image.pressure_kpa, -one.pressure_kpa);
  EXPECT_EQ(image.setpoint_kpa, -one.setpoint_kpa);
  for (int t = 0; t < one.frame_count(); ++t) {
    Backbone expected = backbone_at(one.backbone, t);
    expected.rightCols(2) *= -1.0F;
    EXPECT_EQ(backbone_at(image.backbone, t), expected);
  }
}

TEST(AddMirroredArms, NoneWhereTheImageWouldExceedTheLimits) {
  ArmDescription arm = three_segment_arm();
  TrainingData data;
  data.training = {toy_episode(arm, 1, 10, 1)};
  data.arms = {0};
  arm.segments[1].pressure_limit_kpa = {-50.0, 100.0};
  add_mirrored_arms(arm, data);
  EXPECT_EQ(data.training.size(), 1U);
  EXPECT_EQ(data.arms.size(), 1U);
}

}  // namespace
}  // namespace limber
