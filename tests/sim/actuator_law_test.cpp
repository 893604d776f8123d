#include "src/sim/side_law.hpp"

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr double kContinuityN = 5e-4;  // change of tension over 1e-7 of strain; ≤ 5000 N per unit
constexpr double kDerivativeN = 1e-5;  // of central differences of the stored energy
constexpr double kOlsonN = 1e-3;       // rounding of the hand calculation

const ActuatorLaw kLaw{VirtualArmParameters{}};

// F(0, p) = 1.03856 · 0.511455² · p.
TEST(ActuatorLaw, PullsInProportionToPressureAtItsOwnLength) {
  EXPECT_NEAR(kLaw.tension_n(0.0, 100.0), 27.1674, kOlsonN);
  EXPECT_NEAR(kLaw.tension_n(0.0, 50.0), 13.5837, kOlsonN);
  EXPECT_EQ(kLaw.tension_n(0.0, 0.0), 0.0);
}

TEST(ActuatorLaw, PullsMoreWithPressureAndLessWithContraction) {
  for (double strain = -0.3; strain <= 0.051; strain += 0.01) {
    for (double pressure = 0.0; pressure < 100.0; pressure += 5.0) {
      EXPECT_GE(kLaw.tension_n(strain, pressure + 5.0), kLaw.tension_n(strain, pressure));
      EXPECT_GT(kLaw.tension_n(strain + 0.01, pressure), kLaw.tension_n(strain, pressure))
          << "strain " << strain << ", pressure " << pressure;
    }
  }
}

TEST(ActuatorLaw, IsSlackWherePressureReachesItsThreshold) {
  for (double strain = -0.3; strain < -0.005; strain += 0.01) {
    const double threshold = kLaw.threshold_kpa(strain);
    ASSERT_GT(threshold, 0.0);
    EXPECT_NEAR(kLaw.tension_n(strain, threshold), 0.0, 1e-9);
    EXPECT_NEAR(kLaw.tension_n(strain, threshold * (1.0 - 1e-9)), 0.0, 1e-6);
    EXPECT_LT(kLaw.tension_n(strain, threshold - 1.0), 0.0);
    EXPECT_GT(kLaw.tension_n(strain, threshold + 1.0), 0.0);
  }
}

TEST(ActuatorLaw, IsContinuousInStrainThroughZeroAndThreshold) {
  constexpr double kStep = 1e-7;
  for (double pressure = 0.0; pressure <= 100.0; pressure += 10.0) {
    for (double strain = -0.3; strain <= 0.1; strain += kStep * 5000) {
      EXPECT_NEAR(kLaw.tension_n(strain + kStep, pressure), kLaw.tension_n(strain, pressure),
                  kContinuityN);
    }
    EXPECT_NEAR(kLaw.tension_n(-kStep, pressure), kLaw.tension_n(kStep, pressure), kContinuityN);
  }
}

TEST(ActuatorLaw, StoresWhatItTakesToStrainItUnpressurised) {
  constexpr double kStep = 1e-6;
  for (double strain = -0.3; strain <= 0.1; strain += 0.017) {
    const double slope =
        (kLaw.passive_energy_n(strain + kStep) - kLaw.passive_energy_n(strain - kStep)) /
        (2.0 * kStep);
    EXPECT_NEAR(slope, kLaw.tension_n(strain, 0.0), kDerivativeN) << strain;
  }
}

// Twice as long a way from full to no tension takes twice the work.
TEST(ActuatorLaw, IsStretchedAlongItsStrainByTheScale) {
  VirtualArmParameters parameters;
  parameters.actuator_strain_scale = 1.3;
  const ActuatorLaw scaled{parameters};
  for (double strain = -0.3; strain <= 0.1; strain += 0.017) {
    EXPECT_NEAR(scaled.tension_n(1.3 * strain, 60.0), kLaw.tension_n(strain, 60.0), kContinuityN);
    EXPECT_NEAR(scaled.threshold_kpa(1.3 * strain), kLaw.threshold_kpa(strain), kContinuityN);
    EXPECT_NEAR(scaled.passive_energy_n(1.3 * strain), 1.3 * kLaw.passive_energy_n(strain),
                kDerivativeN);
  }
}

}  // namespace
}  // namespace limber
