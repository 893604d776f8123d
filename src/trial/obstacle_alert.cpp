#include "limber/trial/obstacle_alert.hpp"

#include <utility>

namespace limber {

ObstacleAlert::ObstacleAlert(const ArmDescription& arm, const Environment& environment,
                             double margin_m, PlanSourceFactory source_for)
    : arm_(arm),
      margin_m_(margin_m),
      source_for_(std::move(source_for)),
      source_(source_for_(environment)) {}

bool ObstacleAlert::rest_is_free(const Plan& plan, std::size_t frame) const {
  for (std::size_t k = frame + 1; k < plan.frames.size(); ++k) {
    if (!too_near_->is_free(plan.frames[k].backbone)) {
      return false;
    }
  }
  return true;
}

bool ObstacleAlert::may_go_on(const Plan& plan, std::size_t frame, const ArmState& state) {
  const bool is_blocked = too_near_ && !rest_is_free(plan, frame);
  return !is_blocked && source_->may_go_on(plan, frame, state);
}

std::optional<Plan> ObstacleAlert::next(const Plan& plan, std::size_t frame,
                                        const ArmState& state) {
  return source_->next(plan, frame, state);
}

void ObstacleAlert::obstacle_appeared(const Environment& now) {
  too_near_.emplace(arm_, std::vector<Obstacle>{now.obstacles.back()}, margin_m_);
  source_ = source_for_(now);
}

}  // namespace limber
