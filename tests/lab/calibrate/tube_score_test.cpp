#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limber/lab/tube_score.hpp"

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

// A driver that answers at once is one frame behind, and its set points in force say so.
TEST(TubeScore, ComparesWithTheFrameThatTheRunShows) {
  Plan plan = straight_plan(5);
  std::vector<Backbone> seen;
  for (int k = 0; k < 5; ++k) {
    plan.frames[std::size_t(k)].setpoint_kpa = Pressures::Constant(1, 5.0F * float(k));
    plan.frames[std::size_t(k)].backbone = shape(0.01 * k);
  }
  for (int t = 0; t < 7; ++t) {
    seen.push_back(shape(0.01 * std::clamp(t - 1, 0, 4)));
  }
  Episode run = run_of(seen);
  for (int t = 0; t < 7; ++t) {
    run.setpoint_kpa(t, 0) = 5.0F * float(std::clamp(t - 1, 0, 4));
  }
  EXPECT_EQ(shown_frames(plan, run), (std::vector<int>{0, 0, 1, 2, 3, 4, 4}));
  EXPECT_NEAR(tube_score(plan, run, unit_tube()), 0.0, kFloat);
}

// The plan's second frame is 5 cm to the side of its first, at the tip.
TEST(TubeScore, CountsErrorsMoreWhereTheTubeIsNarrower) {
  Plan plan = straight_plan(3);
  plan.frames[1].backbone = shape(0.025);
  plan.frames[2].backbone = shape(0.025);
  Tube tube = unit_tube();
  tube.growth = {0.25, 0.1};  // 0.625 of it at the tip then
  const Episode run = run_of({shape(0.0), shape(0.03), shape(0.025)});
  EXPECT_NEAR(tube_score(plan, run, tube), 0.005 / (0.4375 * 0.01), 1e-3);  // of the middle plate
  EXPECT_NEAR(motion_errors(plan, run, tube.growth).plate_m[2], 0.01 / 0.625, 1e-5);
  EXPECT_NEAR(mean_tip_radius_m(plan, tube, TubeLevel{0.9, 2.0}),
              2.0 * 0.02 * (0.25 + 0.625 + 0.625) / 3.0, 1e-6);
}

TEST(MotionErrors, GrowInEachWayThatATubeMay) {
  Plan plan = straight_plan(2);
  plan.frames[1].backbone = shape(0.02);
  const Episode run = run_of({shape(0.0), shape(0.025)});
  // The tip goes 4 cm of the 15 % of a metre after which it has all its room, and ends 1 cm off.
  const GrowingErrors errors = growing_errors(plan, run, 1.0);
  for (std::size_t g = 0; g < kStartShares.size(); ++g) {
    const double start = kStartShares[g];
    const double moved = start + (1.0 - start) * 0.04 / 0.15;
    EXPECT_NEAR(errors.of[g].plate_m[2], 0.01 / moved, 1e-5);
    EXPECT_NEAR(errors.of[g].end_m, 0.01, kFloat);
    EXPECT_NEAR(errors.tip_share[g], 0.5 * (start + moved), 1e-6);
  }
}

// 99 of 100 inside, 95 at the tip and at the end.
TEST(TubeShape, IsWhatMostRunsStayBelow) {
  std::vector<MotionErrors> runs;
  for (int k = 1; k <= 199; ++k) {
    MotionErrors run;
    run.plate_m = {0.0, 0.001 * k, 0.001 * k};
    run.end_m = 0.0001 * k;
    run.end_heading_rad = 0.005 * k;
    runs.push_back(run);
  }
  const RoomGrowth growth{0.4, 0.1};
  const Tube tube = tube_shape(runs, growth);
  EXPECT_EQ(tube.growth, growth);
  EXPECT_NEAR(tube.plate_scale_m[0], 1e-4, 1e-12);  // the base does not move; never 0
  EXPECT_NEAR(tube.plate_scale_m[1], 0.198, 1e-12);
  EXPECT_NEAR(tube.plate_scale_m[2], 0.190, 1e-12);
  EXPECT_NEAR(tube.end_scale_m, 0.019, 1e-12);
  EXPECT_NEAR(tube.end_heading_scale_rad, 0.99, 1e-12);
}

}  // namespace
}  // namespace limber
