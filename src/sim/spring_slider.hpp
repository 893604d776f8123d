#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

/// Coulomb friction that really sticks: a spring from the body to an anchor that is dragged along
/// once the spring would pull harder than `limit`, with a damper beside it; docs/virtual-arm.md,
/// (V6). The total never exceeds the limit and is continuous where sliding begins. So it takes
/// energy, and never gives more than the spring holds. The caller chooses the units: N and m, or N
/// m and rad.
struct SpringSlider {
  double stiffness = 0.0;  ///< > 0
  double damping = 0.0;    ///< ≥ 0
  double limit = 0.0;      ///< ≥ 0; may change from step to step

  /// Force on the body at `position` moving with `velocity`. Moves `anchor`: call once per step.
  double force(double position, double velocity, double& anchor) const {
    const double reach = limit / stiffness;
    anchor = std::clamp(anchor, position - reach, position + reach);
    return std::clamp(stiffness * (anchor - position) - damping * velocity, -limit, limit);
  }

  /// The same in the plane: the limit is a circle.
  Eigen::Vector2d force(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                        Eigen::Ref<Eigen::Vector2d> anchor) const {
    Eigen::Vector2d stretch = anchor - position;
    const double reach = limit / stiffness;
    const double length_squared = stretch.squaredNorm();
    if (length_squared > reach * reach) {
      stretch *= reach / std::sqrt(length_squared);
      anchor = position + stretch;
    }
    Eigen::Vector2d total = stiffness * stretch - damping * velocity;
    const double total_squared = total.squaredNorm();
    if (total_squared > limit * limit) {
      total *= limit / std::sqrt(total_squared);
    }
    return total;
  }

  double energy(double position, double anchor) const {
    return 0.5 * stiffness * (position - anchor) * (position - anchor);
  }
};

/// Coefficient of friction over the speed of sliding: Coulomb's part, Stribeck's (friction at rest
/// is larger, and falls as sliding begins) and a viscous one; docs/virtual-arm.md, (V11).
///
/// Threads: constant after construction; share it freely.
class TableFriction {
 public:
  explicit TableFriction(const VirtualArmParameters& parameters) : parameters_(parameters) {}

  /// @param speed_m_per_s  ≥ 0
  double coefficient(double speed_m_per_s) const {
    double excess = parameters_.friction_static_excess;
    if (excess > 0.0) {  // spares the exponential
      const double ratio = speed_m_per_s / parameters_.friction_stribeck_m_per_s;
      excess *= std::exp(-ratio * ratio);
    }
    return parameters_.friction_coefficient * (1.0 + excess) +
           parameters_.friction_viscous_s_per_m * speed_m_per_s;
  }

 private:
  VirtualArmParameters parameters_;
};

}  // namespace limber
