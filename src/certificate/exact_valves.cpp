#include "exact_valves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limber {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// One segment's pressure under a constant set point: it approaches the set point with the rate
/// limit at first, then exponentially, and stops at the dead band's edge.
class MovingPressure {
 public:
  MovingPressure(const SegmentValves& valves, bool has_sides, double pressure_kpa)
      : valves_(valves), has_sides_(has_sides), pressure_kpa_(pressure_kpa) {}

  double kpa() const { return pressure_kpa_; }

  void follow(double setpoint_kpa, double duration_s) {
    const bool has_to_empty = has_sides_ && pressure_kpa_ * setpoint_kpa <= 0.0;
    double left_s = duration_s;
    if (has_to_empty && pressure_kpa_ != 0.0) {
      // One side vents, with the set point's pull from beyond zero, before the other inflates.
      left_s = close_in(setpoint_kpa, valves_.venting, std::abs(setpoint_kpa), left_s);
      if (left_s > 0.0 && std::abs(setpoint_kpa) > valves_.dead_band_kpa) {
        pressure_kpa_ = 0.0;
      }
    }
    if (left_s > 0.0) {
      const bool vents = has_sides_ ? std::abs(setpoint_kpa) < std::abs(pressure_kpa_)
                                    : setpoint_kpa < pressure_kpa_;
      close_in(setpoint_kpa, vents ? valves_.venting : valves_.inflating, 0.0, left_s);
    }
  }

 private:
  /// Until `left_s` is over or the set point is `until_away` away; at most to the dead band's edge.
  /// @return what is left of the time
  double close_in(double setpoint_kpa, const ValveDirection& law, double until_away,
                  double left_s) {
    const double error = setpoint_kpa - pressure_kpa_;
    const double end = std::max(until_away, valves_.dead_band_kpa);
    const double knee = law.rate_limit_kpa_per_s * law.time_constant_s;
    double away = std::abs(error);
    if (away > std::max(knee, end)) {
      const double takes_s = (away - std::max(knee, end)) / law.rate_limit_kpa_per_s;
      away = takes_s <= left_s ? std::max(knee, end) : away - law.rate_limit_kpa_per_s * left_s;
      left_s = std::max(0.0, left_s - takes_s);
    }
    if (away > end && left_s > 0.0) {
      const double takes_s = end > 0.0 ? law.time_constant_s * std::log(away / end) : kNever;
      away = takes_s <= left_s ? end : away * std::exp(-left_s / law.time_constant_s);
      left_s = std::max(0.0, left_s - takes_s);
    }
    pressure_kpa_ = setpoint_kpa - std::copysign(away, error);
    return left_s;
  }

  const SegmentValves& valves_;
  bool has_sides_;
  double pressure_kpa_;
};

}  // namespace

std::vector<double> ExactValves::segment_pressures(const SegmentValves& valves, double start_kpa,
                                                   std::size_t before,
                                                   const std::vector<double>& setpoints_kpa) const {
  const double period_s = 1.0 / arm_.frame_rate_hz;
  MovingPressure pressure(valves, valves_.has_sides, start_kpa);
  std::vector<double> pressures{pressure.kpa()};
  // Set point k takes effect at (k − 1) periods and a dead time; frame k ends at k periods. The
  // first in the list is that of frame −before.
  std::size_t in_force = 0;
  double now_s = 0.0;
  for (std::size_t k = 1; k + before < setpoints_kpa.size(); ++k) {
    const double end_s = double(k) * period_s;
    while (now_s < end_s) {
      const double next_s =
          in_force + 1 < setpoints_kpa.size()
              ? (double(in_force) - double(before)) * period_s + valves.dead_time_s
              : kNever;
      if (next_s <= now_s) {
        ++in_force;
        continue;
      }
      const double until_s = std::min(end_s, next_s);
      pressure.follow(setpoints_kpa[in_force], until_s - now_s);
      now_s = until_s;
    }
    pressures.push_back(pressure.kpa());
  }
  return pressures;
}

ExactValves::Configurations ExactValves::pressures_along(const Configurations& setpoints_kpa,
                                                         const std::vector<double>& start_kpa,
                                                         const Configurations& before_kpa) const {
  Configurations pressures = setpoints_kpa;
  pressures.front() = start_kpa;
  for (std::size_t i = 0; i < valves_.segments.size(); ++i) {
    std::vector<double> setpoints;
    for (auto frame = before_kpa.rbegin(); frame != before_kpa.rend(); ++frame) {
      setpoints.push_back((*frame)[i]);
    }
    for (const std::vector<double>& frame : setpoints_kpa) {
      setpoints.push_back(frame[i]);
    }
    const std::vector<double> followed =
        segment_pressures(valves_.segments[i], start_kpa[i], before_kpa.size(), setpoints);
    for (std::size_t k = 0; k < followed.size(); ++k) {
      pressures[k][i] = followed[k];
    }
  }
  return pressures;
}

}  // namespace limber
