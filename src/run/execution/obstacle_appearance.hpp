#pragma once

#include <optional>

#include "limber/run/appearing_obstacle.hpp"
#include "limber/run/collision_watch.hpp"
#include "limber/run/executor.hpp"

namespace limber {

/// An obstacle that appears during a run: when, where, and what the arm does beside it.
class ObstacleAppearance {
 public:
  /// Borrows all. @param obstacle  null: none appears
  ObstacleAppearance(const ArmDescription& arm, const Environment& environment,
                     const AppearingObstacle* obstacle)
      : arm_(arm), environment_(environment), obstacle_(obstacle) {}

  /// After each frame of the run, with the arm's shape if it is known. @return the environment with
  /// the obstacle, if it has just appeared
  const Environment* advance(int frame, double time_s, const std::optional<BackboneD>& shape);

  /// From when on it is there: as CollisionWatch::observe.
  void observe(double time_s, const Eigen::Ref<const BackboneD>& backbone) {
    if (watch_) {
      watch_->observe(time_s, backbone);
    }
  }

  /// When and where; none if it has not appeared.
  const std::optional<AppearedObstacle>& appeared() const { return appeared_; }

  /// Of the contacts with the obstacles of before and with this one, the nearer or the earlier one.
  std::optional<Contact> nearer(const std::optional<Contact>& before) const;
  std::optional<Contact> earlier(const std::optional<Contact>& before) const;

 private:
  std::optional<Contact> of_this(std::optional<Contact> contact) const;

  const ArmDescription& arm_;
  const Environment& environment_;
  const AppearingObstacle* obstacle_;
  std::optional<AppearedObstacle> appeared_;
  Environment now_;                      // with the obstacle
  std::optional<CollisionWatch> watch_;  // of the obstacle alone
};

}  // namespace limber
