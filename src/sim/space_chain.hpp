#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"
#include "limber/sim/mjcf.hpp"

namespace limber {

/// Generalised coordinates of a gap in space: slide along x [m], hinges about y, z and x [rad].
inline constexpr std::size_t kSpaceJoints = 4;

/// One gap of an arm in space and the plate at its end, a disc; docs/virtual-arm.md, (V12).
struct SpaceLink {
  ChainLink gap;                      ///< its `inertia_kg_m2` is not used here
  double inertia_along_kg_m2 = 0.0;   ///< about x
  double inertia_across_kg_m2 = 0.0;  ///< about y and z
  /// Hinge angles of the unloaded gap, about y and about z.
  Eigen::Vector2d rest_rad = Eigen::Vector2d::Zero();
};

/// One per gap, base first. @pre arm.is_spatial()
std::vector<SpaceLink> space_chain_links(const ArmDescription& arm,
                                         const VirtualArmParameters& parameters);

/// The body of plate `number` in MuJoCo's XML, not closed.
std::string space_link_mjcf(const SpaceLink& link, const VirtualArmParameters& parameters,
                            std::size_t number, const std::string& margin);

/// (V12): poses of all plates at the joints' `position`, kSpaceJoints numbers per gap. Quaternions
/// change sign with no motion, however far an arm turns.
/// @param base_angle_rad  of the base about z
/// @param plates          m×7, overwritten
void write_space_plates(const std::vector<SpaceLink>& links, double base_angle_rad,
                        const double* position, SpaceBackboneD& plates);

}  // namespace limber
