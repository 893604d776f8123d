#include "src/sim/spring_slider.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limber {
namespace {

VirtualArmParameters dry_table() {
  VirtualArmParameters parameters;
  parameters.friction_coefficient = 0.2;
  parameters.friction_static_excess = 0.4;
  parameters.friction_stribeck_m_per_s = 0.03;
  return parameters;
}

TEST(TableFriction, IsCoulombsWhereNothingElseIsAsked) {
  VirtualArmParameters parameters;
  parameters.friction_coefficient = 0.31;
  const TableFriction friction(parameters);
  for (const double speed : {0.0, 1e-3, 0.1, 5.0}) {
    EXPECT_EQ(friction.coefficient(speed), 0.31);
  }
}

TEST(TableFriction, TakesItsExcessToBreakAwayAndLosesItAsItSlides) {
  const TableFriction friction(dry_table());
  EXPECT_DOUBLE_EQ(friction.coefficient(0.0), 0.2 * 1.4);
  EXPECT_DOUBLE_EQ(friction.coefficient(0.03), 0.2 * (1.0 + 0.4 * std::exp(-1.0)));
  EXPECT_NEAR(friction.coefficient(0.3), 0.2, 1e-12);
  for (double speed = 0.0; speed < 0.1; speed += 0.002) {
    EXPECT_GT(friction.coefficient(speed), friction.coefficient(speed + 0.002));
  }
}

TEST(TableFriction, GrowsWithSpeedByItsViscousPart) {
  VirtualArmParameters parameters = dry_table();
  parameters.friction_viscous_s_per_m = 0.15;
  const TableFriction friction(parameters), dry(dry_table());
  EXPECT_EQ(friction.coefficient(0.0), dry.coefficient(0.0));
  EXPECT_NEAR(friction.coefficient(2.0) - dry.coefficient(2.0), 0.3, 1e-12);
}

}  // namespace
}  // namespace limber
