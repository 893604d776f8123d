#pragma once

#include <array>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/sim/mjcf.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "mujoco_chain.hpp"
#include "pneumatics.hpp"
#include "side_law.hpp"
#include "spring_slider.hpp"

namespace limber {

/// The simulator behind VirtualArm: one step of valves, actuators, braids, table and chain. It has
/// no frames, noise or limits.
class ArmPhysics {
 public:
  ArmPhysics(const ArmDescription& arm, const VirtualArmParameters& parameters, double time_step_s);

  /// One step from `state`, whose joints stay as they are: `save` writes them.
  /// @return what went wrong; empty if nothing did
  [[nodiscard]] std::string step(VirtualArmState& state);

  void save(VirtualArmState& state) const { chain_.save(state); }
  void restore(const VirtualArmState& state);
  /// Writes the simulator's part of a new state at rest: straight and vented.
  void rest(VirtualArmState& state) const;

  const PlaneKinematics& kinematics() const { return kinematics_; }
  double energy_j(const VirtualArmState& state) const;
  /// Mean strain of a segment's left (+1) or right (−1) side.
  double side_strain(int segment, double side) const;

 private:
  static constexpr std::array kSides = {1.0, -1.0};  // y of the side: left, right

  struct Side {
    double lever_m = 0.0;  ///< ± w/2
    SideLaw::Side law;
  };

  double side_length_change_m(std::size_t gap, double lever_m) const;
  void apply_side_forces(VirtualArmState& state);
  void apply_table_forces(VirtualArmState& state);
  SpringSlider table_slider(const ChainLink& link, double speed_m_per_s) const;
  SpringSlider torsion_slider(const ChainLink& link, double rate_rad_per_s) const;

  VirtualArmParameters parameters_;
  Eigen::Vector3d gravity_m_per_s2_;
  std::vector<ChainLink> links_;
  std::vector<Side> sides_;  // left and right of each gap
  SideLaw side_law_;
  TableFriction friction_;
  Pneumatics pneumatics_;
  MujocoChain chain_;
  PlaneKinematics kinematics_;
  std::vector<PlaneKinematics::Load> loads_;
};

}  // namespace limber
