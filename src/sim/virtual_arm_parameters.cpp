#include "limber/sim/virtual_arm_parameters.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/content_hash.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

using Parameters = VirtualArmParameters;

constexpr double kUnlimited = std::numeric_limits<double>::max();

/// Which arms have a parameter.
enum class Of { both, plane, space };

/// Name, member and smallest value of every parameter that is a plain number: one table serves
/// reading and writing.
struct Field {
  const char* key;
  double Parameters::*member;
  double low;
  Of of = Of::both;
  double high = kUnlimited;
  /// Came later: not written while as by default, so that arms without it keep their text and its
  /// hash.
  bool optional = false;
};

constexpr bool belongs(Of of, Dimension dimension) {
  return of == Of::both || (of == Of::space) == (dimension == Dimension::space);
}

constexpr double kAboveZero = 1e-12;
constexpr double kAnySign = -std::numeric_limits<double>::max();
constexpr std::array kFields = {
    Field{"slide_damping_n_s_per_m", &Parameters::slide_damping_n_s_per_m, 0.0},
    Field{"slide_armature_kg", &Parameters::slide_armature_kg, 0.0},
    Field{"hinge_stiffness_n_m_per_rad", &Parameters::hinge_stiffness_n_m_per_rad, 0.0},
    Field{"hinge_damping_n_m_s_per_rad", &Parameters::hinge_damping_n_m_s_per_rad, 0.0},
    Field{"hinge_armature_kg_m2", &Parameters::hinge_armature_kg_m2, 0.0},
    Field{"reference_width_m", &Parameters::reference_width_m, kAboveZero},
    Field{"plate_mass_kg", &Parameters::plate_mass_kg, kAboveZero},
    Field{"plate_mass_fixed_fraction", &Parameters::plate_mass_fixed_fraction, 0.0},
    Field{"plate_payload_kg", &Parameters::plate_payload_kg, 0.0},
    Field{"side_elasticity_n", &Parameters::side_elasticity_n, 0.0},
    Field{"actuators_per_side", &Parameters::actuators_per_side, kAboveZero},
    Field{"actuator_gain", &Parameters::actuator_gain, 0.0},
    Field{"actuator_strain_offset", &Parameters::actuator_strain_offset, 0.0},
    Field{"strength_spread", &Parameters::strength_spread, 0.0, Of::both, 1.0},
    Field{"hysteresis_fraction", &Parameters::hysteresis_fraction, 0.0},
    Field{"hysteresis_floor_n", &Parameters::hysteresis_floor_n, 0.0},
    Field{"hysteresis_stiffness_n_per_m", &Parameters::hysteresis_stiffness_n_per_m, kAboveZero},
    Field{"hysteresis_damping_n_s_per_m", &Parameters::hysteresis_damping_n_s_per_m, 0.0},
    Field{"creep_fraction", &Parameters::creep_fraction, 0.0},
    Field{"creep_time_s", &Parameters::creep_time_s, kAboveZero},
    Field{"plate_offset_rad", &Parameters::plate_offset_rad, 0.0},
    Field{"base_misalignment_rad", &Parameters::base_misalignment_rad, kAnySign},
    Field{"gravity_m_per_s2", &Parameters::gravity_m_per_s2, 0.0},
    Field{"friction_coefficient", &Parameters::friction_coefficient, 0.0, Of::plane},
    Field{"friction_stiffness_n_per_m", &Parameters::friction_stiffness_n_per_m, kAboveZero,
          Of::plane},
    Field{"friction_damping_n_s_per_m", &Parameters::friction_damping_n_s_per_m, 0.0, Of::plane},
    Field{"friction_torsion_arm", &Parameters::friction_torsion_arm, 0.0, Of::plane},
    Field{"pressure_rate_limit_kpa_per_s", &Parameters::pressure_rate_limit_kpa_per_s, kAboveZero},
    Field{"inflate_time_constant_s", &Parameters::inflate_time_constant_s, kAboveZero},
    Field{"vent_time_constant_s", &Parameters::vent_time_constant_s, kAboveZero},
    Field{"valve_lag_s", &Parameters::valve_lag_s, kAboveZero},
    Field{"controller_proportional_gain", &Parameters::controller_proportional_gain, kAboveZero},
    Field{"controller_derivative_gain_s", &Parameters::controller_derivative_gain_s, 0.0},
    Field{"pressure_dead_band_kpa", &Parameters::pressure_dead_band_kpa, 0.0},
    Field{"inflate_rate_limit_kpa_per_s", &Parameters::inflate_rate_limit_kpa_per_s, kAboveZero,
          Of::both, kUnlimited, true},
    Field{"vent_rate_limit_kpa_per_s", &Parameters::vent_rate_limit_kpa_per_s, kAboveZero, Of::both,
          kUnlimited, true},
    Field{"valve_dead_time_s", &Parameters::valve_dead_time_s, 0.0, Of::both, 5.0, true},
    Field{"tip_load_kg", &Parameters::tip_load_kg, 0.0, Of::both, 100.0, true},
    Field{"weak_side_loss", &Parameters::weak_side_loss, 0.0, Of::plane, 1.0, true},
    Field{"leak_share", &Parameters::leak_share, 0.0, Of::both, 0.9, true},
    Field{"actuator_strain_scale", &Parameters::actuator_strain_scale, kAboveZero, Of::both,
          kUnlimited, true},
    Field{"actuator_bow", &Parameters::actuator_bow, -1.0, Of::both, 1.0, true},
    Field{"gap_length_spread", &Parameters::gap_length_spread, 0.0, Of::both, 0.5, true},
    Field{"table_tilt_rad", &Parameters::table_tilt_rad, 0.0, Of::plane, 1.5, true},
    Field{"table_downhill_rad", &Parameters::table_downhill_rad, kAnySign, Of::plane, kUnlimited,
          true},
    Field{"friction_static_excess", &Parameters::friction_static_excess, 0.0, Of::plane, kUnlimited,
          true},
    Field{"friction_stribeck_m_per_s", &Parameters::friction_stribeck_m_per_s, kAboveZero,
          Of::plane, kUnlimited, true},
    Field{"friction_viscous_s_per_m", &Parameters::friction_viscous_s_per_m, 0.0, Of::plane,
          kUnlimited, true},
    Field{"chamber_area_m2", &Parameters::chamber_area_m2, kAboveZero, Of::space},
    Field{"wall_stiffening", &Parameters::wall_stiffening, 0.0, Of::space},
    Field{"twist_stiffness_n_m_per_rad", &Parameters::twist_stiffness_n_m_per_rad, 0.0, Of::space},
    Field{"twist_damping_n_m_s_per_rad", &Parameters::twist_damping_n_m_s_per_rad, 0.0, Of::space},
    Field{"joint_friction_n_m", &Parameters::joint_friction_n_m, 0.0, Of::space},
    Field{"joint_friction_stiffness_n_m_per_rad", &Parameters::joint_friction_stiffness_n_m_per_rad,
          kAboveZero, Of::space},
    Field{"joint_friction_damping_n_m_s_per_rad", &Parameters::joint_friction_damping_n_m_s_per_rad,
          0.0, Of::space},
    Field{"time_step_s", &Parameters::time_step_s, 1e-5, Of::both, 0.01},
};

/// Parameters that are four coefficients.
struct QuarticField {
  const char* key;
  QuarticCoefficients Parameters::*member;
};

constexpr std::array kQuarticFields = {
    QuarticField{"actuator_threshold_kpa", &Parameters::actuator_threshold_kpa},
    QuarticField{"actuator_extension_n", &Parameters::actuator_extension_n},
    QuarticField{"actuator_compression_n", &Parameters::actuator_compression_n},
};

constexpr const char* kSection = "virtual_arm";
constexpr const char* kWeakSide = "weak_side";
constexpr const char* kLeakingChannel = "leaking_channel";
constexpr const char* kParameter = "a parameter of the virtual arm (docs/virtual-arm.md)";

template <class Table>
const typename Table::value_type* find_field(const Table& table, const std::string& key) {
  for (const auto& field : table) {
    if (key == field.key) {
      return &field;
    }
  }
  return nullptr;
}

QuarticCoefficients read_quartic(const YamlReader& value) {
  const std::vector<double> numbers = value.numbers(kParameter);
  QuarticCoefficients coefficients;
  value.refuse_if(numbers.size() != coefficients.size(),
                  "{} coefficients found; expected 4, of x, x^2, x^3 and x^4", numbers.size());
  std::copy(numbers.begin(), numbers.end(), coefficients.begin());
  return coefficients;
}

void require_belonging(const YamlReader& value, Of of, Dimension dimension) {
  if (!belongs(of, dimension)) {
    const bool in_space = dimension == Dimension::space;
    value.refuse(
        fmt::format("belongs to the virtual arm in {}, and this arm is in {}; expected no "
                    "such key here",
                    in_space ? "a plane" : "space", in_space ? "space" : "a plane"));
  }
}

VirtualArmParameters read_parameters(const YamlReader& node, Dimension dimension,
                                     VirtualArmParameters parameters = {}) {
  for (const std::string& key : node.keys()) {
    const YamlReader value = node.at(key);
    if (key == "strength_seed") {
      parameters.strength_seed = std::uint64_t(value.integer("a seed", 0, 1'000'000'000));
    } else if (key == kWeakSide) {
      require_belonging(value, Of::plane, dimension);
      parameters.weak_side =
          int(value.integer("2 x segment, + 1 for its right side", 0, 2 * kMaxSegments - 1));
    } else if (key == kLeakingChannel) {
      parameters.leaking_channel =
          int(value.integer("a segment, in space a chamber", 0, std::numeric_limits<int>::max()));
    } else if (const Field* field = find_field(kFields, key)) {
      require_belonging(value, field->of, dimension);
      parameters.*(field->member) = value.number(kParameter, field->low, field->high);
    } else if (const QuarticField* quartic = find_field(kQuarticFields, key)) {
      parameters.*(quartic->member) = read_quartic(value);
    } else {
      value.refuse("unknown parameter of the virtual arm; docs/virtual-arm.md lists them");
    }
  }
  return parameters;
}

/// Key and value of each.
using Texts = std::vector<std::pair<std::string, std::string>>;

/// @param of  the arms whose parameters are wanted; none: all
Texts texts_of(const VirtualArmParameters& parameters, std::optional<Dimension> of = {}) {
  Texts texts;
  for (const Field& field : kFields) {
    if (of && !belongs(field.of, *of)) {
      continue;
    }
    if (field.optional && parameters.*(field.member) == Parameters{}.*(field.member)) {
      continue;
    }
    texts.emplace_back(field.key, fmt::format("{}", parameters.*(field.member)));
  }
  for (const QuarticField& field : kQuarticFields) {
    texts.emplace_back(field.key, fmt::format("[{}]", fmt::join(parameters.*(field.member), ", ")));
  }
  if (parameters.weak_side_loss > 0.0) {
    texts.emplace_back(kWeakSide, fmt::format("{}", parameters.weak_side));
  }
  if (parameters.leak_share > 0.0) {
    texts.emplace_back(kLeakingChannel, fmt::format("{}", parameters.leaking_channel));
  }
  texts.emplace_back("strength_seed", fmt::format("{}", parameters.strength_seed));
  return texts;
}

std::string to_yaml(const VirtualArmParameters& parameters, Dimension dimension) {
  std::string text = std::string(kSection) + ":\n";
  for (const auto& [key, value] : texts_of(parameters, dimension)) {
    text += fmt::format("  {}: {}\n", key, value);
  }
  return text;
}

}  // namespace

VirtualArmParameters virtual_arm_parameters(const ArmDescription& arm) {
  if (arm.virtual_arm.yaml.empty()) {
    return {};
  }
  return read_parameters(
      YamlReader::from_text(arm.virtual_arm.yaml, arm.virtual_arm.file).at(kSection),
      arm.dimension);
}

void set_virtual_arm_parameters(ArmDescription& arm, const VirtualArmParameters& parameters) {
  arm.virtual_arm.yaml = to_yaml(parameters, arm.dimension);
}

std::string physics_differences(const VirtualArmParameters& of,
                                const VirtualArmParameters& varied) {
  const Texts before = texts_of(of);
  std::vector<std::string> others;
  for (const auto& text : texts_of(varied)) {
    if (std::find(before.begin(), before.end(), text) == before.end()) {
      others.push_back(fmt::format("\"{}\": {}", text.first, text.second));
    }
  }
  return fmt::format("{{{}}}", fmt::join(others, ", "));
}

VirtualArmParameters with_differences(const VirtualArmParameters& of,
                                      const std::string& differences, Dimension dimension,
                                      const std::string& where) {
  return read_parameters(YamlReader::from_text(differences, where), dimension, of);
}

double side_strength(const VirtualArmParameters& parameters, int side) {
  RandomStream stream(parameters.strength_seed, std::uint64_t(side));
  const double left = side == parameters.weak_side ? 1.0 - parameters.weak_side_loss : 1.0;
  return (1.0 + parameters.strength_spread * stream.uniform(-1.0, 1.0)) * left;
}

std::string virtual_arm_to_yaml(const ArmDescription& arm) {
  if (!arm.command.is_pressure_kpa()) {
    return arm_to_yaml(arm);
  }
  ArmDescription complete = arm;
  set_virtual_arm_parameters(complete, virtual_arm_parameters(arm));
  return arm_to_yaml(complete);
}

std::string virtual_arm_hash(ArmDescription arm) {
  arm.safety_yaml.clear();
  return content_hash(virtual_arm_to_yaml(arm));
}

}  // namespace limber
