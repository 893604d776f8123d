#include "limber/network/physical_traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/ranges.h>
#include <Eigen/QR>

#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kGramsPerKg = 1000.0;
constexpr double kPercent = 100.0;
constexpr const char* kSides = "left_over_right_";

struct Named {
  const char* name;
  const char* text;
  const char* unit = "";
  double per_si = 1.0;
};

constexpr std::array kNamed = {
    Named{"friction_coefficient", "friction on the table"},
    Named{"joint_friction_n_m", "friction in the joints", " mN m", 1000.0},
    Named{"tip_load_kg", "load at the tip", " g", kGramsPerKg},
    Named{"plate_payload_kg", "load on each plate", " g", kGramsPerKg},
    Named{"table_fall_x_rad", "fall of the table in x", "°", kDegPerRad},
    Named{"table_fall_y_rad", "fall of the table in y", "°", kDegPerRad},
    Named{"actuator_gain", "strength of all actuators", " N/kPa"},
    Named{"actuator_strain_scale", "strain of the actuators over the usual"},
    Named{"actuator_bow", "bow of the actuators' curve"},
    Named{"hysteresis_fraction", "hysteresis of the actuators", " %", kPercent},
    Named{"side_elasticity_n", "elasticity of a side", " N"},
    Named{"hinge_damping_n_m_s_per_rad", "damping", " N m s"},
};

/// Two digits of the deviation, and as many decimals of the values.
std::string text_of(const TraitEstimate& trait) {
  const TraitWords words = words_of_trait(trait.name);
  const double deviation = words.per_si * trait.deviation;
  const int decimals =
      deviation > 0.0 ? std::clamp(1 - int(std::floor(std::log10(deviation))), 0, 4) : 2;
  return fmt::format("{} {:.{}f} ± {:.{}f}{} ({:.{}f})", words.text, words.per_si * trait.value,
                     decimals, deviation, decimals, words.unit, words.per_si * trait.reference,
                     decimals);
}

double variance(const PhysicalTrait& trait, const FamilyMember& member) {
  return double(trait.slope.dot(member.covariance * trait.slope));
}

double value_of(const PhysicalTrait& trait, const FamilyMember& member) {
  return double(trait.middle + trait.slope.dot(member.e));
}

}  // namespace

std::string sides_trait(int segment) {
  return kSides + std::to_string(segment + 1);
}

TraitWords words_of_trait(const std::string& name) {
  if (name.starts_with(kSides)) {
    return {fmt::format("strength of segment {}'s left side over its right",
                        name.substr(std::string(kSides).size())),
            " %", kPercent};
  }
  const auto* found = std::ranges::find(kNamed, name, &Named::name);
  return found == kNamed.end() ? TraitWords{name, "", 1.0}
                               : TraitWords{found->text, found->unit, found->per_si};
}

std::vector<TraitEstimate> physical_traits(const ArmFamily& family, const FamilyMember& member) {
  std::vector<TraitEstimate> traits;
  for (const PhysicalTrait& trait : family.traits) {
    traits.push_back({trait.name, value_of(trait, member),
                      std::sqrt(double(trait.left * trait.left) + variance(trait, member)),
                      double(trait.of_file)});
  }
  return traits;
}

std::vector<TraitEstimate> physical_traits_since(const ArmFamily& family,
                                                 const FamilyMember& before,
                                                 const FamilyMember& now) {
  std::vector<TraitEstimate> traits = physical_traits(family, now);
  for (std::size_t i = 0; i < traits.size(); ++i) {
    const PhysicalTrait& trait = family.traits[i];
    traits[i].reference = value_of(trait, before);
    traits[i].deviation =
        std::sqrt(traits[i].deviation * traits[i].deviation + variance(trait, before));
  }
  return traits;
}

Eigen::MatrixXf trait_directions(const ArmFamily& family) {
  Eigen::MatrixXf slopes(std::ssize(family.traits), family.size());
  for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
    slopes.row(i) = family.traits[static_cast<std::size_t>(i)].slope.transpose();
  }
  return slopes.completeOrthogonalDecomposition().pseudoInverse();
}

std::string differences_text(std::vector<TraitEstimate> traits) {
  std::erase_if(traits, [](const TraitEstimate& trait) { return !trait.differs(); });
  std::ranges::stable_sort(traits, std::ranges::greater(), [](const TraitEstimate& trait) {
    return std::abs(trait.value - trait.reference) / trait.deviation;
  });
  std::vector<std::string> texts;
  std::ranges::transform(traits, std::back_inserter(texts), text_of);
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace limber
