#pragma once
// For those who ask a model where the arm goes.

#include <string>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"
#include "limber/arm/valve_model.hpp"
#include "limber/forward/forward_model.hpp"

namespace limber {

/// Everything that decides an arm's future under set points: the valve state (set points,
/// pressures, delayed set points; arm/valve_model.hpp) and the backbone.
struct MotionState {
  Eigen::Index segments = 0;  ///< n
  Eigen::VectorXf valves;     ///< a valve state: pressures, last set points, those before
  Backbone backbone;          ///< m×3
  Backbone before = {};  ///< m×3, a frame earlier; empty where the model does not read velocities

  auto pressure_kpa() const { return valves.head(segments); }
  auto setpoint_kpa() const { return valves.segment(segments, segments); }
  bool operator==(const MotionState& other) const {
    return valves == other.valves && backbone == other.backbone && before == other.before;
  }
};

/// Set points to backbones, frame by frame: the valves V and after them the forward model F
/// (docs/valves.md), p_t = V(p_{t−1}, set points), B_t = F(p_{t−1}, p_t, B_{t−2}, B_{t−1}). Every
/// prediction of a motion goes through this one function. It is a pure function of its state.
///
/// Borrows the forward model, holds the valves. Threads: constant after construction; each thread
/// brings its own Workspace.
class MotionModel {
 public:
  using Workspace = ForwardModel::Workspace;

  /// Ideal valves: pressures are the set points. Implicit, because most callers start with a
  /// forward model.
  MotionModel(const ForwardModel& forward);  // NOLINT(google-explicit-constructor)
  MotionModel(ForwardModel&& forward) = delete;
  /// @throws InputError for valves of another number of channels, or before a network that learnt
  /// from set points.
  MotionModel(const ForwardModel& forward, ValveModel valves);
  MotionModel(ForwardModel&& forward, ValveModel valves) = delete;

  const ForwardModel& forward() const { return *forward_; }
  const ValveModel& valves() const { return valves_; }
  /// The same forward model behind ideal valves.
  MotionModel without_valves() const { return MotionModel(*forward_); }

  int segment_count() const { return forward_->segment_count(); }
  int channel_count() const { return forward_->channel_count(); }
  int point_count() const { return forward_->point_count(); }
  bool has_network() const { return forward_->has_network(); }
  /// Whether states hold the backbone of a frame earlier.
  bool reads_velocity() const { return forward_->reads_velocity(); }
  const NoLoadModel& no_load() const { return forward_->no_load(); }
  /// @pre has_network()
  const CompensationModel& compensation() const { return forward_->compensation(); }

  /// The state of an arm at rest at `kpa` with this backbone.
  MotionState settled_state(const Eigen::Ref<const Pressures>& kpa,
                            const Eigen::Ref<const Backbone>& backbone) const;

  /// The state of an arm with these valves that had the backbone `before` a frame earlier.
  MotionState moving_state(Eigen::VectorXf valves, const Eigen::Ref<const Backbone>& backbone,
                           const Eigen::Ref<const Backbone>& before) const;

  /// One frame at `setpoint_kpa`: `state` becomes what follows it. Unchecked, as
  /// ForwardModel::step.
  void step(const Eigen::Ref<const Pressures>& setpoint_kpa, MotionState& state,
            Workspace& workspace) const;
  /// Its part behind the valves: the shape after a frame in which the pressures change from the
  /// first to the second.
  /// @param before  a frame earlier; stays as it is where the model does not read velocities
  void step_shape(const Eigen::Ref<const Pressures>& before_kpa,
                  const Eigen::Ref<const Pressures>& pressure_kpa, Backbone& before,
                  Backbone& backbone, Workspace& workspace) const;

  /// Estimate of where the tip of a moving arm comes to rest at its last set points: each segment
  /// is turned about its middle, and lengthened, by what the no-load model says of the pressure
  /// change still to come. Exactly the tip if none is to come, or if the no-load model never bends.
  /// Takes no query.
  Pose settled_tip(const Eigen::Ref<const Eigen::VectorXf>& valves,
                   const Eigen::Ref<const Backbone>& backbone) const;

 private:
  const ForwardModel* forward_;
  ValveModel valves_;
};

/// What arm and model pass to each other has to fit: nothing in the loops behind it asks again.
/// @param where  who takes both
/// @throws InputError naming both arms where the model's channels, or its segments' gaps, are not
/// as many as the arm's.
void require_model_of_arm(const ArmDescription& arm, const MotionModel& model,
                          const std::string& where);

/// For a model that takes set points for the pressures though it learnt from pressures: a sentence
/// that says so, and why no valves are known. Empty: it has valves, or needs none.
std::string why_valves_are_missing(const MotionModel& model);

}  // namespace limber
