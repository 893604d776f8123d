#pragma once
// For those who move an arm, real or virtual.

#include <optional>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// The arm near or in an obstacle at one moment.
struct Contact {
  double time_s = 0.0;
  Clearance clearance;  ///< value, gap and obstacle
};

/// Watches a moving arm: its smallest clearance so far and its first collision. Obstacles exert no
/// force: the arm moves on through them, so it can be watched to the end.
class CollisionWatch {
 public:
  CollisionWatch(const ArmDescription& arm, const Environment& environment);

  /// Takes in the backbone (m×3) at a time; times don't decrease. Most calls cost a few dozen
  /// subtractions: the checker is called only if, since its last call, the arm may have come closer
  /// than ever before, or may have touched an obstacle.
  void observe(double time_s, const Eigen::Ref<const BackboneD>& backbone);

  /// The moment at which the arm came closest, the first if there are several; none without
  /// obstacles or observations.
  const std::optional<Contact>& closest() const { return closest_; }
  /// The first moment with a clearance < 0.
  const std::optional<Contact>& first_collision() const { return first_collision_; }
  /// How often the checker was called.
  int checks() const { return checks_; }

 private:
  double max_motion_m(const Eigen::Ref<const BackboneD>& backbone) const;

  CollisionChecker checker_;
  double longest_gap_m_;
  BackboneD checked_;             // backbone that the checker saw last
  double checked_value_m_ = 0.0;  // and its clearance
  std::optional<Contact> closest_;
  std::optional<Contact> first_collision_;
  int checks_ = 0;
};

}  // namespace limber
