#include "limber/sim/virtual_arm.hpp"

#include <cmath>

#include <fmt/format.h>

#include "bench_rest.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

// Change of the side's strain over one frame at rest. Stopped earlier, what is left depends on the
// damping, and on which frame another machine stops at, and shows in the fit's seventh digit.
constexpr double kStillStrain = 1e-13;
constexpr double kLongestRestS = 60.0;
constexpr int kMinSteps = 4;

/// The arm that stands on the bench: one segment, nothing that depends on history.
ArmDescription bench_arm(const ArmDescription& arm, int segment) {
  ArmDescription bench = arm;
  bench.segments = {arm.segments[static_cast<std::size_t>(segment)]};
  // Either side is like the other, so that the right one stands for the side that takes more.
  PressureLimits& limits = bench.segments.front().pressure_limit_kpa;
  limits = limits.largest_kpa();
  bench.name = fmt::format("{}, {} on the bench", arm.name, segment_name(segment));
  VirtualArmParameters parameters = virtual_arm_parameters(arm);
  make_ideal(parameters);
  set_virtual_arm_parameters(bench, parameters);
  return bench;
}

}  // namespace

void make_ideal(VirtualArmParameters& parameters) {
  parameters.strength_spread = 0.0;
  parameters.hysteresis_fraction = 0.0;
  parameters.hysteresis_floor_n = 0.0;
  parameters.friction_coefficient = 0.0;
  parameters.joint_friction_n_m = 0.0;
  parameters.table_tilt_rad = 0.0;
  parameters.gap_length_spread = 0.0;
  parameters.creep_fraction = 0.0;
  parameters.plate_offset_rad = 0.0;
  parameters.base_misalignment_rad = 0.0;
  parameters.pressure_dead_band_kpa = 0.0;
}

BenchPoint settled_point(VirtualArm& arm, const Pressures& setpoint_kpa, Eigen::Index channel,
                         const std::function<double()>& strain) {
  const double wanted_kpa = double(setpoint_kpa[channel]);
  const double end_s = arm.state().time_s + kLongestRestS;
  double before = 0.0;
  double now = strain();
  do {
    throw_if_interrupted();
    before = now;
    arm.command(setpoint_kpa);
    now = strain();
    if (arm.state().time_s > end_s) {
      throw SystemFault(fmt::format(
          "bench test: the segment still moves after {} s at {} kPa; check virtual_arm's damping",
          kLongestRestS, wanted_kpa));
    }
  } while (std::abs(now - before) > kStillStrain ||
           std::abs(arm.true_pressure_kpa()[channel] - wanted_kpa) > 1e-3);
  return {arm.true_pressure_kpa()[channel], now};
}

std::vector<BenchPoint> bench_test(const ArmDescription& arm, int segment, int steps) {
  require_planar(arm, "the bench test of a side");
  if (segment < 0 || segment >= arm.segment_count()) {
    throw InputError(fmt::format("bench test: {}; arm '{}' has segments 0 to {}",
                                 segment_name(segment), arm.name, arm.segment_count() - 1));
  }
  if (steps < kMinSteps) {
    throw InputError(fmt::format("bench test: {} steps; expected at least {}", steps, kMinSteps));
  }
  VirtualArm bench(bench_arm(arm, segment));
  const double limit =
      arm.segments[static_cast<std::size_t>(segment)].pressure_limit_kpa.largest_kpa();
  std::vector<BenchPoint> points = {{0.0, 0.0}};
  for (int step = 1; step <= steps; ++step) {
    const Pressures setpoint = Pressures::Constant(1, static_cast<float>(limit * step / steps));
    points.push_back(settled_point(bench, setpoint, 0, [&] { return bench.right_strain(0); }));
  }
  return points;
}

BenchData bench_test_all(const ArmDescription& arm, int steps) {
  BenchData all;
  for (int segment = 0; segment < arm.segment_count(); ++segment) {
    all.push_back(bench_test(arm, segment, steps));
  }
  return all;
}

}  // namespace limber
