#include "src/driver/calibration/motion_plane.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "simulated_rig.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kNormalRad = 2e-3;    // with noise of 0.1 mm and 0.3 mrad
constexpr double kHeightM = 5e-4;      // of means, which noise and the normal's error make
constexpr double kRounding = 1e-12;    // of lengths of 1
constexpr double kPlaceShare = 0.002;  // of the arm's length: where a mean of noise is
constexpr int kSeeds = 12;

CalibrationLog log_of(const ArmDescription& arm, const Misassembly& wrong, Flaw flaw,
                      std::uint64_t seed) {
  SimulatedRig rig(arm, wrong, flaw, seed);
  return record_calibration(arm, calibration_pulse_kpa(arm), rig.rig());
}

double angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// In any frame, unit and sense, and whatever axes the bodies have.
TEST(MotionPlane, HasTheAxisOfTurnsAsItsNormal) {
  double worst_rad = 0.0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const ArmDescription arm = arm_of(seed);
    const Misassembly wrong = draw_misassembly_in_3d(arm, seed);
    const TrackerPlane& truth = *wrong.truth.tracker->plane;
    const TrackerPlane plane = motion_plane(arm, log_of(arm, wrong, Flaw::none, seed));
    const double off_rad = angle_rad(plane.normal(), truth.normal());
    worst_rad = std::max(worst_rad, off_rad);
    EXPECT_LT(off_rad, kNormalRad);
    EXPECT_NEAR(plane.x_axis.norm(), 1.0, kRounding);
    EXPECT_NEAR(plane.y_axis.norm(), 1.0, kRounding);
    EXPECT_NEAR(plane.x_axis.dot(plane.y_axis), 0.0, kRounding);
    EXPECT_LT(plane.out_of_plane_m, kHeightM);
    EXPECT_LT(plane.tilt_rad, kNormalRad);
  }
  std::printf("normal at worst %.5f rad off\n", worst_rad);
}

// At rest bodies lie along x with heading 0, and body 0 is the origin.
TEST(MotionPlane, LiesAlongTheArmAtRest) {
  const ArmDescription arm = arm_of(1);
  const Misassembly wrong = draw_misassembly_in_3d(arm, 1);
  const CalibrationLog log = log_of(arm, wrong, Flaw::none, 1);
  const CalibrationLog flat = in_plane(log, motion_plane(arm, log));
  const Backbone& first = *flat.frames.front().state.backbone;
  const double length = arm.length_m() / wrong.truth.tracker->metres_per_unit;
  EXPECT_LT(first.row(0).head<2>().norm(), kPlaceShare * length);
  EXPECT_LT(std::abs(first(first.rows() - 1, 1)), kPlaceShare * length);
  EXPECT_GT(first(first.rows() - 1, 0), 0.9 * length);
  EXPECT_LT(first.col(2).cwiseAbs().maxCoeff(), kNormalRad);
  EXPECT_FALSE(flat.frames.front().bodies);
}

TEST(MotionPlane, RefusesWhatLeavesAPlaneOrMovesNothing) {
  const ArmDescription arm = arm_of(3);
  const Misassembly wrong = draw_misassembly_in_3d(arm, 3);
  const auto expect = [&](Flaw flaw, const std::string& message) {
    const CalibrationLog log = log_of(arm, wrong, flaw, 3);
    EXPECT_THAT([&] { (void)motion_plane(arm, log); },
                ThrowsMessage<CalibrationRefused>(HasSubstr(message)));
  };
  expect(Flaw::lifted, "mm with channel");
  expect(Flaw::twisted_body, "off the one of all turns; expected at most 3°");
  expect(Flaw::wrong_order, "Is each quaternion [qx, qy, qz, qw]");
  expect(Flaw::no_supply, "marker bodies turned by at most");
}

TEST(MotionPlane, RefusesStatesOfBothKinds) {
  const ArmDescription arm = arm_of(0);
  CalibrationLog log = log_of(arm, draw_misassembly_in_3d(arm, 0), Flaw::none, 0);
  EXPECT_TRUE(has_bodies(log));
  log.frames[3].bodies.reset();
  EXPECT_TRUE(has_bodies(log));
  log.frames[3].state.backbone = Backbone::Zero(arm.point_count(), 3);
  EXPECT_THAT([&] { (void)has_bodies(log); },
              ThrowsMessage<CalibrationRefused>(HasSubstr("and 1 `backbone`")));
  EXPECT_FALSE(has_bodies(log_of(arm, draw_misassembly(arm, 0), Flaw::none, 0)));
}

}  // namespace
}  // namespace limber
