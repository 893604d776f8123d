#pragma once
// For those who ask a model where the arm goes.

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/arm/valve_parameters.hpp"

namespace limber {

/// One segment's pressure over one frame in closed form: docs/valves.md, (P1) to (P4). Continuous
/// in pressure and set points. Computed in double precision also for states in float, so that these
/// differ from states in double by no more than their own rounding.
///
/// Threads: constant after construction; share it freely. Allocates nothing.
class ValveMotion {
 public:
  /// @pre the parameters are usable (`why_unusable`); frame_period_s > 0.
  ValveMotion(const SegmentValves& valves, bool has_sides, double frame_period_s)
      : has_sides_(has_sides), dead_band_(valves.dead_band_kpa) {
    // Parts of a frame shorter than this are dropped: 0.15 s at 20 Hz are three frames.
    constexpr double kRounding = 1e-6;
    const double frames = valves.dead_time_s / frame_period_s;
    frames_late_ = int(std::floor(frames + kRounding));
    const double fraction = frames - frames_late_;
    splits_ = fraction > kRounding;
    const double first_s = splits_ ? fraction * frame_period_s : 0.0;
    first_ = Part(valves, first_s);
    rest_ = Part(valves, frame_period_s - first_s);
  }

  /// j and whether f > 0, of a dead time of (j + f) frames, 0 ≤ f < 1.
  int frames_late() const { return frames_late_; }
  bool splits() const { return splits_; }
  /// Number of set points before the current one that may still be delayed.
  int pending_setpoints() const { return frames_late_ + (splits_ ? 1 : 0); }

  /// Pressure after one frame: toward `older`, the set point of j + 1 frames ago, until the delayed
  /// switch, then toward `newer`, that of j frames ago. `older` counts only where `splits()`.
  double after_frame(double pressure, double older, double newer) const {
    if (splits_) {
      pressure = after(first_, pressure, older);
    }
    return after(rest_, pressure, newer);
  }

 private:
  /// One direction over one part of a frame.
  struct Direction {
    Direction() = default;
    Direction(const ValveDirection& direction, double part_s) {
      constexpr double kInstantS = 1e-6;  // far below a frame: a jump
      const double tau = direction.time_constant_s < kInstantS ? 0.0 : direction.time_constant_s;
      const double limit = direction.rate_limit_kpa_per_s;
      time_constant = tau;
      inverse_time_constant = tau > 0.0 ? 1.0 / tau : 0.0;
      rate = limit;
      inverse_rate = 1.0 / limit;
      knee = tau > 0.0 ? tau * limit : 0.0;
      decay = tau > 0.0 ? std::exp(-part_s / tau) : 0.0;
    }

    /// What is left of `distance` after `time`: rate-limited above the knee, exponential below.
    double left_after(double distance, double time) const {
      const double limited_time = std::max(distance - knee, 0.0) * inverse_rate;
      return limited_time > time ? distance - rate * time
                                 : std::min(distance, knee) *
                                       std::exp((limited_time - time) * inverse_time_constant);
    }
    /// The same over the whole part.
    double left_after_part(double distance, double part) const {
      return distance <= knee ? distance * decay : left_after(distance, part);
    }
    /// Time from `distance` down to `end`, 0 < end ≤ distance.
    double time_to(double distance, double end) const {
      const double limited = std::max(distance - std::max(end, knee), 0.0) * inverse_rate;
      return knee > 0.0 ? limited + time_constant *
                                        std::log(std::min(distance, knee) / std::min(end, knee))
                        : limited;
    }

    double time_constant = 0.0, inverse_time_constant = 0.0;
    double rate = 0.0, inverse_rate = 0.0;
    double knee = 0.0;   // distance below which the rate limit does not bind
    double decay = 0.0;  // over the whole part
  };

  /// A part of a frame with one set point.
  struct Part {
    Part() = default;
    Part(const SegmentValves& valves, double part_s)
        : time(part_s), inflating(valves.inflating, part_s), venting(valves.venting, part_s) {}
    double time = 0.0;
    Direction inflating, venting;
  };

  double after(const Part& part, double pressure, double setpoint) const {
    const double error = setpoint - pressure;
    const double distance = std::abs(error);
    if (distance <= dead_band_) {
      return pressure;
    }
    const bool vents = has_sides_ ? error * pressure < 0.0 : error < 0.0;
    const Direction& direction = vents ? part.venting : part.inflating;
    double left = direction.left_after_part(distance, part.time);
    const double beyond_zero = std::abs(setpoint);
    if (vents && has_sides_ && left < beyond_zero && setpoint * pressure < 0.0 &&
        dead_band_ < beyond_zero) {
      // One side is empty before the end; the other inflates for what is left of the time.
      const double venting_time = part.venting.time_to(distance, beyond_zero);
      left = part.inflating.left_after(beyond_zero, std::max(part.time - venting_time, 0.0));
    }
    return setpoint - std::copysign(std::max(left, dead_band_), error);
  }

  bool has_sides_;
  double dead_band_;
  int frames_late_ = 0;
  bool splits_ = false;
  Part first_, rest_;
};

/// Set points to pressures, frame by frame: docs/valves.md. A continuous map, so that float and
/// double agree.
///
/// The future depends on a *valve state* of one column: the pressures (n), then the last set points
/// (n), then the ones before, as many as the dead time may still delay. The last set points are
/// always there, also for ideal valves, so that a state says what was commanded and what came of
/// it.
///
/// Threads: constant after construction; share it freely. Allocates nothing in `step`.
class ValveModel {
 public:
  /// Ideal valves: pressures are the set points.
  explicit ValveModel(const ArmDescription& arm);
  /// The same of an arm of so many segments.
  static ValveModel ideal(int segment_count);
  /// @throws InputError if the parameters do not fit the arm or are out of range.
  ValveModel(const ArmDescription& arm, ValveParameters parameters);

  bool is_ideal() const { return parameters_.is_ideal(); }
  const ValveParameters& parameters() const { return parameters_; }
  int segment_count() const { return segment_count_; }
  /// Set points that a state holds for each segment, ≥ 1.
  int setpoint_count() const { return setpoint_count_; }
  /// n (1 + setpoint_count()).
  int state_size() const { return segment_count_ * (1 + setpoint_count_); }

  /// The settled state of an arm at these set points: the pressures equal them.
  Eigen::VectorXf settled_state(const Eigen::Ref<const Pressures>& kpa) const;

  /// One frame at `setpoint_kpa` (n): `state` (state_size()) is overwritten with what follows it.
  void step(const Eigen::Ref<const Pressures>& setpoint_kpa,
            Eigen::Ref<Eigen::VectorXf> state) const;

  /// Pressures along set points n×T from a settled start at (setpoints 0): n×T in double precision,
  /// column k after frame k; column 0 is the given start.
  Eigen::MatrixXd run(const Eigen::Ref<const Eigen::MatrixXd>& setpoint_kpa,
                      const Eigen::Ref<const Eigen::VectorXd>& first_pressure_kpa) const;

  /// Frames until the pressures of `state` stay within `tolerance_kpa` of its last set points, at
  /// most `most`.
  int frames_to_settle(const Eigen::Ref<const Eigen::VectorXf>& state,
                       const Eigen::Ref<const Pressures>& tolerance_kpa, int most) const;

 private:
  explicit ValveModel(int segment_count) : segment_count_(segment_count) {}

  ValveParameters parameters_;
  int segment_count_ = 0;
  int setpoint_count_ = 1;
  std::vector<ValveMotion> motions_;  // empty for ideal valves
};

}  // namespace limber
