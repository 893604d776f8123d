#include "limber/driver/wire_calibration.hpp"

#include <gmock/gmock.h>

#include "limber/sim/misassembly.hpp"

namespace limber {
namespace {

constexpr float kRounding = 1e-5F;      // float32 some metres away, in m
constexpr double kRoundingRad = 1e-12;  // of doubles

ArmDescription two_segments() {
  ArmDescription arm;
  arm.name = "mine";
  arm.segments.assign(2, {0.2, 0.03, 4, PressureLimits(80.0)});
  arm.frame_rate_hz = 20.0;
  return arm;
}

/// Poses within half a turn, in metres.
Backbone poses_of(const ArmDescription& arm) {
  Backbone poses(arm.point_count(), 3);
  for (Eigen::Index i = 0; i < poses.rows(); ++i) {
    const auto t = static_cast<float>(i);
    poses.row(i) << 0.05F * t, -0.003F * t * t, 0.6F * t - 2.4F;
  }
  return poses;
}

/// Known by hand: the tracker's y points up, and the arm lies along its z.
TEST(TrackerPlane, CountsHeadingsFromItsXAxisToItsYAxis) {
  TrackerPlane plane;
  plane.origin = {1.0, 2.0, 3.0};
  plane.x_axis = Eigen::Vector3d::UnitZ();
  plane.y_axis = Eigen::Vector3d::UnitX();
  plane.body_rotations.push_back(plane.axes().conjugate());  // not turned where its heading is 0
  BodyPoses bodies(1, 7);
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  bodies << 1.5, 2.7, 3.25, turned.coeffs().transpose();
  const Backbone poses = poses_in_plane(plane, bodies);
  EXPECT_FLOAT_EQ(poses(0, 0), 0.25F);
  EXPECT_FLOAT_EQ(poses(0, 1), 0.5F);
  EXPECT_FLOAT_EQ(poses(0, 2), 0.3F);
  EXPECT_NEAR(tilts_rad(plane, bodies)[0], 0.0, kRoundingRad);
}

TEST(TrackerPlane, PosesInPlaneAreTheInverseOfBodiesInSpace) {
  const ArmDescription arm = two_segments();
  const Backbone poses = poses_of(arm);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Misassembly wrong = draw_misassembly_in_3d(arm, seed);
    const TrackerPlane& plane = *wrong.truth.tracker->plane;
    const BodyPoses bodies = bodies_in_space(plane, poses, wrong.body_heights);
    EXPECT_LT((poses_in_plane(plane, bodies) - poses).cwiseAbs().maxCoeff(), kRounding);
    EXPECT_LT(tilts_rad(plane, bodies).maxCoeff(), 1e-7);
    BodyPoses turned_over = bodies;  // −q is the same rotation
    turned_over.rightCols<4>() *= -1.0;
    EXPECT_LT((poses_in_plane(plane, turned_over) - poses).cwiseAbs().maxCoeff(), kRounding);
  }
}

// What is turned out of the plane is a tilt, and leaves the heading as it is.
TEST(TrackerPlane, TiltsLeaveHeadingsAlone) {
  const ArmDescription arm = two_segments();
  const Misassembly wrong = draw_misassembly_in_3d(arm, 7);
  const TrackerPlane& plane = *wrong.truth.tracker->plane;
  Backbone poses = poses_of(arm);
  poses.col(2).setZero();
  BodyPoses bodies = bodies_in_space(plane, poses, wrong.body_heights);
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.2, plane.x_axis));
  bodies.row(2).tail<4>() = (tilt * rotation_of(bodies, 2)).coeffs().transpose();
  EXPECT_NEAR(tilts_rad(plane, bodies)[2], 0.2, kRoundingRad);
  EXPECT_LT(poses_in_plane(plane, bodies).col(2).cwiseAbs().maxCoeff(), kRounding);
}

}  // namespace
}  // namespace limber
