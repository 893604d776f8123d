#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/valve_parameters.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

inline SegmentValves lag(double inflate_s, double vent_s) {
  return {{inflate_s, kNoLimit}, {vent_s, kNoLimit}, 0.0, 0.0};
}

inline ValveParameters same(int segments, const SegmentValves& valves, bool has_sides = true) {
  return {has_sides, std::vector<SegmentValves>(std::size_t(segments), valves)};
}

/// Random but physical: lags, limits and dead times that may be none.
inline SegmentValves random_valves(RandomStream& random) {
  const auto maybe = [&](double low, double high, double otherwise) {
    return random.uniform() < 0.7 ? random.uniform(low, high) : otherwise;
  };
  SegmentValves valves;
  valves.inflating = {maybe(0.01, 0.6, 0.0), maybe(20.0, 300.0, kNoLimit)};
  valves.venting = {maybe(0.01, 0.6, 0.0), maybe(20.0, 300.0, kNoLimit)};
  valves.dead_time_s = maybe(0.0, 0.3, 0.0);
  valves.dead_band_kpa = maybe(0.0, 3.0, 0.0);
  return valves;
}

/// Set points that are held for a while, on both sides of zero: n×T.
inline Eigen::MatrixXd random_setpoints(int segments, int frames, RandomStream& random) {
  Eigen::MatrixXd setpoints(segments, frames);
  for (int i = 0; i < segments; ++i) {
    double value = 0.0;
    for (int k = 0; k < frames; ++k) {
      if (random.uniform() < 0.15) {
        value = random.uniform() < 0.2 ? 0.0 : random.uniform(-95.0, 95.0);
      }
      setpoints(i, k) = value;
    }
  }
  return setpoints;
}

}  // namespace limber
