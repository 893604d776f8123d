#pragma once
// For those who move an arm, real or virtual.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// The rigid parts and passive joints of one gap and the plate at its end.
struct ChainLink {
  int segment = 0;
  double length_m = 0.0;       ///< h, between the plates at rest
  double width_m = 0.0;        ///< w
  double mass_kg = 0.0;        ///< of the plate with its payload
  double inertia_kg_m2 = 0.0;  ///< of the plate about z
  double hinge_damping_n_m_s_per_rad = 0.0;
  double rest_angle_rad = 0.0;  ///< hinge angle of the unloaded gap
};

struct VirtualArmParameters;

/// One link per gap, base first. @param parameters  the arm's
std::vector<ChainLink> chain_links(const ArmDescription& arm,
                                   const VirtualArmParameters& parameters);

/// Of an arm in a plane: in frame B, whose z is normal to the table; a tilted table has a part in
/// the plane.
Eigen::Vector3d gravity_m_per_s2(const VirtualArmParameters& parameters);

/// The chain as MuJoCo's XML: per gap a body with a slide along the arm and a hinge about z at the
/// middle of the gap, in this order (docs/virtual-arm.md, (V1)); in space with hinges about y, z
/// and x there (V12). Actuators, friction and pneumatics
/// are not MuJoCo's and are not in it.
std::string chain_mjcf(const ArmDescription& arm, const VirtualArmParameters& parameters,
                       double time_step_s);

}  // namespace limber
