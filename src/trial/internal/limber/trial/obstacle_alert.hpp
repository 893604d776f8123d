#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "limber/hardware/executor.hpp"
#include "limber/world/collision.hpp"

namespace limber {

/// Makes a source of plans for an environment, which outlives it.
using PlanSourceFactory = std::function<std::unique_ptr<PlanSource>(const Environment&)>;

/// A source of plans that learns of an obstacle when it appears. A plan whose rest comes too near to
/// it is left at once. The plans that follow are those of a source made for the environment with
/// the obstacle; if it knows none, the arm stays where it stopped.
class ObstacleAlert final : public PlanSource {
 public:
  /// @param environment  without the obstacle; borrowed
  /// @param margin_m     a plan may go on if it keeps that far from the obstacle, ≥ 0
  ObstacleAlert(const ArmDescription& arm, const Environment& environment, double margin_m,
                PlanSourceFactory source_for);

  bool may_go_on(const Plan& plan, std::size_t frame, const ArmState& state) override;
  std::optional<Plan> next(const Plan& plan, std::size_t frame, const ArmState& state) override;
  void obstacle_appeared(const Environment& now) override;

 private:
  bool rest_is_free(const Plan& plan, std::size_t frame) const;

  const ArmDescription& arm_;
  double margin_m_;
  PlanSourceFactory source_for_;
  std::unique_ptr<PlanSource> source_;
  std::optional<CollisionChecker> too_near_;  // of the obstacle that appeared
};

}  // namespace limber
