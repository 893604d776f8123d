#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

/// How one segment's pressure moves in one direction.
struct ValveDirection {
  double time_constant_s = 0.0;       ///< ≥ 0; 0 follows at once
  double rate_limit_kpa_per_s = 0.0;  ///< > 0; +∞ where nothing limits it
  bool operator==(const ValveDirection&) const = default;
};

/// One segment's valves and their pressure controller (docs/valves.md).
struct SegmentValves {
  ValveDirection inflating;  ///< away from zero; rising where the command has no sides
  ValveDirection venting;    ///< toward zero; falling where the command has no sides
  double dead_time_s = 0.0;  ///< from a set point to the first effect, ≥ 0, not in whole frames
  double dead_band_kpa = 0.0;  ///< the valves stay closed within this distance of the set point, ≥ 0
  bool operator==(const SegmentValves&) const = default;
};

/// Parameters of the valve model V of p_t = V(p_{t−1}, set points) as plain values: schema
/// limber/valves/1.
struct ValveParameters {
  /// A pressure has two sides, of which one vents before the other inflates; a curvature or an
  /// angle has none.
  bool has_sides = true;
  std::vector<SegmentValves> segments;  ///< empty: ideal valves, pressures are the set points

  bool is_ideal() const { return segments.empty(); }
  /// Of everything that a prediction depends on; empty for ideal valves.
  std::string hash() const;
};

/// Set points to pressures, frame by frame. A continuous map, so that float and double agree.
///
/// What the future depends on is a *valve state* of one column: the pressures (n), then the last
/// set points (n), then the ones before, as many as may still be under way through the dead time.
/// The last set points are always there, also for ideal valves, so that a state says what was
/// commanded and what came of it.
///
/// Threads: constant after construction; share it freely. Allocates nothing in `step`.
class ValveModel {
 public:
  /// Ideal valves: pressures are the set points.
  explicit ValveModel(const ArmDescription& arm);
  /// @throws InputError where the parameters do not fit the arm or are out of range.
  ValveModel(const ArmDescription& arm, ValveParameters parameters);

  bool is_ideal() const { return parameters_.is_ideal(); }
  const ValveParameters& parameters() const { return parameters_; }
  int segment_count() const { return segment_count_; }
  /// Set points that a state holds for each segment, ≥ 1.
  int setpoint_count() const { return setpoint_count_; }
  /// n (1 + setpoint_count()).
  int state_size() const { return segment_count_ * (1 + setpoint_count_); }

  /// The state of an arm that has stood at these set points for ever, at the same pressures.
  Eigen::VectorXf settled_state(const Eigen::Ref<const Pressures>& kpa) const;

  /// One frame at `setpoint_kpa` (n): `state` (state_size()) is overwritten with what follows it.
  void step(const Eigen::Ref<const Pressures>& setpoint_kpa,
            Eigen::Ref<Eigen::VectorXf> state) const;
  /// k states side by side: n×k, state_size()×k; column by column to the bit as `step`.
  void step_batch(const Eigen::Ref<const Eigen::MatrixXf>& setpoint_kpa,
                  Eigen::Ref<Eigen::MatrixXf> states) const;

  /// Pressures along set points n×T from a settled start at (setpoints 0): n×T in double precision,
  /// column k after frame k; column 0 is the given start.
  Eigen::MatrixXd run(const Eigen::Ref<const Eigen::MatrixXd>& setpoint_kpa,
                      const Eigen::Ref<const Eigen::VectorXd>& first_pressure_kpa) const;

  /// Frames until the pressures of `state` stay within `tolerance_kpa` of its last set points, at
  /// most `most`.
  int frames_to_settle(const Eigen::Ref<const Eigen::VectorXf>& state,
                       const Eigen::Ref<const Pressures>& tolerance_kpa, int most) const;

 private:
  ValveParameters parameters_;
  int segment_count_ = 0;
  int setpoint_count_ = 1;
  double frame_period_s_ = 0.0;
};

}  // namespace limber
