#include <gtest/gtest.h>

#include "limber/arm/space_no_load.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/random_stream.hpp"
#include "src/logs/clock_match.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

constexpr double kOffset_s = 3.7;  // to be added to the commands' times

/// Ramps between random pressures, and the unloaded arm behind two lags of 60 ms.
class SpaceClock : public ::testing::Test {
 protected:
  SpaceClock() {
    RandomStream random(7, 1);
    const int rows = 3000;
    const double period_s = 0.02;
    const Eigen::Index n = arm_.channel_count();
    commands_.measured = true;
    commands_.values.resize(rows, n);
    motion_.poses.resize(rows, kSpacePoseSize * arm_.point_count());
    motion_.tracked.assign(rows, true);
    motion_.bridged.assign(rows, false);
    const SpaceNoLoad no_load(arm_);
    Eigen::VectorXd goal = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd now = goal;
    Eigen::VectorXd first = goal;
    Eigen::VectorXd second = goal;
    Eigen::VectorXf poses(motion_.poses.cols());
    for (int t = 0; t < rows; ++t) {
      if (t % 60 == 0) {
        goal = Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(0.0, 90.0); });
      }
      now += (goal - now).cwiseMax(-2.0).cwiseMin(2.0);
      first += (1.0 - std::exp(-period_s / 0.06)) * (now - first);
      second += (1.0 - std::exp(-period_s / 0.06)) * (first - second);
      no_load.poses(second, poses);
      motion_.poses.row(t) = poses.transpose().cast<double>();
      commands_.values.row(t) = now.transpose();
      commands_.time_s.push_back(period_s * t);
      motion_.time_s.push_back(period_s * t + kOffset_s);
    }
  }

  ArmDescription arm_ = testing_support::space_arm();
  BackboneTrack motion_;
  CommandTrack commands_;
};

TEST_F(SpaceClock, IsFoundFromBends) {
  const ClockMatch match = match_clocks(motion_, commands_, arm_);
  EXPECT_TRUE(match.is_decisive());
  EXPECT_NEAR(match.offset_s, kOffset_s, 0.03);
  EXPECT_GT(match.correlation, 0.95);
}

TEST_F(SpaceClock, IsFoundWhereNobodyKnowsWhatChambersDo) {
  arm_.no_load = NoLoadKind::straight;
  const ClockMatch match = match_clocks(motion_, commands_, arm_);
  EXPECT_TRUE(match.is_decisive());
  EXPECT_NEAR(match.offset_s, kOffset_s, 0.15);  // the arm's lag is in it
}

// Rows where they change alone, seconds apart: the arm's lag behind each is no offset.
TEST_F(SpaceClock, IsFoundFromSetPointsThatAreLoggedOnChange) {
  constexpr int kHold = 60;       // rows of motion
  constexpr int kFineSteps = 20;  // between these, so that the lags are as of an arm
  RandomStream random(11, 1);
  const Eigen::Index n = arm_.channel_count();
  const SpaceNoLoad no_load(arm_);
  const double open = 1.0 - std::exp(-0.02 / kFineSteps / 0.06);
  Eigen::VectorXd first = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd second = first;
  Eigen::VectorXf poses(motion_.poses.cols());
  const Eigen::Index rows = motion_.poses.rows();
  commands_ = {};
  commands_.measured = false;
  commands_.values.resize(rows / kHold, n);
  for (Eigen::Index t = 0; t < rows; ++t) {
    no_load.poses(second, poses);
    motion_.poses.row(t) = poses.transpose().cast<double>();
    if (t % kHold == 0) {
      commands_.values.row(t / kHold) =
          Eigen::RowVectorXd::NullaryExpr(n, [&] { return random.uniform(0.0, 90.0); });
      commands_.time_s.push_back(0.02 * double(t));
    }
    for (int fine = 0; fine < kFineSteps; ++fine) {
      first += open * (commands_.values.row(t / kHold).transpose() - first);
      second += open * (first - second);
    }
  }
  const ClockMatch match = match_clocks(motion_, commands_, arm_);
  EXPECT_TRUE(match.is_decisive());
  EXPECT_NEAR(match.offset_s, kOffset_s, 0.02);
  EXPECT_NEAR(match.lag_s, 0.06, 0.02 + 1e-9);
}

TEST_F(SpaceClock, IsNoneOfChambersOnTheirOtherSides) {
  const Eigen::MatrixXd values = commands_.values;
  commands_.values.setConstant(90.0);
  commands_.values -= values;
  EXPECT_FALSE(match_clocks(motion_, commands_, arm_).is_decisive());
}

TEST_F(SpaceClock, IsFoundBesideRowsThatNobodySaw) {
  for (int t = 0; t < 3000; t += 7) {
    motion_.poses.row(t).setConstant(std::nan(""));
  }
  const ClockMatch match = match_clocks(motion_, commands_, arm_);
  EXPECT_TRUE(match.is_decisive());
  EXPECT_NEAR(match.offset_s, kOffset_s, 0.03);
}

}  // namespace
}  // namespace limber
