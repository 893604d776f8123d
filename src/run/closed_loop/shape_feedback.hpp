#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/arm/valve_model.hpp"

namespace limber {

/// Keeps an arm in motion at the shapes that its plan has: each segment's pressure is moved off the
/// plan's by what its bend misses. A bend is the turn from the plate where a segment begins to the
/// one where it ends. So under a load, friction or wear that the model does not know, the whole
/// backbone stays near the plan, and not the tip alone. A PI controller in velocity form,
///
///   trim_t = trim_{t−1} + (K_p (e_t − e_{t−1}) + K_i Δt e_t) / s,   e = φ_plan − φ,
///
/// where s is what a kPa turns the unloaded segment by, the mean over its limits. What the frame
/// rule or a limit takes off is forgotten, so nothing winds up. A segment that the no-load model
/// hardly bends is left alone. An arm that follows its set points within a frame, and bends by up
/// to three times what the model says, is kept as well as one that valves make slow, but with
/// smaller gains: those for the slow one would have it swing.
///
/// A value: a copy goes on as this one would.
class ShapeFeedback {
 public:
  ShapeFeedback(const ArmDescription& arm, const NoLoadModel& model, const ValveModel& valves);

  /// No set point is off any more, and nothing was missed before.
  void forget();
  /// The arm came to `shape` in a frame in which its plan has it at `planned`.
  void learn(const Backbone& planned, const Backbone& shape);
  /// In place of the plan's set points. Keeps the limits, and the frame rule after `before_kpa`.
  /// @param limits  one for each segment; empty: the arm's
  Pressures setpoint(const Pressures& planned_kpa, const Pressures& before_kpa,
                     const std::vector<PressureLimits>& limits);
  /// Where the arm is beside where its plan has it: its shape less the plan's, as learnt last.
  const Backbone& off_plan() const { return off_plan_; }

 private:
  Eigen::VectorXd bends_rad(const Backbone& backbone) const;

  std::vector<PressureLimits> limits_;
  std::vector<Eigen::Index> plates_;  // size n + 1: where segments begin and end
  Eigen::VectorXd kpa_per_rad_;       // size n; 0: left alone
  double proportional_;
  double integral_per_s_;
  double step_limit_kpa_;
  double frame_period_s_;
  Eigen::VectorXd trim_kpa_;    // size n
  Eigen::VectorXd missed_rad_;  // in the frame before; empty: none
  Backbone off_plan_;
};

}  // namespace limber
