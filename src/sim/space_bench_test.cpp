#include <cmath>
#include <iterator>
#include <numbers>

#include <Eigen/QR>

#include <fmt/format.h>

#include "bench_rest.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

namespace {

/// Which segment has the chamber, and its number there.
struct ChamberPlace {
  int segment = 0;
  int chamber = 0;
};

ChamberPlace place_of(const ArmDescription& arm, int channel) {
  ChamberPlace place{0, channel};
  for (; place.chamber >= std::ssize(arm.segments[std::size_t(place.segment)].chambers);
       ++place.segment) {
    place.chamber -= static_cast<int>(arm.segments[std::size_t(place.segment)].chambers.size());
  }
  return place;
}

/// What a chamber's place is strained by where its own strain is 1 and that of the others is 0:
/// docs/model.md, (26) at that place. 1 for three chambers, 3/4 for two pairs.
double own_share(const Segment& segment, int chamber) {
  Eigen::MatrixX3d places(std::ssize(segment.chambers), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    const Chamber& one = segment.chambers[static_cast<std::size_t>(i)];
    const double angle_rad = one.angle_deg * std::numbers::pi / 180.0;
    places.row(i) << 1.0, one.radius_m * std::cos(angle_rad), one.radius_m * std::sin(angle_rad);
  }
  const Eigen::MatrixXd back = places.completeOrthogonalDecomposition().pseudoInverse();
  return places.row(chamber).dot(back.col(chamber));
}

/// One segment, free of load and of all that depends on history.
ArmDescription chamber_on_bench(const ArmDescription& arm, int channel) {
  ArmDescription bench = arm;
  bench.segments = {arm.segments[static_cast<std::size_t>(place_of(arm, channel).segment)]};
  bench.no_load = NoLoadKind::straight;
  bench.segments.front().shape_of_strains = {};
  bench.gravity.setZero();
  bench.name = fmt::format("{}, {} on the bench", arm.name, channel_name(arm, channel));
  change_virtual_arm(bench, make_ideal);
  return bench;
}

}  // namespace

std::vector<BenchPoint> bench_test_of_chamber(const ArmDescription& arm, int channel, int steps) {
  constexpr int kMinSteps = 4;
  if (!arm.is_spatial() || channel < 0 || channel >= arm.channel_count() || steps < kMinSteps) {
    throw InputError(fmt::format(
        "bench test: chamber {} in {} steps; arm '{}' has {} chambers in all, and {} steps at "
        "least are expected",
        channel, steps, arm.name, arm.is_spatial() ? arm.channel_count() : 0, kMinSteps));
  }
  const ChamberPlace place = place_of(arm, channel);
  const Segment& segment = arm.segments[static_cast<std::size_t>(place.segment)];
  const Chamber& chamber = arm.chamber(channel);
  const double share = own_share(segment, place.chamber);
  VirtualArm bench(chamber_on_bench(arm, channel));
  std::vector<BenchPoint> points = {{0.0, 0.0}};
  for (int step = 1; step <= steps; ++step) {
    Pressures setpoint = Pressures::Zero(std::ssize(segment.chambers));
    setpoint[place.chamber] = static_cast<float>(chamber.limit_kpa.upper_kpa * step / steps);
    BenchPoint point = settled_point(bench, setpoint, place.chamber,
                                     [&] { return bench.chamber_strain(place.chamber); });
    point.strain *= -chamber.sense / share;
    points.push_back(point);
  }
  return points;
}

}  // namespace limber
