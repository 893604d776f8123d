#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"
#include "limber/forward/motion_model.hpp"

namespace limber {

/// From one pose to another: x, y, and theta by the shorter turn.
Eigen::Vector3d difference(const Pose& pose, const Pose& other);

/// What a model misses of a tip that comes to rest: how far it has a held arm creep, which no arm
/// does, and how far beside their predictions short motions from rest ended. A value.
class RestMiss {
 public:
  /// Under a load, or with more friction than it learnt, a model has an arm that is just held drift
  /// away. The arm does not, so that drift is taken off what the model says of motions from there.
  /// @param rest  where the arm is held  @param frames  that it is held for
  void note_creep(const MotionModel& model, const Pressures& held_kpa, int frames,
                  const Backbone& rest);
  void forget_creep() { creep_.clear(); }
  /// A motion that began where the creep was noted has ended. At most 10 cm are learnt.
  void learn(const Pose& expected, const Pose& measured);

  /// After so many frames; it has ended with the hold.
  Eigen::Vector3d creep(std::size_t frame = std::numeric_limits<std::size_t>::max()) const;
  /// How far beside the model's end a motion from there is likely to end.
  Eigen::Vector3d expected() const { return kShare * (bias_ - creep()); }

 private:
  /// Of creep and bias: arms that are hardly moved show all of the creep, others next to none.
  static constexpr double kShare = 0.5;

  Eigen::Vector3d bias_ = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> creep_;  // after each frame
};

}  // namespace limber
