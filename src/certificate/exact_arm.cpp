#include "exact_arm.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace limber {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
/// Parts of a frame shorter than this are rounding: a dead time of 0.15 s at 20 Hz is three frames.
constexpr double kRoundingFrames = 1e-6;

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

using Complex = std::complex<double>;

double sinc(double x) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

Complex direction(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// `step` seen from `pose`, in B.
Pose composed(const Pose& pose, const Pose& step) {
  const Complex offset = direction(pose.theta_rad) * Complex(step.x_m, step.y_m);
  return {pose.x_m + offset.real(), pose.y_m + offset.imag(), pose.theta_rad + step.theta_rad};
}

/// `to` seen from `from`.
Pose relative(const Pose& from, const Pose& to) {
  const Complex offset = direction(-from.theta_rad) * Complex(to.x_m - from.x_m, to.y_m - from.y_m);
  return {offset.real(), offset.imag(), to.theta_rad - from.theta_rad};
}

/// The end of an arc that starts along x and turns by `theta`.
Pose arc_of(double length, double theta) {
  const Complex chord = length * sinc(theta / 2.0) * direction(theta / 2.0);
  return {chord.real(), chord.imag(), theta};
}

/// (17) and (18): the segment turns by its command, or not at all, and keeps its length.
Pose unstretched_gap(const Segment& segment, double curvature_per_m) {
  const double length = segment.length_m / segment.gaps;
  return arc_of(length, curvature_per_m * length);
}

/// (9): the strain of one side; beyond the segment's largest limit it goes on along P's end slope,
/// which is no less than 0.
double contraction(const Segment& segment, double size_kpa) {
  const double inside_kpa = std::min(size_kpa, segment.pressure_limit_kpa.largest_kpa());
  double strain = 0.0;
  double slope = 0.0;
  for (int k = 4; k >= 1; --k) {
    const double sum = strain + segment.strain_polynomial[k - 1];
    slope = slope * inside_kpa + sum;
    strain = sum * inside_kpa;
  }
  return strain + std::max(0.0, slope) * (size_kpa - inside_kpa);
}

/// One gap of an unloaded segment: the contracted side is e·l0 shorter than the other, a width t
/// apart, so the whole segment turns by e·l0/t, and its middle is (1 − e/2) l0 long.
Pose unloaded_gap(const Segment& segment, double pressure_kpa) {
  const double strain = contraction(segment, std::abs(pressure_kpa));
  const double turn = strain * segment.length_m / segment.width_m / segment.gaps;
  return arc_of((1.0 - strain / 2.0) * segment.length_m / segment.gaps,
                pressure_kpa > 0.0 ? -turn : turn);
}

/// The same of segment i, whatever its arm's command is.
Pose gap_at(const ArmDescription& arm, std::size_t i, double command) {
  const Segment& segment = arm.segments[i];
  switch (arm.no_load) {
    case NoLoadKind::curvature:
      return unstretched_gap(segment, segment.curvature_per_unit * command);
    case NoLoadKind::straight:
      return unstretched_gap(segment, 0.0);
    default:
      return unloaded_gap(segment, command);
  }
}

void append(std::vector<double>& list, const Pose& pose) {
  list.insert(list.end(), {pose.x_m, pose.y_m, pose.theta_rad});
}

Pose pose_at(const std::vector<double>& list, std::size_t index) {
  return {list[kPoseSize * index], list[kPoseSize * index + 1], list[kPoseSize * index + 2]};
}

/// A shape as the network sees it: every plate about the base, or about the plate before it.
std::vector<double> coordinates(const ExactArm::Shape& shape, BackboneLayout layout) {
  std::vector<double> list;
  list.reserve(kPoseSize * shape.size());
  if (layout == BackboneLayout::base_poses) {
    for (const Pose& pose : shape) {
      append(list, pose);
    }
    return list;
  }
  for (std::size_t i = 1; i < shape.size(); ++i) {
    append(list, relative(shape[i - 1], shape[i]));
  }
  return list;
}

ExactArm::Shape shape_of(const std::vector<double>& list, BackboneLayout layout) {
  ExactArm::Shape shape;
  shape.reserve(list.size() / kPoseSize + 1);
  if (layout == BackboneLayout::gap_poses) {
    shape.push_back(Pose{});
  }
  for (std::size_t i = 0; kPoseSize * i < list.size(); ++i) {
    const Pose pose = pose_at(list, i);
    shape.push_back(layout == BackboneLayout::base_poses ? pose : composed(shape.back(), pose));
  }
  return shape;
}

/// (5): the unloaded shape plus the output; or (16): the previous shape, pulled by the gate toward
/// the unloaded one, plus the change. The gates' arguments come after the changes.
std::vector<double> combined(OutputForm form, const std::vector<double>& previous,
                             const std::vector<double>& unloaded,
                             const std::vector<double>& output) {
  std::vector<double> result;
  result.reserve(unloaded.size());
  for (std::size_t i = 0; i < unloaded.size(); ++i) {
    if (form == OutputForm::compensation) {
      result.push_back(unloaded[i] + output[i]);
    } else {
      const double gate = 1.0 / (1.0 + std::exp(-output[unloaded.size() + i]));
      result.push_back((1.0 - gate) * previous[i] + gate * unloaded[i] + output[i]);
    }
  }
  return result;
}

/// (20): the step keeps its direction and the gap's bounds decide its length; so does the turn.
Pose within(const GapBounds& bounds, std::size_t gap, const Pose& step) {
  const auto i = Eigen::Index(gap);
  const double length = std::hypot(step.x_m, step.y_m);
  const double kept =
      std::clamp(length, double(bounds.min_length_m[i]), double(bounds.max_length_m[i]));
  const Complex direction =
      length < 1e-6 ? Complex(1.0, 0.0) : Complex(step.x_m, step.y_m) / length;
  const double turn =
      std::clamp(step.theta_rad, double(bounds.min_turn_rad[i]), double(bounds.max_turn_rad[i]));
  return {kept * direction.real(), kept * direction.imag(), turn};
}

/// The coordinates of a shape whose gaps keep the bounds; its base is at the origin.
std::vector<double> bounded(const GapBounds& bounds, const std::vector<double>& list,
                            BackboneLayout layout) {
  std::vector<double> result;
  result.reserve(list.size());
  if (layout == BackboneLayout::gap_poses) {
    for (std::size_t gap = 0; kPoseSize * gap < list.size(); ++gap) {
      append(result, within(bounds, gap, pose_at(list, gap)));
    }
    return result;
  }
  Pose given;
  Pose now;
  append(result, now);
  for (std::size_t plate = 1; kPoseSize * plate < list.size(); ++plate) {
    const Pose next = pose_at(list, plate);
    const Pose step =
        within(bounds, plate - 1,
               {next.x_m - given.x_m, next.y_m - given.y_m, next.theta_rad - given.theta_rad});
    given = next;
    now = {now.x_m + step.x_m, now.y_m + step.y_m, now.theta_rad + step.theta_rad};
    append(result, now);
  }
  return result;
}

}  // namespace

std::vector<double> ExactValves::segment_pressures(const SegmentValves& valves, double start_kpa,
                                                   std::size_t before,
                                                   const std::vector<double>& setpoints_kpa) const {
  const double period_s = 1.0 / arm_.frame_rate_hz;
  const double rounding_s = kRoundingFrames * period_s;
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
      if (next_s <= now_s + rounding_s) {
        ++in_force;
        continue;
      }
      const double until_s = next_s < end_s - rounding_s ? next_s : end_s;
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

ExactArm::Shape ExactArm::no_load(const std::vector<double>& pressures_kpa) const {
  Shape shape{Pose{}};
  for (std::size_t i = 0; i < arm_.segments.size(); ++i) {
    const Pose gap = gap_at(arm_, i, pressures_kpa[i]);
    for (int g = 0; g < arm_.segments[i].gaps; ++g) {
      shape.push_back(composed(shape.back(), gap));
    }
  }
  return shape;
}

ExactArm::ExactArm(const ArmDescription& arm, const CompensationModel* network) : arm_(arm) {
  if (network != nullptr) {
    layout_ = network->layout;
    form_ = network->form;
    reads_velocity_ = network->reads_velocity;
    bounds_ = network->bounds;
    network_.emplace(*network);
  }
}

std::array<ExactArm::Shape, 2> ExactArm::next_two(const std::vector<double>& previous_kpa,
                                                  const std::vector<double>& current_kpa,
                                                  const std::array<Past, 2>& past,
                                                  ExactNetwork::Workspace& workspace) const {
  if (!network_) {
    const Shape free = no_load(current_kpa);
    return {free, free};
  }
  std::vector<double> unloaded;
  std::vector<double> unloaded_input;
  if (layout_ == BackboneLayout::base_poses) {
    unloaded = coordinates(no_load(current_kpa), layout_);
    unloaded_input = unloaded;
  } else {
    for (std::size_t i = 0; i < arm_.segments.size(); ++i) {
      const Pose gap = gap_at(arm_, i, current_kpa[i]);
      for (int g = 0; g < arm_.segments[i].gaps; ++g) {
        append(unloaded, gap);
      }
      append(unloaded_input, gap);  // one gap stands for all of its segment
    }
  }
  std::array<std::vector<double>, 2> before;
  for (std::size_t c = 0; c < 2; ++c) {
    before[c] = coordinates(*past[c].previous, layout_);
    std::vector<double>& input = workspace.input[c];
    input.clear();
    const std::array<const std::vector<double>*, 4> parts{&previous_kpa, &current_kpa, &before[c],
                                                          &unloaded_input};
    for (const std::vector<double>* part : parts) {
      input.insert(input.end(), part->begin(), part->end());
    }
    if (reads_velocity_) {
      const std::vector<double> earlier = coordinates(*past[c].before, layout_);
      for (std::size_t i = 0; i < earlier.size(); ++i) {
        input.push_back(before[c][i] - earlier[i]);
      }
    }
  }
  network_->run(workspace);
  std::array<Shape, 2> answers;
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<double> next = combined(form_, before[c], unloaded, workspace.output[c]);
    if (bounds_) {
      next = bounded(*bounds_, next, layout_);
    }
    answers[c] = shape_of(next, layout_);
  }
  return answers;
}

}  // namespace limber
