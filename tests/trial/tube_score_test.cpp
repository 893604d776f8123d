#include <cmath>

#include <gtest/gtest.h>

#include "limber/trial/tube_score.hpp"

namespace limber {
namespace {

constexpr int kPlates = 3;
constexpr double kFloat = 1e-6;  // [m, rad] rounding of float32 shapes

/// Straight, one plate every 0.1 m, all of it shifted to the side.
Backbone shape(double shift_m, double tip_turn_rad = 0.0) {
  Backbone backbone = Backbone::Zero(kPlates, 3);
  for (int i = 0; i < kPlates; ++i) {
    backbone(i, 0) = 0.1F * static_cast<float>(i);
    backbone(i, 1) = static_cast<float>(shift_m * i);
  }
  backbone(kPlates - 1, 2) = static_cast<float>(tip_turn_rad);
  return backbone;
}

Plan straight_plan(int frames) {
  Plan plan;
  for (int k = 0; k < frames; ++k) {
    plan.frames.push_back({Pressures::Zero(1), Pressures::Zero(1), shape(0.0)});
  }
  return plan;
}

Episode run_of(const std::vector<Backbone>& shapes) {
  Episode run;
  const auto frames = static_cast<Eigen::Index>(shapes.size());
  run.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, 0.05 * double(frames - 1));
  run.pressure_kpa = FrameMatrix::Zero(frames, 1);
  run.setpoint_kpa = FrameMatrix::Zero(frames, 1);
  run.backbone.resize(frames, 3 * kPlates);
  for (Eigen::Index t = 0; t < frames; ++t) {
    for (Eigen::Index i = 0; i < kPlates; ++i) {
      run.backbone.row(t).segment<3>(3 * i) = shapes[static_cast<std::size_t>(t)].row(i);
    }
  }
  return run;
}

Tube unit_tube() {
  Tube tube;
  tube.plate_scale_m = {0.01, 0.01, 0.02};
  tube.end_scale_m = 0.02;
  tube.end_heading_scale_rad = 0.1;
  return tube;
}

TEST(MotionErrors, AreTheLargestOverFramesAndThoseOfTheEnd) {
  const Plan plan = straight_plan(3);
  const MotionErrors errors =
      motion_errors(plan, run_of({shape(0.0), shape(0.01), shape(-0.002, 0.05)}));
  EXPECT_NEAR(errors.plate_m[0], 0.0, kFloat);
  EXPECT_NEAR(errors.plate_m[1], 0.01, kFloat);
  EXPECT_NEAR(errors.plate_m[2], 0.02, kFloat);
  EXPECT_NEAR(errors.end_m, 0.004, kFloat);
  EXPECT_NEAR(errors.end_heading_rad, 0.05, kFloat);
}

TEST(TubeScore, IsTheLargestErrorOverItsScale) {
  const Plan plan = straight_plan(3);
  EXPECT_NEAR(tube_score(plan, run_of({shape(0.0), shape(0.01), shape(0.0)}), unit_tube()), 1.0,
              1e-4);
  // The heading at the end alone; that in between does not count.
  EXPECT_NEAR(tube_score(plan, run_of({shape(0.0), shape(0.0, 0.03), shape(0.0)}), unit_tube()),
              0.1 * 0.5 * std::tan(0.03 / 4.0) / 0.02, 1e-4);
  EXPECT_NEAR(tube_score(plan, run_of({shape(0.0), shape(0.0), shape(0.0, 0.07)}), unit_tube()),
              0.7, 1e-4);
}

// What is held longer than planned stands beside the plan's last frame; a full turn is none.
TEST(TubeScore, CountsTheHoldAndTurnsAsRotations) {
  const Plan plan = straight_plan(2);
  const Backbone turned = shape(0.005, 2.0 * M_PI);
  EXPECT_NEAR(
      tube_score(plan, run_of({shape(0.0), shape(0.0), shape(0.0), shape(0.005)}), unit_tube()),
      0.5, 1e-4);
  const MotionErrors errors = motion_errors(plan, run_of({shape(0.0), shape(0.0), turned}));
  EXPECT_NEAR(errors.end_heading_rad, 0.0, 1e-5);
}

TEST(TubeScore, LeavesOutWhatWasNotTracked) {
  const Plan plan = straight_plan(3);
  Episode run = run_of({shape(0.0), shape(0.5), shape(0.0)});
  run.tracked = {1, 0, 1};
  EXPECT_NEAR(tube_score(plan, run, unit_tube()), 0.0, kFloat);
}

TEST(TubeShape, IsWhatNineTenthsOfTheRunsStayBelow) {
  std::vector<MotionErrors> runs;
  for (int k = 1; k <= 99; ++k) {
    MotionErrors run;
    run.plate_m = {0.0, 0.001 * k};
    run.end_m = 0.0002 * k;
    run.end_heading_rad = 0.01 * k;
    runs.push_back(run);
  }
  const Tube tube = tube_shape(runs);
  EXPECT_NEAR(tube.plate_scale_m[0], 1e-4, 1e-12);  // the base does not move; never 0
  EXPECT_NEAR(tube.plate_scale_m[1], 0.090, 1e-12);
  EXPECT_NEAR(tube.end_scale_m, 0.018, 1e-12);
  EXPECT_NEAR(tube.end_heading_scale_rad, 0.9, 1e-12);
}

}  // namespace
}  // namespace limber
