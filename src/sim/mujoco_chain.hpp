#pragma once

#include <memory>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/sim/mjcf.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

struct VirtualArmParameters;

/// The chain of chain_mjcf in MuJoCo, advanced under generalised forces; the only place that calls
/// MuJoCo. Generalised coordinates of each gap in turn: slide [m] and hinge [rad]; in space slide,
/// bend about y, bend about z and twist.
///
/// Threads: one object, one thread.
class MujocoChain {
 public:
  /// @throws SystemFault if MuJoCo refuses the model.
  MujocoChain(const ArmDescription& arm, const VirtualArmParameters& parameters,
              double time_step_s);

  int size() const { return model_->nv; }
  const double* position() const { return data_->qpos; }
  const double* velocity() const { return data_->qvel; }
  /// The joints' part of the state; sizes are `size()` each.
  void save(VirtualArmState& state) const;
  void restore(const VirtualArmState& state);

  /// Of the last step's mass matrix, at this velocity; with the joints' armature.
  double kinetic_energy_j() const;

  /// Forces of the next step, N and N m; write all of them before each `step`.
  double* applied_force() { return data_->qfrc_applied; }

  /// One step; the joints' damping is implicit.
  /// @return MuJoCo's warning or error; empty if there is none. After a warning the state is
  /// lost, because MuJoCo resets it.
  [[nodiscard]] std::string step();

 private:
  struct DeleteModel {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DeleteData {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  double time_step_s_;
  std::vector<double> damping_;
};

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

/// (V12): poses of all plates at the joints' `position`, kSpaceJoints numbers per gap. Quaternions
/// change sign with no motion, however far an arm turns.
/// @param base_angle_rad  of the base about z
/// @param plates          m×7, overwritten
void write_space_plates(const std::vector<SpaceLink>& links, double base_angle_rad,
                        const double* position, SpaceBackboneD& plates);

}  // namespace limber
