#include "frame_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kSetpointKpa = 1e-4;  // several roundings of a float32 of 100 kPa
constexpr double kCost = 1e-6;         // relative
constexpr double kFrames = 1e-4;       // a motion so near a whole number of frames may take either
constexpr double kGoalHoldS = 1.0;     // docs/planning.md, Goal

double change_kpa(const Pressures& from, const Pressures& to, Eigen::Index i) {
  return double(to[i]) - double(from[i]);
}

class FrameChecks {
 public:
  FrameChecks(const Plan& plan, const ArmDescription& arm, Certificate& certificate)
      : plan_(plan), arm_(arm), certificate_(certificate) {}

  void run() {
    if (check_sizes()) {
      check_limits();
      check_rate_and_cost();
      check_hold();
      check_waypoints();
    }
  }

 private:
  void fail(const char* check, std::size_t frame, std::string message) {
    certificate_.failures.push_back({check, static_cast<int>(frame), std::move(message)});
  }
  void fail(const char* check, std::string message) {
    certificate_.failures.push_back({check, -1, std::move(message)});
  }

  /// A set point is a float32: a limit as one may lie beyond it.
  static bool is_within(double pressure, const PressureLimits& limits) {
    return pressure >= std::min(limits.lower_kpa, double(float(limits.lower_kpa))) &&
           pressure <= std::max(limits.upper_kpa, double(float(limits.upper_kpa)));
  }

  bool check_sizes() {
    const std::size_t before = certificate_.failures.size();
    if (plan_.frame_rate_hz != arm_.frame_rate_hz) {
      fail("sizes", fmt::format("frame_rate_hz = {}; the arm takes {}", plan_.frame_rate_hz,
                                arm_.frame_rate_hz));
    }
    if (!plan_.limits.empty() && plan_.limits.size() != arm_.segments.size()) {
      fail("sizes", fmt::format("limits of {} segments; the arm has {}", plan_.limits.size(),
                                arm_.segment_count()));
    }
    if (plan_.frames.empty() || plan_.waypoints_kpa.empty()) {
      fail("sizes", "no frames or no waypoints");
    }
    for (std::size_t k = 0; k < plan_.frames.size(); ++k) {
      const PlanFrame& frame = plan_.frames[k];
      if (frame.setpoint_kpa.size() != arm_.segment_count() ||
          frame.pressure_kpa.size() != arm_.segment_count() ||
          frame.backbone.rows() != arm_.point_count()) {
        fail("sizes", k,
             fmt::format("{} set points and {} poses; the arm has {} segments and {} plates",
                         frame.setpoint_kpa.size(), frame.backbone.rows(), arm_.segment_count(),
                         arm_.point_count()));
        break;
      }
    }
    for (const Pressures& waypoint : plan_.waypoints_kpa) {
      if (waypoint.size() != arm_.segment_count()) {
        fail("sizes", fmt::format("a waypoint of {} set points; the arm has {} segments",
                                  waypoint.size(), arm_.segment_count()));
        break;
      }
    }
    return certificate_.failures.size() == before;
  }

  void check_limits() {
    for (std::size_t k = 0; k < plan_.frames.size(); ++k) {
      for (Eigen::Index i = 0; i < plan_.frames[k].setpoint_kpa.size(); ++i) {
        const auto segment = static_cast<std::size_t>(i);
        const double pressure = double(plan_.frames[k].setpoint_kpa[i]);
        const PressureLimits& own = arm_.segments[segment].pressure_limit_kpa;
        if (!is_within(pressure, own)) {
          fail("limits", k,
               fmt::format("{} at {} {unit}; its limits are {} {unit}", segment_name(i), pressure,
                           to_string(own), fmt::arg("unit", arm_.command.unit)));
          return;
        }
        if (!plan_.limits.empty() && !is_within(pressure, plan_.limits[segment])) {
          fail("limits", k,
               fmt::format("{} at {} {unit}; the plan's own limits are {} {unit}", segment_name(i),
                           pressure, to_string(plan_.limits[segment]),
                           fmt::arg("unit", arm_.command.unit)));
          return;
        }
      }
    }
  }

  void check_rate_and_cost() {
    const double step_limit = arm_.pressure_rate_limit_kpa_per_s / arm_.frame_rate_hz;
    double cost = 0.0;
    double largest = 0.0;
    bool reported = false;
    for (std::size_t k = 1; k < plan_.frames.size(); ++k) {
      for (Eigen::Index i = 0; i < arm_.segment_count(); ++i) {
        const double step =
            std::abs(change_kpa(plan_.frames[k - 1].setpoint_kpa, plan_.frames[k].setpoint_kpa, i));
        cost += step;
        largest = std::max(largest, step);
        if (!(step <= step_limit + kSetpointKpa) && !reported) {
          reported = true;
          fail("rate", k,
               fmt::format("{} moves by {:.6g} {} in one frame; {:.6g} are allowed",
                           segment_name(i), step, arm_.command.unit, step_limit));
        }
      }
    }
    certificate_.cost_kpa = cost;
    certificate_.max_step_kpa = largest;
    if (!(std::abs(plan_.cost_kpa - cost) <= kCost * std::max(1.0, cost))) {
      fail("cost",
           fmt::format("cost_kpa = {:.9g}; the frames add up to {:.9g}", plan_.cost_kpa, cost));
    }
  }

  void check_hold() {
    const auto needed = static_cast<std::size_t>(std::ceil(kGoalHoldS * arm_.frame_rate_hz - 1e-9));
    const auto held = static_cast<std::size_t>(std::max(0, plan_.hold_frame_count));
    if (held < needed || held >= plan_.frames.size()) {
      fail("hold", fmt::format("hold_frame_count = {} of {} frames; {} are needed",
                               plan_.hold_frame_count, plan_.frames.size(), needed));
      return;
    }
    for (std::size_t k = plan_.frames.size() - held; k < plan_.frames.size(); ++k) {
      if (plan_.frames[k].setpoint_kpa != plan_.frames[k - 1].setpoint_kpa) {
        fail("hold", k, fmt::format("moves; the last {} frames should stand still", held));
        return;
      }
    }
  }

  /// Whether `count` frames after frame `first` run evenly and straight from one waypoint to the
  /// next; `bad` is else the first that does not.
  bool runs_straight(std::size_t first, std::size_t count, const Pressures& from,
                     const Pressures& to, std::size_t& bad) const {
    for (std::size_t k = 1; k <= count; ++k) {
      bad = first + k;
      if (bad >= plan_.frames.size()) {
        return false;
      }
      const Pressures& setpoint = plan_.frames[bad].setpoint_kpa;
      const double part = double(k) / double(count);
      for (Eigen::Index i = 0; i < setpoint.size(); ++i) {
        const double expected = double(from[i]) + part * change_kpa(from, to, i);
        if (!(std::abs(double(setpoint[i]) - expected) <= kSetpointKpa)) {
          return false;
        }
      }
    }
    return true;
  }

  void check_waypoints() {
    if (plan_.waypoints_kpa.front() != plan_.frames.front().setpoint_kpa) {
      fail("waypoints", 0, "the first waypoint is not the first frame's set points");
      return;
    }
    const double step_limit = arm_.pressure_rate_limit_kpa_per_s / arm_.frame_rate_hz;
    std::size_t at = 0;
    for (std::size_t w = 1; w < plan_.waypoints_kpa.size(); ++w) {
      const Pressures& from = plan_.waypoints_kpa[w - 1];
      const Pressures& to = plan_.waypoints_kpa[w];
      double frames = 0.0;
      for (Eigen::Index i = 0; i < from.size(); ++i) {
        frames = std::max(frames, std::abs(change_kpa(from, to, i)) / step_limit);
      }
      const auto min_frames = static_cast<std::size_t>(std::max(1.0, std::ceil(frames - kFrames)));
      const auto max_frames = static_cast<std::size_t>(std::max(1.0, std::ceil(frames + kFrames)));
      std::size_t bad = 0;
      if (runs_straight(at, min_frames, from, to, bad)) {
        at += min_frames;
      } else if (max_frames != min_frames && runs_straight(at, max_frames, from, to, bad)) {
        at += max_frames;
      } else {
        fail("waypoints", bad,
             fmt::format("is not on the straight motion, in {} frames, from {} to {}", min_frames,
                         waypoint_name(w - 1), waypoint_name(w)));
        return;
      }
    }
    if (at + static_cast<std::size_t>(std::max(0, plan_.hold_frame_count)) + 1 !=
        plan_.frames.size()) {
      fail("waypoints", at,
           fmt::format("{} frames in all; the waypoints make {} and the hold {}",
                       plan_.frames.size(), at + 1, plan_.hold_frame_count));
    }
  }

  const Plan& plan_;
  const ArmDescription& arm_;
  Certificate& certificate_;
};

}  // namespace

void check_frames(const Plan& plan, const ArmDescription& arm, Certificate& certificate) {
  FrameChecks(plan, arm, certificate).run();
}

}  // namespace limber
