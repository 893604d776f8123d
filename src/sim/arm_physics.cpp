#include "arm_physics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {

namespace {

constexpr double kReferencePressureKpa = 1.0;

}  // namespace

ArmPhysics::ArmPhysics(const ArmDescription& arm, const VirtualArmParameters& parameters,
                       double time_step_s)
    : parameters_(parameters),
      time_step_s_(time_step_s),
      gravity_m_per_s2_(gravity_m_per_s2(parameters)),
      links_(chain_links(arm, parameters)),
      actuator_(parameters_),
      friction_(parameters_),
      pneumatics_(parameters_, time_step_s),
      chain_(arm, parameters, time_step_s),
      kinematics_(links_, parameters_.base_misalignment_rad),
      loads_(links_.size()) {
  for (const ChainLink& link : links_) {
    for (std::size_t side = 0; side < kSides.size(); ++side) {
      RandomStream stream(parameters_.strength_seed,
                          2 * static_cast<std::uint64_t>(link.segment) + side);
      const double spread = parameters_.strength_spread * stream.uniform(-1.0, 1.0);
      const bool is_weak = 2 * link.segment + static_cast<int>(side) == parameters_.weak_side;
      const double left = is_weak ? 1.0 - parameters_.weak_side_loss : 1.0;
      const double strength = parameters_.actuators_per_side * (1.0 + spread) * left;
      sides_.push_back(
          {kSides[side] * 0.5 * link.width_m, strength,
           strength * actuator_.tension_n(0.0, kReferencePressureKpa),
           arm.segments[static_cast<std::size_t>(link.segment)].pressure_limit_kpa.largest_kpa()});
    }
  }
  restore(rest());
}

VirtualArmState ArmPhysics::rest() const {
  VirtualArmState state;
  const std::size_t joints = 2 * links_.size();
  state.position.resize(joints);
  state.velocity.resize(joints);
  state.warm_start.resize(joints);
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    state.position[2 * gap + 1] = links_[gap].rest_angle_rad;
  }
  const std::size_t segments = static_cast<std::size_t>(links_.back().segment) + 1;
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
  return state;
}

void ArmPhysics::save(VirtualArmState& state) const {
  const auto joints = static_cast<std::size_t>(chain_.size());
  state.position.assign(chain_.position(), chain_.position() + joints);
  state.velocity.assign(chain_.velocity(), chain_.velocity() + joints);
  state.warm_start.assign(chain_.warm_start(), chain_.warm_start() + joints);
  state.pressure_kpa.clear();
  state.flow_kpa_per_s.clear();
  for (const SegmentAir& air : air_) {
    state.pressure_kpa.push_back(air.pressure_kpa);
    state.flow_kpa_per_s.push_back(air.flow_kpa_per_s);
  }
  state.braid_anchor_m = braid_anchor_m_;
  state.creep_m = creep_m_;
  state.table_anchor_m = table_anchor_m_;
  state.table_anchor_rad = table_anchor_rad_;
}

void ArmPhysics::restore(const VirtualArmState& state) {
  chain_.set_state(state.position, state.velocity, state.warm_start,
                   static_cast<double>(state.step) * time_step_s_);
  air_.clear();
  for (std::size_t i = 0; i < state.pressure_kpa.size(); ++i) {
    air_.push_back({state.pressure_kpa[i], state.flow_kpa_per_s[i]});
  }
  braid_anchor_m_ = state.braid_anchor_m;
  creep_m_ = state.creep_m;
  table_anchor_m_ = state.table_anchor_m;
  table_anchor_rad_ = state.table_anchor_rad;
  kinematics_.update(chain_.position(), chain_.velocity());
}

std::string ArmPhysics::step(const std::vector<double>& setpoint_kpa, bool vent) {
  for (std::size_t s = 0; s < air_.size(); ++s) {
    pneumatics_.step(setpoint_kpa[s], vent, air_[s]);
  }
  apply_side_forces();
  apply_table_forces();
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

// (V3)–(V7), (V10)
double ArmPhysics::side_tension_n(std::size_t side, double stretch_m, double rate_m_per_s,
                                  double pressure_kpa) {
  const double length = links_[side / kSides.size()].length_m;
  const double strain = stretch_m / length;
  const double bowed_kpa =
      pressure_kpa *
      (1.0 + parameters_.actuator_bow * (1.0 - pressure_kpa / sides_[side].full_pressure_kpa));
  const double actuators = sides_[side].strength * actuator_.tension_n(strain, bowed_kpa);
  const double elastic = parameters_.side_elasticity_n * strain;
  const SpringSlider braid{
      parameters_.hysteresis_stiffness_n_per_m, parameters_.hysteresis_damping_n_s_per_m,
      parameters_.hysteresis_fraction * sides_[side].full_tension_n_per_kpa * pressure_kpa +
          parameters_.hysteresis_floor_n};
  const double hysteresis = braid.force(stretch_m, rate_m_per_s, braid_anchor_m_[side]);
  double creep = 0.0;
  if (parameters_.creep_fraction > 0.0) {
    creep_m_[side] += time_step_s_ / parameters_.creep_time_s * (stretch_m - creep_m_[side]);
    creep = parameters_.creep_fraction * parameters_.side_elasticity_n *
            (stretch_m - creep_m_[side]) / length;
  }
  return actuators + elastic + creep - hysteresis;
}

void ArmPhysics::apply_side_forces() {
  double* joint_force = chain_.applied_force();
  const double* velocity = chain_.velocity();
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const double pressure = air_[static_cast<std::size_t>(links_[gap].segment)].pressure_kpa;
    const std::array pressures = {std::max(-pressure, 0.0), std::max(pressure, 0.0)};
    joint_force[2 * gap] = 0.0;
    joint_force[2 * gap + 1] = 0.0;
    for (std::size_t k = 0; k < kSides.size(); ++k) {
      const std::size_t side = kSides.size() * gap + k;
      const double lever = sides_[side].lever_m;
      const double rate = velocity[2 * gap] - lever * velocity[2 * gap + 1];
      const double tension =
          side_tension_n(side, side_length_change_m(gap, lever), rate, pressures[k]);
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
void ArmPhysics::apply_table_forces() {
  for (std::size_t gap = 0; gap < links_.size(); ++gap) {
    const PlaneKinematics::Plate& plate = kinematics_.plates()[gap + 1];
    loads_[gap].force_n = table_slider(links_[gap], plate.velocity.norm())
                              .force(plate.position, plate.velocity,
                                     Eigen::Map<Eigen::Vector2d>(table_anchor_m_.data() + 2 * gap));
    const SpringSlider torsion = torsion_slider(links_[gap], plate.rate_rad_per_s);
    loads_[gap].torque_n_m =
        torsion.stiffness > 0.0
            ? torsion.force(plate.theta_rad, plate.rate_rad_per_s, table_anchor_rad_[gap])
            : 0.0;
  }
  kinematics_.add_joint_forces(loads_, chain_.applied_force());
}

double ArmPhysics::energy_j() const {
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
    const Eigen::Map<const Eigen::Vector2d> anchor(table_anchor_m_.data() + 2 * gap);
    energy += table_slider(link, 0.0).energy((plate.position - anchor).norm(), 0.0) +
              torsion_slider(link, 0.0).energy(plate.theta_rad, table_anchor_rad_[gap]) -
              link.mass_kg * gravity_m_per_s2_.head<2>().dot(plate.position);
    for (std::size_t side = 2 * gap; side < 2 * gap + 2; ++side) {
      const double stretch = side_length_change_m(gap, sides_[side].lever_m);
      const double strain = stretch / link.length_m;
      const double relaxing = stretch - creep_m_[side];
      const double elasticity = parameters_.side_elasticity_n;
      energy += link.length_m * (sides_[side].strength * actuator_.passive_energy_n(strain) +
                                 0.5 * elasticity * strain * strain) +
                0.5 * parameters_.creep_fraction * elasticity / link.length_m * relaxing * relaxing;
      const double offset = stretch - braid_anchor_m_[side];
      energy += 0.5 * parameters_.hysteresis_stiffness_n_per_m * offset * offset;
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
