#include "arm_physics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

ArmPhysics::ArmPhysics(const ArmDescription& arm, const VirtualArmParameters& parameters,
                       double time_step_s)
    : parameters_(parameters),
      gravity_m_per_s2_(gravity_m_per_s2(parameters)),
      links_(chain_links(arm, parameters)),
      side_law_(parameters_, time_step_s),
      friction_(parameters_),
      pneumatics_(parameters_, time_step_s),
      chain_(arm, parameters, time_step_s),
      kinematics_(links_, parameters_.base_misalignment_rad),
      loads_(links_.size()) {
  for (const ChainLink& link : links_) {
    for (std::size_t side = 0; side < kSides.size(); ++side) {
      const double strength =
          parameters_.actuators_per_side * side_strength(parameters_, 2 * link.segment + int(side));
      sides_.push_back({kSides[side] * 0.5 * link.width_m,
                        side_law_.side(link.length_m, strength, false,
                                       arm.limits_of_channel(link.segment).largest_kpa())});
    }
  }
}

void ArmPhysics::rest(VirtualArmState& state) const {
  const std::size_t joints = 2 * links_.size();
  state.position.resize(joints);
  state.velocity.resize(joints);
  state.warm_start.resize(joints);
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    state.position[2 * gap + 1] = links_[gap].rest_angle_rad;
  }
  const std::size_t segments = std::size_t(links_.back().segment) + 1;
  state.pressure_kpa.resize(segments);
  state.flow_kpa_per_s.resize(segments);
  state.braid_anchor_m.resize(joints);
  state.creep_m.resize(joints);
  PlaneKinematics kinematics = kinematics_;
  kinematics.update(state.position.data(), state.velocity.data());
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const PlaneKinematics::Plate& plate = kinematics.plates()[gap + 1];
    state.table_anchor_m.push_back(plate.position.x());
    state.table_anchor_m.push_back(plate.position.y());
    state.table_anchor_rad.push_back(plate.theta_rad);
  }
}

void ArmPhysics::restore(const VirtualArmState& state) {
  chain_.restore(state);
  kinematics_.update(chain_.position(), chain_.velocity());
}

std::string ArmPhysics::step(VirtualArmState& state) {
  pneumatics_.step(state);
  apply_side_forces(state);
  apply_table_forces(state);
  if (std::string complaint = chain_.step(); !complaint.empty()) {
    return complaint;
  }
  kinematics_.update(chain_.position(), chain_.velocity());
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    if (std::abs(chain_.position()[2 * gap]) >= links_[gap].length_m) {
      return fmt::format("the gap of {}, {} m long, has moved by {} m", plates_of_gap(gap),
                         links_[gap].length_m, chain_.position()[2 * gap]);
    }
  }
  return "";
}

// (V2)
double ArmPhysics::side_length_change_m(std::size_t gap, double lever_m) const {
  const double bend = chain_.position()[2 * gap + 1] - links_[gap].rest_angle_rad;
  return chain_.position()[2 * gap] - lever_m * bend;
}

void ArmPhysics::apply_side_forces(VirtualArmState& state) {
  double* joint_force = chain_.applied_force();
  const double* velocity = chain_.velocity();
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const double pressure = state.pressure_kpa[links_[gap].segment];
    const std::array pressures = {std::max(-pressure, 0.0), std::max(pressure, 0.0)};
    joint_force[2 * gap] = 0.0;
    joint_force[2 * gap + 1] = 0.0;
    for (std::size_t k = 0; k < kSides.size(); ++k) {
      const std::size_t side = kSides.size() * gap + k;
      const double lever = sides_[side].lever_m;
      const double rate = velocity[2 * gap] - lever * velocity[2 * gap + 1];
      const double tension =
          side_law_.tension_n(sides_[side].law, side_length_change_m(gap, lever), rate,
                              pressures[k], {state.braid_anchor_m[side], state.creep_m[side]});
      joint_force[2 * gap] -= tension;
      joint_force[2 * gap + 1] += lever * tension;
    }
  }
}

SpringSlider ArmPhysics::table_slider(const ChainLink& link, double speed_m_per_s) const {
  return {parameters_.friction_stiffness_n_per_m, parameters_.friction_damping_n_s_per_m,
          friction_.coefficient(speed_m_per_s) * link.mass_kg * -gravity_m_per_s2_.z()};
}

SpringSlider ArmPhysics::torsion_slider(const ChainLink& link, double rate_rad_per_s) const {
  const double arm = parameters_.friction_torsion_arm * link.width_m;
  const SpringSlider slider = table_slider(link, arm * std::abs(rate_rad_per_s));
  return {slider.stiffness * arm * arm, slider.damping * arm * arm, slider.limit * arm};
}

// (V6), (V11)
void ArmPhysics::apply_table_forces(VirtualArmState& state) {
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const PlaneKinematics::Plate& plate = kinematics_.plates()[gap + 1];
    loads_[gap].force_n =
        table_slider(links_[gap], plate.velocity.norm())
            .force(plate.position, plate.velocity,
                   Eigen::Map<Eigen::Vector2d>(state.table_anchor_m.data() + 2 * gap));
    const SpringSlider torsion = torsion_slider(links_[gap], plate.rate_rad_per_s);
    loads_[gap].torque_n_m =
        torsion.stiffness > 0.0
            ? torsion.force(plate.theta_rad, plate.rate_rad_per_s, state.table_anchor_rad[gap])
            : 0.0;
  }
  kinematics_.add_joint_forces(loads_, chain_.applied_force());
}

double ArmPhysics::energy_j(const VirtualArmState& state) const {
  double energy = 0.0;
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const ChainLink& link = links_[gap];
    const PlaneKinematics::Plate& plate = kinematics_.plates()[gap + 1];
    const double slide_rate = chain_.velocity()[2 * gap];
    const double hinge_rate = chain_.velocity()[2 * gap + 1];
    const double bend = chain_.position()[2 * gap + 1] - link.rest_angle_rad;
    energy += 0.5 * (link.mass_kg * plate.velocity.squaredNorm() +
                     link.inertia_kg_m2 * plate.rate_rad_per_s * plate.rate_rad_per_s +
                     parameters_.slide_armature_kg * slide_rate * slide_rate +
                     parameters_.hinge_armature_kg_m2 * hinge_rate * hinge_rate +
                     parameters_.hinge_stiffness_n_m_per_rad * bend * bend);
    const Eigen::Map<const Eigen::Vector2d> anchor(state.table_anchor_m.data() + 2 * gap);
    energy += table_slider(link, 0.0).energy((plate.position - anchor).norm(), 0.0) +
              torsion_slider(link, 0.0).energy(plate.theta_rad, state.table_anchor_rad[gap]) -
              link.mass_kg * gravity_m_per_s2_.head<2>().dot(plate.position);
    for (std::size_t side = 2 * gap; side < 2 * gap + 2; ++side) {
      const double stretch = side_length_change_m(gap, sides_[side].lever_m);
      energy += side_law_.energy_j(sides_[side].law, stretch, state.braid_anchor_m[side],
                                   state.creep_m[side]);
    }
  }
  return energy;
}

double ArmPhysics::side_strain(int segment, double side) const {
  double stretch = 0.0;
  double length = 0.0;
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    if (links_[gap].segment == segment) {
      stretch += side_length_change_m(gap, side * 0.5 * links_[gap].width_m);
      length += links_[gap].length_m;
    }
  }
  return stretch / length;
}

}  // namespace limber
