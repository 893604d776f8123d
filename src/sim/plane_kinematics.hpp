#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/sim/mjcf.hpp"

namespace limber {

/// Poses and velocities of the plates from the joints, and joint forces from forces on the plates;
/// the plane only, linear in the number of gaps. docs/virtual-arm.md, (V1).
class PlaneKinematics {
 public:
  struct Plate {
    Eigen::Vector2d position{0.0, 0.0};
    Eigen::Vector2d velocity{0.0, 0.0};
    Eigen::Vector2d axis{1.0, 0.0};  ///< (cos θ, sin θ)
    double theta_rad = 0.0;          ///< sum of the angles before it, unwrapped
    double rate_rad_per_s = 0.0;
  };
  /// Force and torque on one plate, world frame.
  struct Load {
    Eigen::Vector2d force_n{0.0, 0.0};
    double torque_n_m = 0.0;
  };

  PlaneKinematics(const std::vector<ChainLink>& links, double base_angle_rad);

  /// Sizes 2(m − 1): slide and hinge of each gap in turn.
  void update(const double* position, const double* velocity);
  /// Adds the joints' share of `loads` (size m − 1, of plates 1 … m − 1) to `joint_force`.
  void add_joint_forces(const std::vector<Load>& loads, double* joint_force) const;

  /// m, base first.
  const std::vector<Plate>& plates() const { return plates_; }

 private:
  std::vector<double> half_length_m_;
  std::vector<Plate> plates_;
  std::vector<Eigen::Vector2d> hinge_;  // positions of the hinges
};

}  // namespace limber
