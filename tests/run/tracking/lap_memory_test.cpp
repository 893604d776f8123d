#include "limber/run/lap_memory.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr int kFrames = 100;

Eigen::Vector2d bump(int frame) {
  const double turn = 2.0 * M_PI * frame / kFrames;
  return {0.01 * std::sin(turn), -0.005 * std::cos(turn)};
}

/// Root mean square of what is left in each lap, of an error that is the same in all but for the
/// shift.
std::vector<double> rms_of_laps(double share, int laps) {
  LapMemory memory(kFrames, share);
  std::vector<double> result;
  for (int lap = 0; lap < laps; ++lap) {
    double squares = 0.0;
    for (int k = 0; k < kFrames; ++k) {
      const int frame = lap * kFrames + k;
      const Eigen::Vector2d error = bump(k) - memory.shift_m(frame);
      squares += error.squaredNorm();
      memory.learn(frame, error);
    }
    result.push_back(std::sqrt(squares / kFrames));
  }
  return result;
}

TEST(LapMemory, LeavesLessOfAnErrorThatComesAgainInEachLap) {
  const std::vector<double> rms = rms_of_laps(0.5, 6);
  for (std::size_t lap = 1; lap < rms.size(); ++lap) {
    EXPECT_NEAR(rms[lap], 0.5 * rms[lap - 1], 0.01 * rms[0]) << lap;
  }
}

TEST(LapMemory, TheFirstLapIsAsItIsAndAShareOfZeroLearnsNothing) {
  const std::vector<double> rms = rms_of_laps(0.0, 3);
  EXPECT_EQ(rms[0], rms_of_laps(0.5, 1)[0]);
  EXPECT_EQ(rms[2], rms[0]);
}

TEST(LapMemory, AHorizonThatLooksIntoTheNextLapSeesWhatThisOneLearnt) {
  LapMemory memory(kFrames, 1.0);
  for (int frame = 0; frame < kFrames; ++frame) {
    memory.learn(frame, {0.002, 0.0});
  }
  EXPECT_EQ(memory.shift_m(kFrames - 1).x(), 0.0);
  EXPECT_NEAR(memory.shift_m(kFrames + 1).x(), 0.002, 1e-12);
}

TEST(LapMemory, ShiftsAreBounded) {
  LapMemory memory(kFrames, 1.0);
  for (int frame = 0; frame < 50 * kFrames; ++frame) {
    memory.learn(frame, {0.01, 0.0});
  }
  EXPECT_LE(memory.shift_m(50 * kFrames).norm(), 0.03 + 1e-12);
}

}  // namespace
}  // namespace limber
