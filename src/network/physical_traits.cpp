#include "limber/network/physical_traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/ranges.h>
#include <Eigen/QR>

#include "limber/arm/names.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kGramsPerKg = 1000.0;
constexpr double kPercent = 100.0;
constexpr double kSureBy = 25.0;  // five standard deviations
constexpr double kEnough = 0.8;   // of all that some change of e explains
constexpr double kAsGood = 0.95;  // of the best: then nothing says which of them it is
constexpr std::size_t kMostExplanations = 3;
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

/// Traits that changed together, and how well that explains the motion.
struct Explanation {
  std::vector<std::size_t> traits;
  Eigen::VectorXd change;
  Eigen::MatrixXd covariance;
  double told = 0.0;  ///< twice the logarithm of how much likelier it makes the motion
};

Explanation explanation(const ArmFamily& family, const ToldOfE& told,
                        const std::vector<std::size_t>& traits) {
  Eigen::MatrixXd along(told.pull.size(), std::ssize(traits));
  for (Eigen::Index i = 0; i < along.cols(); ++i) {
    along.col(i) = family.traits[traits[i]].along.cast<double>();
  }
  Explanation found{traits, {}, {}, 0.0};
  const Eigen::VectorXd pull = along.transpose() * told.pull;
  found.covariance = (along.transpose() * told.precision * along)
                         .completeOrthogonalDecomposition()
                         .pseudoInverse();
  found.change = found.covariance * pull;
  found.told = pull.dot(found.change);
  return found;
}

/// The best first.
void sort(std::vector<Explanation>& explanations) {
  std::ranges::stable_sort(explanations, std::ranges::greater(), &Explanation::told);
}

/// One trait each; two, where one does not explain enough.
std::vector<Explanation> explanations(const ArmFamily& family, const ToldOfE& told, double enough) {
  auto found = mapped<Explanation>(family.traits.size(),
                                   [&](std::size_t i) { return explanation(family, told, {i}); });
  sort(found);
  if (found.empty() || found.front().told >= enough) {
    return found;
  }
  found.clear();
  for (std::size_t i = 0; i < family.traits.size(); ++i) {
    for (std::size_t j = i + 1; j < family.traits.size(); ++j) {
      found.push_back(explanation(family, told, {i, j}));
    }
  }
  sort(found);
  return found;
}

}  // namespace

std::string sides_trait(int segment) {
  return kSides + std::to_string(segment);
}

TraitWords words_of_trait(const std::string& name) {
  if (name.starts_with(kSides)) {
    const std::optional<int> segment = number_in<int>(name.substr(std::string(kSides).size()));
    return {
        fmt::format("{}: left side's strength over the right's", segment_name(segment.value_or(0))),
        " %", kPercent};
  }
  const auto* found = std::ranges::find(kNamed, name, &Named::name);
  return found == kNamed.end() ? TraitWords{name, "", 1.0}
                               : TraitWords{found->text, found->unit, found->per_si};
}

std::vector<TraitEstimate> physical_traits(const ArmFamily& family, const FamilyMember& member) {
  return mapped<TraitEstimate>(family.traits, [&](const PhysicalTrait& trait) {
    return TraitEstimate{trait.name, value_of(trait, member),
                         std::sqrt(double(trait.left * trait.left) + variance(trait, member)),
                         double(trait.of_file)};
  });
}

std::vector<ArmChange> explained_changes(const ArmFamily& family, const FamilyMember& before,
                                         const ToldOfE& told) {
  // Were every number of e free.
  const double most =
      told.pull.dot(told.precision.completeOrthogonalDecomposition().pseudoInverse() * told.pull);
  const double enough = kEnough * most;
  std::vector<ArmChange> changes;
  double best = 0.0;
  for (const Explanation& one : explanations(family, told, enough)) {
    best = std::max(best, one.told);
    if (changes.size() == kMostExplanations ||
        !(one.told >= std::max({enough, kAsGood * best, kSureBy}))) {
      break;
    }
    ArmChange& change = changes.emplace_back();
    for (std::size_t i = 0; i < one.traits.size(); ++i) {
      const auto at = Eigen::Index(i);
      const PhysicalTrait& trait = family.traits[one.traits[i]];
      const double reference = value_of(trait, before);
      change.push_back({trait.name, reference + one.change(at),
                        std::sqrt(std::max(0.0, one.covariance(at, at))), reference});
    }
  }
  return changes;
}

std::vector<std::string> trait_texts(const std::vector<TraitEstimate>& traits) {
  std::vector<std::string> texts;
  std::ranges::transform(traits, std::back_inserter(texts), text_of);
  return texts;
}

std::string changes_text(const std::vector<ArmChange>& changes) {
  const auto texts = mapped<std::string>(changes, [&](const ArmChange& change) {
    return fmt::format("{}", fmt::join(trait_texts(change), " and "));
  });
  return fmt::format("{}", fmt::join(texts, ", or "));
}

std::string differences_text(std::vector<TraitEstimate> traits) {
  std::erase_if(traits, [](const TraitEstimate& trait) { return !trait.differs(); });
  std::ranges::stable_sort(traits, std::ranges::greater(), [](const TraitEstimate& trait) {
    return std::abs(trait.value - trait.reference) / trait.deviation;
  });
  return fmt::format("{}", fmt::join(trait_texts(traits), ", "));
}

}  // namespace limber
