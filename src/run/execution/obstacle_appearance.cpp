#include "obstacle_appearance.hpp"

namespace limber {

const Environment* ObstacleAppearance::advance(int frame, double time_s,
                                               const std::optional<BackboneD>& shape) {
  if (obstacle_ == nullptr || frame != obstacle_->frame || !shape) {
    return nullptr;
  }
  const std::optional<Circle> circle = circle_ahead_of(arm_, *obstacle_, *shape);
  if (!circle) {
    return nullptr;
  }
  appeared_ = AppearedObstacle{time_s, *circle};
  Environment alone;
  alone.obstacles = {*circle};
  watch_.emplace(arm_, alone);
  observe(time_s, *shape);
  now_ = environment_;
  now_.obstacles.push_back(*circle);
  return &now_;
}

std::optional<Contact> ObstacleAppearance::of_this(std::optional<Contact> contact) const {
  if (contact) {
    contact->clearance.obstacle = int(environment_.obstacles.size());
  }
  return contact;
}

std::optional<Contact> ObstacleAppearance::nearer(const std::optional<Contact>& before) const {
  const std::optional<Contact> own = watch_ ? of_this(watch_->closest()) : std::nullopt;
  const bool is_nearer = own && (!before || own->clearance.value_m < before->clearance.value_m);
  return is_nearer ? own : before;
}

std::optional<Contact> ObstacleAppearance::earlier(const std::optional<Contact>& before) const {
  const std::optional<Contact> own = watch_ ? of_this(watch_->first_collision()) : std::nullopt;
  return own && (!before || own->time_s < before->time_s) ? own : before;
}

Environment with_appeared(const Environment& environment, const ExecutionResult& result) {
  Environment all = environment;
  if (result.appeared) {
    all.obstacles.push_back(result.appeared->circle);
  }
  return all;
}

}  // namespace limber
