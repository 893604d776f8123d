#include "src/logs/motive_plates.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace limber {
namespace {

// Relative rotations: first about the first axis, then about the turned second one.
TEST(MotiveRotations, EulerAnglesAreRelative) {
  const Eigen::Vector4d xyz = quaternion_of_euler({M_PI / 2, M_PI / 2, 0.0}, "XYZ");
  // x → x → −z; then about the new y, which is z: x̂ goes to ŷ … by hand: R = Rx·Ry.
  const Eigen::Quaterniond q(xyz[3], xyz[0], xyz[1], xyz[2]);
  EXPECT_LT((q * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((q * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  for (const char* order : {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
    const Eigen::Vector4d about_y = quaternion_of_euler({0.0, 0.5, 0.0}, order);
    EXPECT_NEAR(about_y[1], std::sin(0.25), 1e-12) << order;
  }
}

TEST(MotiveRotations, AnOrderNamesEachAxisOnce) {
  EXPECT_TRUE(is_euler_order("ZXY"));
  for (const char* none : {"", "XY", "XYX", "XYZX", "xyz", "Quaternion"}) {
    EXPECT_FALSE(is_euler_order(none)) << none;
  }
}

}  // namespace
}  // namespace limber
