#include "limber/sim/virtual_arm.hpp"

#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/QR>

#include "limber/arm/characterisation.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

// Change of the side's strain over one frame at rest. Stopped earlier, what is left depends on the
// damping, and on which frame another machine stops at, and shows in the fit's seventh digit.
constexpr double kStillStrain = 1e-13;
constexpr double kLongestRestS = 60.0;
constexpr int kMinSteps = 4;
constexpr int kMaxSteps = 1000;  // a quartic needs no more

/// Of an arm on the bench: nothing depends on history, or differs from one actuator to another.
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
  parameters.weak_side_loss = 0.0;
  parameters.leak_share = 0.0;
}

/// Holds set points until nothing moves: the pressure that `channel` then has, and `strain()`.
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

/// The arm that stands on the bench: one segment, nothing that depends on history.
ArmDescription on_bench(const ArmDescription& arm, int segment, const std::string& what) {
  ArmDescription bench = arm;
  bench.segments = {arm.segments[segment]};
  bench.name = fmt::format("{}, {} on the bench", arm.name, what);
  change_virtual_arm(bench, make_ideal);
  return bench;
}

ArmDescription side_on_bench(const ArmDescription& arm, int segment) {
  ArmDescription bench = on_bench(arm, segment, segment_name(segment));
  // Either side is like the other, so that the right one stands for the side that takes more.
  PressureLimits& limits = bench.segments.front().pressure_limit_kpa;
  limits = limits.largest_kpa();
  return bench;
}

/// Which segment has the chamber, and its number there.
struct ChamberPlace {
  int segment = 0;
  int chamber = 0;
};

ChamberPlace place_of(const ArmDescription& arm, int channel) {
  ChamberPlace place{0, channel};
  for (; place.chamber >= std::ssize(arm.segments[std::size_t(place.segment)].chambers);
       ++place.segment) {
    place.chamber -= int(arm.segments[std::size_t(place.segment)].chambers.size());
  }
  return place;
}

/// What a chamber's place is strained by where its own strain is 1 and that of the others is 0:
/// docs/model.md, (26) at that place. 1 for three chambers, 3/4 for two pairs.
double own_share(const Segment& segment, int chamber) {
  Eigen::MatrixX3d places(std::ssize(segment.chambers), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    const Chamber& one = segment.chambers[i];
    const double angle_rad = one.angle_deg * std::numbers::pi / 180.0;
    places.row(i) << 1.0, one.radius_m * std::cos(angle_rad), one.radius_m * std::sin(angle_rad);
  }
  const Eigen::MatrixXd back = places.completeOrthogonalDecomposition().pseudoInverse();
  return places.row(chamber).dot(back.col(chamber));
}

/// Free of load, too.
ArmDescription chamber_on_bench(const ArmDescription& arm, int channel) {
  ArmDescription bench = on_bench(arm, place_of(arm, channel).segment, channel_name(arm, channel));
  bench.no_load = NoLoadKind::straight;
  bench.segments.front().shape_of_strains = {};
  bench.gravity.setZero();
  return bench;
}

}  // namespace

std::vector<BenchPoint> bench_test(const ArmDescription& arm, int segment, int steps) {
  require_planar(arm, "the bench test of a side");
  if (segment < 0 || segment >= arm.segment_count()) {
    throw InputError(fmt::format("bench test: {}; arm '{}' has segments 0 to {}",
                                 segment_name(segment), arm.name, arm.segment_count() - 1));
  }
  refuse_if(steps < kMinSteps || steps > kMaxSteps, "bench test: {} steps; expected {} to {}",
            steps, kMinSteps, kMaxSteps);
  VirtualArm bench(side_on_bench(arm, segment));
  const double limit = arm.segments[segment].pressure_limit_kpa.largest_kpa();
  std::vector<BenchPoint> points = {{0.0, 0.0}};
  for (int step = 1; step <= steps; ++step) {
    const Pressures setpoint = Pressures::Constant(1, float(limit * step / steps));
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

std::vector<BenchPoint> bench_test_of_chamber(const ArmDescription& arm, int channel, int steps) {
  if (!arm.is_spatial() || channel < 0 || channel >= arm.channel_count() || steps < kMinSteps) {
    throw InputError(fmt::format(
        "bench test: chamber {} in {} steps; arm '{}' has {} chambers in all, and {} steps at "
        "least are expected",
        channel, steps, arm.name, arm.is_spatial() ? arm.channel_count() : 0, kMinSteps));
  }
  const ChamberPlace place = place_of(arm, channel);
  const Segment& segment = arm.segments[place.segment];
  const Chamber& chamber = arm.chamber(channel);
  const double share = own_share(segment, place.chamber);
  VirtualArm bench(chamber_on_bench(arm, channel));
  std::vector<BenchPoint> points = {{0.0, 0.0}};
  for (int step = 1; step <= steps; ++step) {
    Pressures setpoint = Pressures::Zero(std::ssize(segment.chambers));
    setpoint[place.chamber] = float(chamber.limit_kpa.upper_kpa * step / steps);
    BenchPoint point = settled_point(bench, setpoint, place.chamber,
                                     [&] { return bench.chamber_strain(place.chamber); });
    point.strain *= -chamber.sense / share;
    points.push_back(point);
  }
  return points;
}

}  // namespace limber
