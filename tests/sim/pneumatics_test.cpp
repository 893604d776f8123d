#include "src/sim/pneumatics.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr double kStepS = 1e-3;
const VirtualArmParameters kParameters;
const Pneumatics kPneumatics(kParameters, kStepS);

/// One channel on its way.
VirtualArmState air_at(double pressure_kpa, double setpoint_kpa) {
  VirtualArmState air;
  air.pressure_kpa = {pressure_kpa};
  air.flow_kpa_per_s = {0.0};
  air.setpoint_kpa = {setpoint_kpa};
  return air;
}

/// Time until the pressure is within `tolerance_kpa` of the set point.
double time_to_reach(double from_kpa, double setpoint_kpa, double tolerance_kpa) {
  VirtualArmState air = air_at(from_kpa, setpoint_kpa);
  int steps = 0;
  while (std::abs(air.pressure_kpa[0] - setpoint_kpa) > tolerance_kpa && steps < 100000) {
    kPneumatics.step(air);
    ++steps;
  }
  return steps * kStepS;
}

TEST(Pneumatics, NeverFasterThanItsLimitAndNeverPastTheSetPoint) {
  VirtualArmState air = air_at(-100.0, 100.0);
  for (int i = 0; i < 5000; ++i) {
    const double before = air.pressure_kpa[0];
    kPneumatics.step(air);
    EXPECT_LE(air.pressure_kpa[0] - before,
              kParameters.pressure_rate_limit_kpa_per_s * kStepS * 1.001);
    EXPECT_GE(air.pressure_kpa[0], before);
    EXPECT_LE(air.pressure_kpa[0], 100.0);
  }
}

TEST(Pneumatics, SettlesAFullReversalWithinAHoldOfThreeSeconds) {
  EXPECT_LT(time_to_reach(-100.0, 100.0, 2.0 * kParameters.pressure_dead_band_kpa), 3.0);
  EXPECT_GT(time_to_reach(-100.0, 100.0, 2.0 * kParameters.pressure_dead_band_kpa), 2.0);
}

TEST(Pneumatics, VentsMoreSlowlyThanItInflates) {
  EXPECT_GT(time_to_reach(10.0, 0.0, 0.5), 1.1 * time_to_reach(0.0, 10.0, 0.5));
  EXPECT_NEAR(time_to_reach(0.0, -10.0, 0.5), time_to_reach(0.0, 10.0, 0.5), kStepS);
}

TEST(Pneumatics, EachDirectionKeepsItsOwnLimit) {
  VirtualArmParameters parameters;
  parameters.inflate_rate_limit_kpa_per_s = 60.0;
  parameters.vent_rate_limit_kpa_per_s = 140.0;
  const Pneumatics pneumatics(parameters, kStepS);
  VirtualArmState air = air_at(-90.0, 90.0);
  double fastest_vent = 0.0;
  double fastest_inflate = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double before = air.pressure_kpa[0];
    pneumatics.step(air);
    double& fastest = air.pressure_kpa[0] < -1.0 ? fastest_vent : fastest_inflate;
    if (std::abs(air.pressure_kpa[0]) > 20.0) {  // around zero the valve's lag mixes the two
      fastest = std::max(fastest, (air.pressure_kpa[0] - before) / kStepS);
    }
  }
  constexpr double kRounding = 1e-6;
  EXPECT_NEAR(fastest_vent, 140.0, kRounding);
  EXPECT_NEAR(fastest_inflate, 60.0, 0.1);
}

TEST(Pneumatics, HoldsStillWithinTheDeadBandUnlessItVents) {
  const double inside = 0.9 * kParameters.pressure_dead_band_kpa;
  VirtualArmState air = air_at(inside, 0.0);
  for (int i = 0; i < 1000; ++i) {
    kPneumatics.step(air);
  }
  EXPECT_EQ(air.pressure_kpa[0], inside);
  air.vented = true;
  for (int i = 0; i < 3000; ++i) {
    kPneumatics.step(air);
  }
  EXPECT_NEAR(air.pressure_kpa[0], 0.0, 1e-6);
}

TEST(Pneumatics, SettlesWithinTheDeadBandFromEverywhere) {
  for (double from = -100.0; from <= 100.0; from += 12.5) {
    for (double to = -100.0; to <= 100.0; to += 12.5) {
      VirtualArmState air = air_at(from, to);
      for (int i = 0; i < 4000; ++i) {
        kPneumatics.step(air);
      }
      EXPECT_NEAR(air.pressure_kpa[0], to, kParameters.pressure_dead_band_kpa * 1.001);
      EXPECT_NEAR(air.flow_kpa_per_s[0], 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace limber
