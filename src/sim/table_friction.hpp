#pragma once

#include <cmath>

#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

/// Coefficient of friction over the speed of sliding: Coulomb's part, Stribeck's (friction at rest
/// is larger, and falls as sliding begins) and a viscous one; docs/virtual-arm.md, (V11).
///
/// Threads: constant after construction; share it freely.
class TableFriction {
 public:
  explicit TableFriction(const VirtualArmParameters& parameters)
      : sliding_(parameters.friction_coefficient),
        static_excess_(parameters.friction_static_excess),
        stribeck_m_per_s_(parameters.friction_stribeck_m_per_s),
        viscous_s_per_m_(parameters.friction_viscous_s_per_m) {}

  /// @param speed_m_per_s  ≥ 0
  double coefficient(double speed_m_per_s) const {
    double excess = static_excess_;
    if (excess > 0.0) {  // spares the exponential
      const double ratio = speed_m_per_s / stribeck_m_per_s_;
      excess *= std::exp(-ratio * ratio);
    }
    return sliding_ * (1.0 + excess) + viscous_s_per_m_ * speed_m_per_s;
  }

 private:
  double sliding_;
  double static_excess_;
  double stribeck_m_per_s_;
  double viscous_s_per_m_;
};

}  // namespace limber
