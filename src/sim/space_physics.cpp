#include "space_physics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

constexpr std::size_t kAnchors = 3;  // of a gap's joints

}  // namespace

SpacePhysics::SpacePhysics(const ArmDescription& arm, const VirtualArmParameters& parameters,
                           double time_step_s)
    : parameters_(parameters),
      gravity_m_per_s2_(parameters.gravity_m_per_s2 * arm.gravity),
      links_(space_chain_links(arm, parameters)),
      channels_(std::size_t(arm.channel_count())),
      side_law_(parameters, time_step_s),
      pneumatics_(parameters, time_step_s),
      chain_(arm, parameters, time_step_s) {
  add_chambers(arm);
}

void SpacePhysics::add_chambers(const ArmDescription& arm) {
  std::vector<int> first_channel = {0};  // of each segment
  for (const Segment& segment : arm.segments) {
    first_channel.push_back(first_channel.back() + int(segment.chambers.size()));
  }
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const auto segment = std::size_t(links_[gap].gap.segment);
    for (int channel = first_channel[segment]; channel < first_channel[segment + 1]; ++channel) {
      const Chamber& chamber = arm.chamber(channel);
      const bool extends = chamber.sense > 0;
      if (!extends && chamber.limit_kpa.lower_kpa < 0.0) {
        throw InputError(fmt::format(
            "virtual arm: {} contracts, and takes pressures from {} kPa; expected from 0: an "
            "actuator that contracts does so under pressure alone",
            channel_name(arm, channel), chamber.limit_kpa.lower_kpa));
      }
      const double strength =
          side_strength(parameters_, channel) * (extends ? 1.0 : parameters_.actuators_per_side);
      const double angle_rad = chamber.angle_deg * std::numbers::pi / 180.0;
      chambers_.push_back({gap, std::size_t(channel), chamber.radius_m * std::cos(angle_rad),
                           chamber.radius_m * std::sin(angle_rad),
                           side_law_.side(links_[gap].gap.length_m, strength, extends,
                                          chamber.limit_kpa.largest_kpa())});
    }
  }
}

void SpacePhysics::rest(VirtualArmState& state) const {
  const std::size_t joints = kSpaceJoints * links_.size();
  state.position.resize(joints);
  state.velocity.resize(joints);
  state.warm_start.resize(joints);
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    state.position[kSpaceJoints * gap + 1] = links_[gap].rest_rad[0];
    state.position[kSpaceJoints * gap + 2] = links_[gap].rest_rad[1];
    state.joint_anchor_rad.insert(state.joint_anchor_rad.end(),
                                  {links_[gap].rest_rad[0], links_[gap].rest_rad[1], 0.0});
  }
  state.pressure_kpa.resize(channels_);
  state.flow_kpa_per_s.resize(channels_);
  state.braid_anchor_m.resize(chambers_.size());
  state.creep_m.resize(chambers_.size());
}

std::string SpacePhysics::step(VirtualArmState& state) {
  pneumatics_.step(state);
  apply_joint_forces(state);
  apply_chamber_forces(state);
  if (std::string complaint = chain_.step(); !complaint.empty()) {
    return complaint;
  }
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const double slide_m = chain_.position()[kSpaceJoints * gap];
    if (std::abs(slide_m) >= links_[gap].gap.length_m) {
      return fmt::format("the gap of {}, {} m long, has moved by {} m",
                         plates_of_gap(Eigen::Index(gap)), links_[gap].gap.length_m, slide_m);
    }
  }
  return "";
}

double SpacePhysics::stretch_m(const ChamberInGap& chamber) const {
  const double* joints = chain_.position() + kSpaceJoints * chamber.gap;
  const Eigen::Vector2d& rest_rad = links_[chamber.gap].rest_rad;
  return joints[0] + chamber.z_m * (joints[1] - rest_rad[0]) -
         chamber.y_m * (joints[2] - rest_rad[1]);
}

// (V13), by virtual work
void SpacePhysics::apply_chamber_forces(VirtualArmState& state) {
  for (std::size_t i = 0; i < chambers_.size(); ++i) {
    const ChamberInGap& chamber = chambers_[i];
    const double* rate = chain_.velocity() + kSpaceJoints * chamber.gap;
    double pressure = state.pressure_kpa[chamber.channel];
    if (!chamber.law.extends) {
      pressure = std::max(pressure, 0.0);  // valves may undershoot
    }
    const double tension = side_law_.tension_n(
        chamber.law, stretch_m(chamber), rate[0] + chamber.z_m * rate[1] - chamber.y_m * rate[2],
        pressure, {state.braid_anchor_m[i], state.creep_m[i]});
    double* force = chain_.applied_force() + kSpaceJoints * chamber.gap;
    force[0] -= tension;
    force[1] -= chamber.z_m * tension;
    force[2] += chamber.y_m * tension;
  }
}

SpringSlider SpacePhysics::joint_slider() const {
  return {parameters_.joint_friction_stiffness_n_m_per_rad,
          parameters_.joint_friction_damping_n_m_s_per_rad, parameters_.joint_friction_n_m};
}

// (V14), (V6)
void SpacePhysics::apply_joint_forces(VirtualArmState& state) {
  const SpringSlider slider = joint_slider();
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const double* joints = chain_.position() + kSpaceJoints * gap;
    const double* rate = chain_.velocity() + kSpaceJoints * gap;
    double* anchor = state.joint_anchor_rad.data() + kAnchors * gap;
    const Eigen::Vector2d bend =
        slider.force(Eigen::Vector2d(joints[1], joints[2]), Eigen::Vector2d(rate[1], rate[2]),
                     Eigen::Map<Eigen::Vector2d>(anchor));
    // The twist's own spring is MuJoCo's: it knows nothing of the turn of two bends.
    const double of_bends = 0.5 * joints[1] * joints[2];
    const double stiffness = parameters_.twist_stiffness_n_m_per_rad;
    const double torque = -stiffness * (joints[3] + of_bends);
    double* force = chain_.applied_force() + kSpaceJoints * gap;
    force[0] = 0.0;
    force[1] = bend.x() + torque * 0.5 * joints[2];
    force[2] = bend.y() + torque * 0.5 * joints[1];
    force[3] = slider.force(joints[3], rate[3], anchor[2]) - stiffness * of_bends;
  }
}

void SpacePhysics::write_plates(SpaceBackboneD& plates) const {
  write_space_plates(links_, parameters_.base_misalignment_rad, chain_.position(), plates);
}

double SpacePhysics::energy_j(const VirtualArmState& state) const {
  SpaceBackboneD plates;
  write_plates(plates);
  const SpringSlider slider = joint_slider();
  double energy = chain_.kinetic_energy_j();
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const double* joints = chain_.position() + kSpaceJoints * gap;
    const double* anchor = state.joint_anchor_rad.data() + kAnchors * gap;
    const Eigen::Vector2d bend(joints[1], joints[2]);
    const double twist = joints[3] + 0.5 * joints[1] * joints[2];
    energy += 0.5 * parameters_.hinge_stiffness_n_m_per_rad *
                  (bend - links_[gap].rest_rad).squaredNorm() +
              0.5 * parameters_.twist_stiffness_n_m_per_rad * twist * twist +
              slider.energy((bend - Eigen::Map<const Eigen::Vector2d>(anchor)).norm(), 0.0) +
              slider.energy(joints[3], anchor[2]);
    const Eigen::Vector3d at_m = plates.row(Eigen::Index(gap) + 1).head<3>();
    energy -= links_[gap].gap.mass_kg * gravity_m_per_s2_.dot(at_m);
  }
  for (std::size_t i = 0; i < chambers_.size(); ++i) {
    energy += side_law_.energy_j(chambers_[i].law, stretch_m(chambers_[i]), state.braid_anchor_m[i],
                                 state.creep_m[i]);
  }
  return energy;
}

double SpacePhysics::chamber_strain(int channel) const {
  double stretch = 0.0;
  double length = 0.0;
  for (const ChamberInGap& chamber : chambers_) {
    if (chamber.channel == std::size_t(channel)) {
      stretch += stretch_m(chamber);
      length += chamber.law.length_m;
    }
  }
  return stretch / length;
}

}  // namespace limber
