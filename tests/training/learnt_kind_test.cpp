// Measured pressures or set points: what a network learnt from decides what it may be asked with.
#include "src/training/learnt_kind.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/unseen_error.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class LearntKind : public testing::Test {
 protected:
  LearntKind() {
    settings_.hidden_units = {8};
    settings_.stages = {{2, 32, 3}};
  }

  CompensationModel trained(const std::vector<Episode>& episodes) const {
    return train(arm_, {episodes, {}, {}}, settings_).model;
  }

  const ArmDescription arm_ = three_segment_arm();
  const std::vector<Episode> measured_ = {toy_episode(arm_, 6, 20, 1), toy_episode(arm_, 6, 20, 2)};
  const std::vector<Episode> setpoints_ = with_setpoints_only(measured_);
  TrainingSettings settings_ = best_preset();
};

TEST_F(LearntKind, IsStoredWithTheModelAndItsMembers) {
  EXPECT_FALSE(trained(measured_).learnt_from_setpoints);
  settings_.ensemble = 2;
  const CompensationModel model = trained(setpoints_);
  EXPECT_TRUE(model.learnt_from_setpoints);
  EXPECT_TRUE(model.member(1).learnt_from_setpoints);
}

// The network sees the set points: the same as those of a recording that measured them.
TEST_F(LearntKind, OfSetPointsLearnsFromSetPoints) {
  std::vector<Episode> said = measured_;
  for (Episode& episode : said) {
    episode.pressure_kpa = episode.setpoint_kpa;
  }
  const CompensationModel a = trained(setpoints_);
  const CompensationModel b = trained(said);
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    EXPECT_EQ(a.layers[l].weight, b.layers[l].weight);
  }
}

TEST_F(LearntKind, IsOneInATraining) {
  const auto refuses = [&](const TrainingData& data) {
    EXPECT_THAT([&] { (void)train(arm_, data, settings_); },
                ThrowsMessage<InputError>(HasSubstr("a network learns from one kind")));
  };
  refuses({{measured_[0], setpoints_[1]}, {}, {}});
  refuses({measured_, setpoints_, {}});
  refuses({setpoints_, {}, measured_});
  refuses({setpoints_, {}, {}, measured_});
}

TEST_F(LearntKind, IsKeptByFineTuning) {
  const TrainingSettings tuning = fine_tuning_of(settings_);
  const CompensationModel model = trained(setpoints_);
  EXPECT_TRUE(fine_tune(arm_, {setpoints_, {}, {}}, tuning, model).model.learnt_from_setpoints);
  EXPECT_THAT(
      [&] {
        (void)fine_tune(arm_, {measured_, {}, {}}, tuning, model);
      },
      ThrowsMessage<InputError>(HasSubstr("the network learnt from set points alone")));
  EXPECT_THAT(
      [&] {
        (void)fine_tune(arm_, {setpoints_, {}, {}}, tuning, trained(measured_));
      },
      ThrowsMessage<InputError>(HasSubstr("the network learnt from what was measured")));
}

TEST_F(LearntKind, DecidesWhatPredictionsAreMadeFrom) {
  const ForwardModel of_setpoints(arm_, trained(setpoints_));
  const ForwardModel of_measured(arm_, trained(measured_));
  EXPECT_NO_THROW((void)evaluate(ForwardModel(arm_), &of_setpoints, setpoints_));
  EXPECT_THAT([&] { (void)evaluate(ForwardModel(arm_), &of_setpoints, measured_); },
              ThrowsMessage<InputError>(HasSubstr("with_setpoints_only")));
  EXPECT_THAT([&] { (void)predict(of_measured, setpoints_, Restart::every_frame); },
              ThrowsMessage<InputError>(HasSubstr("as measured")));
}

// The model's error on unseen motions is that under the same commands, whatever else was recorded.
TEST_F(LearntKind, LeavesTheErrorOnUnseenMotionsAsItIs) {
  const CompensationModel model = trained(setpoints_);
  const auto a = measure_prediction_error(arm_, model, setpoints_);
  const auto b = measure_prediction_error(arm_, model, measured_);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->max_position_m, b->max_position_m);
}

}  // namespace
}  // namespace limber
