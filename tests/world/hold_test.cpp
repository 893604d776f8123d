#include "limber/world/hold.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "support/sample_arm.hpp"

namespace limber {
namespace {

/// Of a motion that ends with a pressure at 80 % of the limit, on its way to none, with valves that
/// stop within a dead band of 2 %. @param unit_per_kpa  of the arm's command
int hold_frames(double unit_per_kpa) {
  ArmDescription arm = sample_arm(1);
  arm.segments[0].pressure_limit_kpa = 100.0 * unit_per_kpa;
  const ValveDirection slow{0.5, std::numeric_limits<double>::infinity()};
  const ValveModel valves(arm, ValveParameters{true, {{slow, slow, 0.0, 2.0 * unit_per_kpa}}});
  Eigen::VectorXf state = valves.settled_state(Pressures::Zero(1));
  state[0] = static_cast<float>(80.0 * unit_per_kpa);
  return hold_frame_count(arm, valves, state);
}

// 0.5 s · ln(80 / 2) = 1.84 s, in which the pressure comes to the dead band's edge.
TEST(Hold, LastsUntilThePressuresAreThereInAnyUnit) {
  constexpr int kFrames = 37;
  EXPECT_EQ(hold_frames(1.0), kFrames);
  EXPECT_EQ(hold_frames(1e-3), kFrames) << "MPa";
  EXPECT_EQ(hold_frames(1e3), kFrames) << "Pa";
}

}  // namespace
}  // namespace limber
