#include "limber/arm/valve_model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random_valves.hpp"
#include "test_arms.hpp"

namespace limber {
namespace {

/// dp/dt by small explicit steps, straight from the words of docs/valves.md.
std::vector<double> by_euler(const SegmentValves& valves, bool has_sides,
                             const Eigen::MatrixXd& setpoints, double frame_period_s) {
  constexpr double kStepS = 2e-6;
  std::vector<double> pressures{setpoints(0, 0)};
  double p = setpoints(0, 0);
  const auto steps = std::llround(frame_period_s / kStepS);
  for (Eigen::Index frame = 1; frame < setpoints.cols(); ++frame) {
    for (long long step = 0; step < steps; ++step) {
      const double time = double(frame - 1) * frame_period_s + (double(step) + 0.5) * kStepS;
      const double then = std::floor((time - valves.dead_time_s) / frame_period_s);
      const double s = setpoints(0, std::max<Eigen::Index>(0, Eigen::Index(then) + 1));
      const double error = s - p;
      if (std::abs(error) <= valves.dead_band_kpa) {
        continue;
      }
      const bool vents = has_sides ? error * p < 0.0 : error < 0.0;
      const ValveDirection& way = vents ? valves.venting : valves.inflating;
      const double rate = std::min(way.rate_limit_kpa_per_s,
                                   std::abs(error) / std::max(way.time_constant_s, kStepS));
      p += std::copysign(rate * kStepS, error);
    }
    pressures.push_back(p);
  }
  return pressures;
}

TEST(ValveMotion, AgreesWithSmallEulerSteps) {
  constexpr double kEulerKpa = 0.02;  // a step of 2 µs at the largest rates, and a step's dead time
  RandomStream random(4, 0);
  for (int trial = 0; trial < 40; ++trial) {
    const bool has_sides = trial % 4 != 0;
    SegmentValves valves = random_valves(random);
    valves.inflating.time_constant_s = std::max(valves.inflating.time_constant_s, 0.01);
    valves.venting.time_constant_s = std::max(valves.venting.time_constant_s, 0.01);
    const ArmDescription arm = has_sides ? arm_of(1) : curvature_arm_of(1);
    const Eigen::MatrixXd setpoints = random_setpoints(1, 40, random);
    const Eigen::MatrixXd ours =
        ValveModel(arm, {has_sides, {valves}}).run(setpoints, setpoints.col(0));
    const auto euler = by_euler(valves, has_sides, setpoints, arm.frame_period_s());
    for (Eigen::Index k = 0; k < setpoints.cols(); ++k) {
      ASSERT_NEAR(ours(0, k), euler[std::size_t(k)], kEulerKpa) << trial << ", frame " << k;
    }
  }
}

TEST(ValveMotion, IsContinuousInPressureAndSetpoint) {
  constexpr double kNudgeKpa = 1e-7;
  // Two directions may differ a hundredfold in speed, and one frame stretches distances by that.
  constexpr double kMaxSlope = 1e3;
  RandomStream random(6, 0);
  for (int trial = 0; trial < 20000; ++trial) {
    SegmentValves valves = random_valves(random);
    valves.dead_time_s = 0.0;
    valves.inflating.time_constant_s = std::max(valves.inflating.time_constant_s, 0.01);
    valves.venting.time_constant_s = std::max(valves.venting.time_constant_s, 0.01);
    const ValveMotion motion(valves, true, 0.05);
    // Near the edges: zero, the set point, the dead band.
    const double p = random.uniform() < 0.5 ? random.uniform(-1e-7, 1e-7) : random.uniform(-3, 3);
    const double s = random.uniform() < 0.5 ? random.uniform(-1e-7, 1e-7) : random.uniform(-3, 3);
    const double here = motion.after_frame(p, s, s);
    EXPECT_NEAR(motion.after_frame(p + kNudgeKpa, s, s), here, kMaxSlope * kNudgeKpa);
    EXPECT_NEAR(motion.after_frame(p, s, s + kNudgeKpa), here, kMaxSlope * kNudgeKpa);
  }
}

}  // namespace
}  // namespace limber
