#include "src/lab/improve/round_training.hpp"

#include <gtest/gtest.h>

namespace limber {
namespace {

PredictionError error_of(int runs, double metres) {
  PredictionError error;
  error.runs = runs;
  error.run_s = 3.0;
  error.max_position_m = error.off_path_m = error.end_position_m = metres;
  error.end_orientation_rad = metres;
  return error;
}

TEST(RoundTraining, EnoughRunsReplaceTheErrorThatWasKnown) {
  const PredictionError measured = error_of(kMinRunsForError, 0.01);
  EXPECT_EQ(kept_error(error_of(99, 0.04), measured), measured);
}

TEST(RoundTraining, FewRunsCanOnlyWidenTheErrorThatWasKnown) {
  const PredictionError known = error_of(99, 0.04);
  EXPECT_EQ(kept_error(known, error_of(kMinRunsForError - 1, 0.01)), known);
  const PredictionError wider = kept_error(known, error_of(3, 0.05)).value();
  EXPECT_EQ(wider.max_position_m, 0.05);
  EXPECT_EQ(wider.runs, 99);
}

TEST(RoundTraining, WhatIsKnownStaysIfNothingCanBeMeasured) {
  EXPECT_EQ(kept_error(error_of(99, 0.04), std::nullopt), error_of(99, 0.04));
  EXPECT_EQ(kept_error(std::nullopt, error_of(3, 0.02)), error_of(3, 0.02));
  EXPECT_FALSE(kept_error(std::nullopt, std::nullopt));
}

TEST(RoundTraining, TrainingFromTheStartLearnsFromWhatWouldBeReplayed) {
  TrainingData data;
  data.replay.resize(12);
  data.training.resize(3);
  data.unseen.resize(2);
  const TrainingData all = with_replay_as_data(data);
  EXPECT_EQ(all.training.size(), 3U + 10U);
  EXPECT_EQ(all.validation.size(), 2U);  // of ten one, from the second on
  EXPECT_EQ(all.unseen.size(), 2U);
  EXPECT_TRUE(all.replay.empty());
}

}  // namespace
}  // namespace limber
