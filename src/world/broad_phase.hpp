#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"
#include "limber/world/obstacle_shape.hpp"

namespace limber {

/// Tells by boxes which gaps of a moving backbone may touch an obstacle, for all gaps at the cost
/// of one exact look. Never leaves out one that touches, where the arm reaches no farther than 10
/// m. Threads: constant after construction.
class BroadPhase {
 public:
  /// Gaps that are looked at together, one a bit.
  static constexpr int kGaps = 32;

  BroadPhase(const std::vector<ObstacleShape>& obstacles, const std::vector<double>& radius_m);

  /// Bit i: gap `first` + i may touch an obstacle somewhere between `from` and `to` (m×3), while
  /// plates move straight and turn evenly; or has no shape, since a number is not finite or it
  /// turns by more than half a turn.
  std::uint32_t may_touch(const Eigen::Ref<const Backbone>& from,
                          const Eigen::Ref<const Backbone>& to, int first) const;

 private:
  struct FloatBox {
    float low_x, low_y, high_x, high_y;
  };

  std::vector<FloatBox> obstacles_;
  std::vector<float> radius_m_;  // one per gap
};

}  // namespace limber
