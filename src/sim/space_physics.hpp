#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "mujoco_chain.hpp"
#include "pneumatics.hpp"
#include "side_law.hpp"
#include "spring_slider.hpp"

namespace limber {

/// As ArmPhysics, of an arm in space: one step of valves, chambers, joint friction and chain;
/// docs/virtual-arm.md, "In space".
class SpacePhysics {
 public:
  /// @throws InputError if a chamber contracts and takes pressures below 0: no actuator does.
  SpacePhysics(const ArmDescription& arm, const VirtualArmParameters& parameters,
               double time_step_s);

  /// These four as ArmPhysics has them.
  [[nodiscard]] std::string step(VirtualArmState& state);
  void save(VirtualArmState& state) const { chain_.save(state); }
  void restore(const VirtualArmState& state) { chain_.restore(state); }
  void rest(VirtualArmState& state) const;

  /// m×7.
  void write_plates(SpaceBackboneD& plates) const;
  double energy_j(const VirtualArmState& state) const;
  /// Mean strain of a chamber at its place; positive where it is extended.
  double chamber_strain(int channel) const;

 private:
  /// What never changes of a chamber in one gap.
  struct ChamberInGap {
    std::size_t gap = 0;
    std::size_t channel = 0;
    double y_m = 0.0;  ///< where it lies in the plates
    double z_m = 0.0;
    SideLaw::Side law;
  };

  void add_chambers(const ArmDescription& arm);
  /// (V13): of its length, from slide and bend alone.
  double stretch_m(const ChamberInGap& chamber) const;
  void apply_chamber_forces(VirtualArmState& state);
  void apply_joint_forces(VirtualArmState& state);
  SpringSlider joint_slider() const;

  VirtualArmParameters parameters_;
  Eigen::Vector3d gravity_m_per_s2_;
  std::vector<SpaceLink> links_;
  std::vector<ChamberInGap> chambers_;  // of each gap in turn
  std::size_t channels_ = 0;
  SideLaw side_law_;
  Pneumatics pneumatics_;
  MujocoChain chain_;
};

}  // namespace limber
