#include "limber/run/lap_posture.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/pressure_box.hpp"
#include "src/run/tracking/lap_fit.hpp"
#include "support/bending_arms.hpp"

namespace limber {
namespace {

/// A circle of 8 cm radius, 0.57 m from the base, in 10 s.
TipPath circle(int laps) {
  TipPath path;
  for (int k = 0; k <= 200; ++k) {
    const double turn = 2.0 * M_PI * k / 200.0;
    path.time_s.push_back(0.05 * k);
    path.point_m.emplace_back(0.57 + 0.08 * std::cos(turn), 0.08 * std::sin(turn));
  }
  path.point_m.back() = path.point_m.front();
  path.laps = laps;
  return path;
}

Eigen::Vector2d tip(const NoLoadModel& model, const Eigen::VectorXd& kpa) {
  BackboneD backbone(model.point_count(), 3);
  model.backbone(Eigen::Ref<const Eigen::VectorXd>(kpa), Eigen::Ref<BackboneD>(backbone));
  return tip_position_m(backbone);
}

TEST(LapPosture, HasItsTipOnThePathWithinTheLimitsAndInSmallSteps) {
  const ArmDescription arm =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  const NoLoadModel model(arm);
  const TipPath path = circle(2);
  const LapPosture posture(model, path, limits_of(arm), 1);
  ASSERT_TRUE(posture.is_known());
  Eigen::VectorXd before = posture.at(0.0);
  for (int frame = 0; frame <= 400; ++frame) {
    const double time_s = 0.05 * frame;
    const Eigen::VectorXd kpa = posture.at(time_s);
    EXPECT_LT((tip(model, kpa) - path.at(time_s)).norm(), 0.006) << time_s;
    EXPECT_LE(kpa.cwiseAbs().maxCoeff(), 85.0 + 1e-9) << time_s;
    EXPECT_LT((kpa - before).cwiseAbs().maxCoeff(), 5.0) << time_s << ": the frame rule";
    before = kpa;
  }
  EXPECT_TRUE(posture.at(0.0).isApprox(posture.at(10.0))) << "the lap closes";
}

TEST(LapPosture, RepeatsForItsSeedAndIsStillBeforeThePath) {
  const ArmDescription arm =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  const NoLoadModel model(arm);
  const LapPosture a(model, circle(1), limits_of(arm), 3);
  const LapPosture b(model, circle(1), limits_of(arm), 3);
  EXPECT_EQ(a.at(3.3), b.at(3.3));
  EXPECT_EQ(a.at(-2.0), a.at(0.0));
}

TEST(LapPosture, StaysAtTheEndOfAPathThatDoesNotClose) {
  const ArmDescription arm =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  TipPath arc = circle(1);
  arc.time_s.resize(100);  // half of it
  arc.point_m.resize(100);
  const LapPosture posture(NoLoadModel(arm), arc, limits_of(arm), 1);
  const Eigen::VectorXd& end_kpa = posture.points_kpa().back();
  EXPECT_EQ(posture.at(arc.lap_s()), end_kpa);
  EXPECT_EQ(posture.at(arc.lap_s() + 0.6), end_kpa) << "the tracker looks ahead";
  EXPECT_FALSE(end_kpa.isApprox(posture.at(0.0), 0.1));
}

/// Largest distance of the model's tip from the path in the second lap of such set points.
double farthest_m(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
                  const LapPosture& posture) {
  const ArmStart vented = start_state(Environment{}, arm);
  MotionState state = model.settled_state(vented.pressures_kpa, vented.backbone);
  MotionModel::Workspace workspace;
  double farthest = 0.0;
  for (int frame = 1; frame <= 400; ++frame) {
    const double time_s = 0.05 * frame;
    const Pressures setpoint_kpa = posture.at(time_s).cast<float>();
    model.step(setpoint_kpa, state, workspace);
    const double off_m = (tip_position_m(state.backbone) - path.at(time_s)).norm();
    farthest = std::max(farthest, frame > 200 ? off_m : 0.0);
  }
  return farthest;
}

TEST(LapFit, MovesTheSetPointsUntilAnotherModelKeepsThePath) {
  const ArmDescription arm =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  const TipPath path = circle(2);
  const LapPosture posture(NoLoadModel(arm), path, limits_of(arm), 1);
  const ForwardModel forward(bending(arm, 0.8));
  const ValveParameters slow{
      true, std::vector<SegmentValves>(3, {{0.1, 100.0}, {0.12, 100.0}, 0.12, 0.2})};
  const MotionModel model(forward, ValveModel(arm, slow));
  const double before_m = farthest_m(arm, model, path, posture);
  const LapPosture fitted = fitted_to(path, arm, model, posture);
  EXPECT_GT(before_m, 0.02);
  EXPECT_LT(farthest_m(arm, model, path, fitted), 0.15 * before_m);
  for (const Eigen::VectorXd& kpa : fitted.points_kpa()) {
    EXPECT_LE(kpa.cwiseAbs().maxCoeff(), 100.0);
  }
  EXPECT_TRUE(fitted.at(0.0).isApprox(fitted.at(10.0))) << "the lap closes";
}

// A power of two per kPa: no number differs by more than its exponent.
TEST(LapFit, IsTheSameInAnyUnitOfTheCommand) {
  constexpr double kPerKpa = 1.0 / 64.0;
  constexpr double kRounding = 1e-9;  // share
  const ArmDescription arm =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  ArmDescription other = arm;
  other.command = {"pressure", "64 kPa"};
  other.pressure_rate_limit_kpa_per_s *= kPerKpa;
  for (Segment& segment : other.segments) {
    segment.pressure_limit_kpa *= kPerKpa;
    double power = 1.0;
    for (double& coefficient : segment.strain_polynomial) {
      coefficient /= power *= kPerKpa;
    }
  }
  ASSERT_EQ(command_per_kpa(arm), 1.0);
  ASSERT_EQ(command_per_kpa(other), kPerKpa);
  const TipPath path = circle(2);
  const LapPosture posture(NoLoadModel(arm), path, limits_of(arm), 1);
  std::vector<Eigen::VectorXd> points = posture.points_kpa();
  for (Eigen::VectorXd& point : points) {
    point *= kPerKpa;
  }
  const ForwardModel forward(bending(arm, 0.8));
  const ForwardModel of_other(bending(other, 0.8));
  const LapPosture fitted = fitted_to(path, arm, MotionModel(forward), posture);
  const LapPosture scaled =
      fitted_to(path, other, MotionModel(of_other), posture.with_points(std::move(points)));
  for (std::size_t k = 0; k < fitted.points_kpa().size(); ++k) {
    EXPECT_TRUE(scaled.points_kpa()[k].isApprox(kPerKpa * fitted.points_kpa()[k], kRounding)) << k;
  }
}

TEST(LapFit, LeavesALapOfFewFramesAsItIs) {
  const ArmDescription arm =
      load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  TipPath path = circle(2);
  for (double& time_s : path.time_s) {
    time_s /= 5.0;
  }
  const ForwardModel forward(bending(arm, 0.8));
  const LapPosture posture(NoLoadModel(arm), path, limits_of(arm), 1);
  EXPECT_EQ(fitted_to(path, arm, MotionModel(forward), posture).points_kpa(), posture.points_kpa());
}

}  // namespace
}  // namespace limber
