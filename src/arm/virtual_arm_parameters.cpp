#include "limber/arm/virtual_arm_parameters.hpp"

#include <array>

#include <fmt/format.h>

#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

using Parameters = VirtualArmParameters;

/// Name, member and smallest value of every parameter that is a plain number: one table serves
/// reading and writing.
struct Field {
  const char* key;
  double Parameters::*member;
  double low;
};

constexpr double kAboveZero = 1e-12;
constexpr std::array kFields = {
    Field{"slide_damping_n_s_per_m", &Parameters::slide_damping_n_s_per_m, 0.0},
    Field{"slide_armature_kg", &Parameters::slide_armature_kg, 0.0},
    Field{"hinge_stiffness_n_m_per_rad", &Parameters::hinge_stiffness_n_m_per_rad, 0.0},
    Field{"hinge_damping_n_m_s_per_rad", &Parameters::hinge_damping_n_m_s_per_rad, 0.0},
    Field{"hinge_armature_kg_m2", &Parameters::hinge_armature_kg_m2, 0.0},
    Field{"plate_mass_kg", &Parameters::plate_mass_kg, kAboveZero},
    Field{"plate_payload_kg", &Parameters::plate_payload_kg, 0.0},
    Field{"side_elasticity_n", &Parameters::side_elasticity_n, 0.0},
    Field{"strength_spread", &Parameters::strength_spread, 0.0},
    Field{"hysteresis_fraction", &Parameters::hysteresis_fraction, 0.0},
    Field{"hysteresis_floor_n", &Parameters::hysteresis_floor_n, 0.0},
    Field{"hysteresis_stiffness_n_per_m", &Parameters::hysteresis_stiffness_n_per_m, kAboveZero},
    Field{"friction_coefficient", &Parameters::friction_coefficient, 0.0},
    Field{"friction_stiffness_n_per_m", &Parameters::friction_stiffness_n_per_m, kAboveZero},
    Field{"friction_damping_n_s_per_m", &Parameters::friction_damping_n_s_per_m, 0.0},
    Field{"friction_torsion_arm", &Parameters::friction_torsion_arm, 0.0},
    Field{"pressure_rate_limit_kpa_per_s", &Parameters::pressure_rate_limit_kpa_per_s, kAboveZero},
    Field{"inflate_time_constant_s", &Parameters::inflate_time_constant_s, kAboveZero},
    Field{"vent_time_constant_s", &Parameters::vent_time_constant_s, kAboveZero},
    Field{"pressure_dead_band_kpa", &Parameters::pressure_dead_band_kpa, 0.0},
    Field{"time_step_s", &Parameters::time_step_s, kAboveZero},
};

const Field* find_field(const std::string& key) {
  for (const Field& field : kFields) {
    if (key == field.key) {
      return &field;
    }
  }
  return nullptr;
}

}  // namespace

VirtualArmParameters read_virtual_arm_parameters(const YamlReader& node) {
  VirtualArmParameters parameters;
  for (const std::string& key : node.keys()) {
    const YamlReader value = node.at(key);
    if (key == "strength_seed") {
      parameters.strength_seed =
          static_cast<std::uint64_t>(value.integer("a seed", 0, 1'000'000'000));
    } else if (const Field* field = find_field(key)) {
      parameters.*(field->member) =
          value.number("a parameter of the virtual arm (docs/virtual-arm.md)", field->low);
    } else {
      value.refuse("unknown parameter of the virtual arm; docs/virtual-arm.md lists them");
    }
  }
  return parameters;
}

std::string virtual_arm_parameters_to_yaml(const VirtualArmParameters& parameters, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string text;
  for (const Field& field : kFields) {
    text += fmt::format("{}{}: {}\n", margin, field.key, parameters.*(field.member));
  }
  return text + fmt::format("{}strength_seed: {}\n", margin, parameters.strength_seed);
}

}  // namespace limber
