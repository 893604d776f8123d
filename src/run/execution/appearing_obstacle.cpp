#include "limber/run/appearing_obstacle.hpp"

#include <algorithm>

#include "limber/common/random_stream.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

constexpr int kFrameSamples = 100;
constexpr int kCircleSamples = 20;  // for each frame

/// Whether the plan's shapes of these frames are that far from the circle.
bool plan_is_free(const CollisionChecker& checker, const Plan& plan, int from, int to) {
  return std::all_of(plan.frames.begin() + from, plan.frames.begin() + to + 1,
                     [&](const PlanFrame& frame) { return checker.is_free(frame.backbone); });
}

}  // namespace

std::optional<AppearingObstacle> appearing_obstacle(const ArmDescription& arm, const Plan& plan,
                                                    double radius_m, std::uint64_t seed,
                                                    std::uint64_t stream) {
  const int ahead = arm.frames_in(AppearingObstacle::kAheadS);
  const int last = plan.frame_count() - 1 - plan.hold_frame_count;
  if (last - ahead < 1) {
    return std::nullopt;
  }
  RandomStream random(seed, stream);
  const auto between = [&](int low, int high) {
    return low + int(random.index(std::uint32_t(high - low + 1)));
  };
  AppearingObstacle result;
  for (int sample = 0; sample < kFrameSamples; ++sample) {
    result.frame = between(1, last - ahead);
    for (int k = 0; k < kCircleSamples; ++k) {
      const int passes = between(result.frame + ahead, last);
      const Eigen::Vector2d tip_m = tip_position_m(plan.frames[passes].backbone);
      const Circle circle{tip_m.x(), tip_m.y(), radius_m};
      const CollisionChecker touches(arm, {circle});
      const CollisionChecker near(arm, {circle}, AppearingObstacle::kAheadM);
      if (plan_is_free(near, plan, result.frame, result.frame) &&
          plan_is_free(touches, plan, result.frame, result.frame + ahead - 1)) {
        result.circles.push_back(circle);
      }
    }
    if (!result.circles.empty()) {
      return result;
    }
  }
  return std::nullopt;
}

std::optional<Circle> circle_ahead_of(const ArmDescription& arm, const AppearingObstacle& obstacle,
                                      const BackboneD& backbone) {
  for (const Circle& circle : obstacle.circles) {
    if (CollisionChecker(arm, {circle}, AppearingObstacle::kAheadM).is_free(backbone)) {
      return circle;
    }
  }
  return std::nullopt;
}

}  // namespace limber
