#pragma once
// For those who plan.

#include <limits>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/obstacle_shape.hpp"

namespace limber {

class BroadPhase;

/// Smallest distance between the arm's outside and an obstacle.
struct Clearance {
  double value_m = 0.0;  ///< negative: how deep the arm is in the obstacle; +∞ without obstacles
  int gap = -1;  ///< between plates gap and gap + 1, from 0 at the base; −1 without obstacles
  int obstacle = -1;  ///< index in the environment's list
};

/// Room for the model's error about a moving arm, beside a margin (docs/tube.md).
struct PlateRoom {
  std::vector<double> full_m;  ///< ≥ 0, one per plate; or none at all
  RoomGrowth growth = {};
  Backbone start = {};  ///< m×3, from where it grows; unused where it does not
};

/// Collision of a thick backbone with the obstacles of an environment (docs/planning.md).
///
/// Shape:   between two successive plates, the arc of constant curvature through both that turns
///          by the difference of their headings (at most half a turn), thickened on all sides by
///          half the width of its segment + the arm's actuator radius + a margin + the larger room
///          of its two plates; in a motion, that of both its ends. The base counts; the arm's
///          collision with itself does not. What turns by more is no arc, and never free.
/// Bounds:  never misses; a reported value is at most kTolerance below the true one.
/// Threads: constant after construction; share it freely. Nothing allocates after construction.
class CollisionChecker {
 public:
  static constexpr double kToleranceM = 0.001;  ///< false alarms only this close to touching

  /// @param margin_m  added to the arm's radius everywhere, ≥ 0.
  /// @throws InputError for a margin or room out of range, or an obstacle that is none.
  CollisionChecker(const ArmDescription& arm, const std::vector<Obstacle>& obstacles,
                   double margin_m = 0.0, PlateRoom room = {});
  CollisionChecker(CollisionChecker&&) noexcept;
  CollisionChecker& operator=(CollisionChecker&&) noexcept;
  ~CollisionChecker();

  /// Smallest clearance of one backbone (m×3), less margin and room.
  Clearance clearance(const Eigen::Ref<const Backbone>& backbone) const;
  Clearance clearance(const Eigen::Ref<const BackboneD>& backbone) const;

  /// True if no obstacle touches the arm; stops at the first that does.
  bool is_free(const Eigen::Ref<const Backbone>& backbone) const;
  bool is_free(const Eigen::Ref<const BackboneD>& backbone) const;

  /// True if the arm stays free while every plate moves straight, and turns evenly, from `from`
  /// to `to`, both ends included.
  bool is_motion_free(const Eigen::Ref<const Backbone>& from,
                      const Eigen::Ref<const Backbone>& to) const;

  /// Smallest clearance along that motion, or `below_m` if it is not less than that. A smaller
  /// `below_m` gives an answer sooner.
  Clearance motion_clearance(const Eigen::Ref<const Backbone>& from,
                             const Eigen::Ref<const Backbone>& to,
                             double below_m = std::numeric_limits<double>::infinity()) const;

  int obstacle_count() const { return int(obstacles_.size()); }
  int gap_count() const { return int(radius_m_.size()); }
  /// Half width of the gap's segment + actuator radius + margin + full room.
  double radius_m(int gap) const { return radius_m_[gap]; }

 private:
  void add_room();
  template <class Scalar>
  double grown_room_m(int plate, const Eigen::Ref<const BackboneOf<Scalar>>& backbone) const;
  template <class Scalar>
  double radius_between_m(int gap, const Eigen::Ref<const BackboneOf<Scalar>>& from,
                          const Eigen::Ref<const BackboneOf<Scalar>>& to) const;
  template <class Scalar>
  Clearance clearance_below(const Eigen::Ref<const BackboneOf<Scalar>>& backbone,
                            double below_m) const;

  std::vector<ObstacleShape> obstacles_;  // nearest to the base first
  std::vector<double> radius_m_;          // one per gap, with its full room
  PlateRoom room_;
  std::unique_ptr<const BroadPhase> broad_;
};

}  // namespace limber
