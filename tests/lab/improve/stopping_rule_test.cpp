#include "src/lab/improve/stopping_rule.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr double kRounding = 1e-15;  // [m]

// Gains 0.01, 0.02, 0.03: mean 0.02, deviation 0.01, so the mean's standard error is 0.01 / √3.
TEST(StoppingRule, GainIsThePairedMeanWithItsStandardError) {
  const EndDistances before = {0.05, 0.05, 0.05, std::nullopt, 0.01};
  const EndDistances after = {0.04, 0.03, 0.02, 0.01, std::nullopt};
  const DistanceGain gain = gain_between(before, after);
  EXPECT_EQ(gain.pairs, 3);
  EXPECT_NEAR(gain.mean_m, 0.02, kRounding);
  EXPECT_NEAR(gain.standard_error_m, 0.01 / std::sqrt(3.0), kRounding);
  EXPECT_TRUE(gain.is_clear());
}

TEST(StoppingRule, GainTurnsItsSignWithTheOrder) {
  const EndDistances a = {0.05, 0.02, 0.03};
  const EndDistances b = {0.01, 0.04, 0.02};
  EXPECT_NEAR(gain_between(a, b).mean_m, -gain_between(b, a).mean_m, kRounding);
  EXPECT_NEAR(gain_between(a, b).standard_error_m, gain_between(b, a).standard_error_m, kRounding);
}

TEST(StoppingRule, OnePairOrNoneIsNeverAClearGain) {
  EXPECT_FALSE(gain_between({0.5}, {0.1}).is_clear());
  EXPECT_FALSE(gain_between({std::nullopt, 0.5}, {0.1, std::nullopt}).is_clear());
  EXPECT_EQ(gain_between({std::nullopt}, {0.1}).pairs, 0);
}

TEST(StoppingRule, GainWithinItsStandardErrorIsNotClear) {
  // Gains 0.03, −0.02: mean 0.005, standard error 0.025.
  EXPECT_FALSE(gain_between({0.05, 0.05}, {0.02, 0.07}).is_clear());
  EXPECT_FALSE(gain_between({0.05, 0.05}, {0.05, 0.05}).is_clear());
}

TEST(StoppingRule, FirstRoundAloneIsTheBest) {
  const RoundChoice choice = choose_round({{0.05, 0.04}});
  EXPECT_EQ(choice.best, 0);
  EXPECT_TRUE(choice.gains.empty());
  EXPECT_EQ(choice.rounds_without_gain, 0);
}

TEST(StoppingRule, ClearGainIsTheNewReference) {
  const RoundChoice choice = choose_round({{0.05, 0.05}, {0.03, 0.031}, {0.02, 0.021}});
  EXPECT_EQ(choice.best, 2);
  EXPECT_EQ(choice.references, (std::vector<int>{0, 1}));
  EXPECT_EQ(choice.rounds_without_gain, 0);
}

TEST(StoppingRule, CountsRoundsWithoutGainSinceTheLastClearOne) {
  const RoundChoice choice =
      choose_round({{0.05, 0.05}, {0.03, 0.031}, {0.04, 0.041}, {0.05, 0.06}});
  EXPECT_EQ(choice.best, 1);
  EXPECT_EQ(choice.rounds_without_gain, kMaxRoundsWithoutGain);
}

TEST(StoppingRule, SmallGainsAddUpOverTheSameReference) {
  // Over round 0: round 1 gains 0.004 ± 0.006, round 2 gains 0.015 ± 0.005.
  const RoundChoice choice = choose_round({{0.05, 0.05}, {0.040, 0.052}, {0.03, 0.04}});
  EXPECT_FALSE(choice.gains[0].is_clear());
  EXPECT_EQ(choice.references, (std::vector<int>{0, 0}));
  EXPECT_TRUE(choice.gains[1].is_clear());
  EXPECT_EQ(choice.rounds_without_gain, 0);
}

TEST(StoppingRule, KeepsTheNearestRoundEvenIfNoGainIsClear) {
  const RoundChoice choice = choose_round({{0.05, 0.05}, {0.040, 0.052}, {0.045, 0.054}});
  EXPECT_EQ(choice.best, 1);
  EXPECT_EQ(choice.rounds_without_gain, 2);
}

TEST(StoppingRule, WorseRoundsLeaveTheModelToStartFrom) {
  EXPECT_EQ(choose_round({{0.02, 0.03}, {0.04, 0.04}, {0.05, 0.03}}).best, 0);
}

}  // namespace
}  // namespace limber
