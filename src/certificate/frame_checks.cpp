#include "frame_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kMaxTurnRad = std::numbers::pi;  // of one gap; beyond there is no such arc

constexpr double kRounding = 1e-12;  // of a radius that was multiplied once

bool is_room(double value) {
  return std::isfinite(value) && value >= 0.0;
}

/// Why these are no radii of the arm; empty: they are.
std::string why_no_radii(const PlanTube& tube, const ArmDescription& arm) {
  if (int(tube.plate_radius_m.size()) != arm.point_count()) {
    return fmt::format("{} radii; the arm has {} plates", tube.plate_radius_m.size(),
                       arm.point_count());
  }
  for (const double radius : tube.plate_radius_m) {
    if (!is_room(radius)) {
      return fmt::format("a radius of {} m; expected at least 0", radius);
    }
  }
  const double share = tube.growth.start_share;
  if (!(share > 0.0 && share <= 1.0) || !is_room(tube.growth.full_after_m)) {
    return fmt::format(
        "{} of its width at the start, all of it after {} m; expected a share of "
        "more than 0 and at most 1, and at least 0 m",
        share, tube.growth.full_after_m);
  }
  return is_room(tube.end_radius_m) && is_room(tube.end_heading_rad)
             ? ""
             : "a width of its end that is not at least 0";
}

/// Why the network does not promise that; empty: it does.
std::string why_not_promised(const PlanTube& tube, const CompensationModel* network) {
  const TubeLevel* promised =
      network != nullptr && network->tube ? network->tube->find(tube.level) : nullptr;
  if (promised == nullptr) {
    return fmt::format("the model promises no tube of {:.6g} % of runs", 100.0 * tube.level);
  }
  const auto is_narrower = [&](double radius, double scale) {
    return radius < promised->factor * scale - kRounding;
  };
  const std::vector<double>& scale_m = network->tube->plate_scale_m;
  for (std::size_t i = 0; i < scale_m.size() && i < tube.plate_radius_m.size(); ++i) {
    if (is_narrower(tube.plate_radius_m[i], scale_m[i])) {
      return fmt::format("{} has {:.3f} mm; the model promises {:.3f} mm", plate_name(int(i)),
                         tube.plate_radius_m[i] * 1e3, promised->factor * scale_m[i] * 1e3);
    }
  }
  const RoomGrowth& growth = network->tube->growth;
  if (!growth.is_constant() ? tube.growth.start_share < growth.start_share - kRounding ||
                                  tube.growth.full_after_m > growth.full_after_m + kRounding
                            : !tube.growth.is_constant()) {
    return fmt::format(
        "it grows from {:.3g} of its width over {:.3g} m; the model promises no "
        "less than {:.3g}, and all of it after {:.3g} m",
        tube.growth.start_share, tube.growth.full_after_m, growth.start_share, growth.full_after_m);
  }
  return is_narrower(tube.end_radius_m, network->tube->end_scale_m) ||
                 is_narrower(tube.end_heading_rad, network->tube->end_heading_scale_rad)
             ? "its end is narrower than the model promises"
             : "";
}

constexpr double kSetpointShare = 1e-6;  // of the largest command: several roundings of a float32
constexpr double kCost = 1e-6;           // relative
constexpr double kFrames = 1e-4;    // a motion so near a whole number of frames may take either
constexpr double kGoalHoldS = 1.0;  // docs/planning.md, Goal
// No plate is there; coordinates of environments end long before.
constexpr double kFarthestM = 1e4;

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
  double rounding_kpa(Eigen::Index segment) const {
    return kSetpointShare * arm_.limits_of_channel(int(segment)).largest_kpa();
  }
  void fail(const char* check, std::size_t frame, std::string message) {
    certificate_.failures.push_back({check, int(frame), std::move(message)});
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
        const double pressure = double(plan_.frames[k].setpoint_kpa[i]);
        const PressureLimits& own = arm_.segments[i].pressure_limit_kpa;
        const bool is_in_own = is_within(pressure, own);
        if (!is_in_own || (!plan_.limits.empty() && !is_within(pressure, plan_.limits[i]))) {
          fail("limits", k,
               fmt::format("{} at {} {unit}; {} limits are {} {unit}", segment_name(i), pressure,
                           is_in_own ? "the plan's own" : "its",
                           to_string(is_in_own ? plan_.limits[i] : own),
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
        if (!(step <= step_limit + rounding_kpa(i)) && !reported) {
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
    const auto needed = std::size_t(std::ceil(kGoalHoldS * arm_.frame_rate_hz - 1e-9));
    const auto held = std::size_t(std::max(0, plan_.hold_frame_count));
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
        if (!(std::abs(double(setpoint[i]) - expected) <= rounding_kpa(i))) {
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
      const auto min_frames = std::size_t(std::max(1.0, std::ceil(frames - kFrames)));
      const auto max_frames = std::size_t(std::max(1.0, std::ceil(frames + kFrames)));
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
    if (at + std::size_t(std::max(0, plan_.hold_frame_count)) + 1 != plan_.frames.size()) {
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

std::vector<double> numbers(const Pressures& kpa) {
  return {kpa.begin(), kpa.end()};
}

ExactArm::Shape shape_of(const Backbone& backbone) {
  ExactArm::Shape shape;
  shape.reserve(backbone.rows());
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    shape.push_back({double(backbone(i, 0)), double(backbone(i, 1)), double(backbone(i, 2))});
  }
  return shape;
}

bool is_drawable(const ExactArm::Shape& shape) {
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const bool is_near = std::hypot(shape[i].x_m, shape[i].y_m) <= kFarthestM;  // no NaN is
    if (!is_near || !std::isfinite(shape[i].theta_rad) ||
        (i > 0 && std::abs(shape[i].theta_rad - shape[i - 1].theta_rad) > kMaxTurnRad)) {
      return false;
    }
  }
  return true;
}

bool raise_to(double& largest, double found) {
  const bool is_larger = !(found <= largest);
  largest = is_larger ? found : largest;
  return is_larger;
}

Deviation deviation(const ExactArm::Shape& own, const ExactArm::Shape& stored) {
  Deviation largest;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const double x = own[i].x_m - stored[i].x_m;
    const double y = own[i].y_m - stored[i].y_m;
    const double apart = std::sqrt(x * x + y * y);
    if (raise_to(largest.apart_m, apart)) {
      largest.plate = int(i);
    }
    raise_to(largest.turned_rad, std::abs(own[i].theta_rad - stored[i].theta_rad));
  }
  return largest;
}

void check_tube(const Plan& plan, const CompensationModel* network, const ArmDescription& arm,
                Certificate& certificate) {
  if (!plan.tube) {
    return;
  }
  std::string why = why_no_radii(*plan.tube, arm);
  if (why.empty()) {
    why = why_not_promised(*plan.tube, network);
  }
  if (!why.empty()) {
    certificate.failures.push_back({"tube", -1, std::move(why)});
  }
}

ExactStart exact_start(const Environment& environment, const ArmDescription& arm,
                       const ExactArm& model) {
  ExactStart result;
  if (!environment.start) {
    result.pressure_kpa.assign(arm.segments.size(), 0.0);
    result.setpoint_kpa = result.pressure_kpa;
    result.shape = model.no_load(result.pressure_kpa);
    result.before = result.shape;
    return result;
  }
  const ArmStart& start = *environment.start;
  result.pressure_kpa = numbers(start.pressures_kpa);
  result.setpoint_kpa =
      start.setpoints_kpa.empty() ? result.pressure_kpa : numbers(start.setpoints_kpa.front());
  result.shape = shape_of(start.backbone);
  result.before = start.before.rows() > 0 ? shape_of(start.before) : result.shape;
  for (std::size_t back = 1; back < start.setpoints_kpa.size(); ++back) {
    result.before_kpa.push_back(numbers(start.setpoints_kpa[back]));
  }
  return result;
}

void check_frames(const Plan& plan, const ArmDescription& arm, Certificate& certificate) {
  FrameChecks(plan, arm, certificate).run();
}

}  // namespace limber
