#pragma once
// For those who ask a model where the arm goes.

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/arm/valve_motion.hpp"
#include "limber/arm/valve_parameters.hpp"

namespace limber {

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
  explicit ValveModel(int segment_count) : segment_count_(segment_count) {}

  ValveParameters parameters_;
  int segment_count_ = 0;
  int setpoint_count_ = 1;
  std::vector<ValveMotion> motions_;  // empty for ideal valves
};

}  // namespace limber
