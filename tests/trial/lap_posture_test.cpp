#include "limber/trial/lap_posture.hpp"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/pressure_limits.hpp"

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
  return backbone.bottomRows<1>().leftCols<2>().transpose();
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

}  // namespace
}  // namespace limber
