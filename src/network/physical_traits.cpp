#include "limber/network/physical_traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/ranges.h>
#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kGramsPerKg = 1000.0;
constexpr double kPercent = 100.0;
constexpr std::size_t kMostCauses = 2;
constexpr double kSureBy = 9.0;        // three standard deviations
constexpr double kShareOfCause = 0.2;  // of all that some change of e explains
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

/// What one trait, or some together, explain of e's change.
class Changes {
 public:
  Changes(const ArmFamily& family, const Eigen::MatrixXd& precision, const Eigen::VectorXd& pull)
      : family_(family), precision_(precision), pull_(pull) {}

  /// Twice the logarithm of how much likelier the motion is with that trait's change beside those.
  std::pair<Eigen::Index, double> best_with(std::vector<Eigen::Index> causes) const {
    std::pair<Eigen::Index, double> best{-1, 0.0};
    for (Eigen::Index i = 0; i < std::ssize(family_.traits); ++i) {
      if (std::ranges::find(causes, i) == causes.end()) {
        causes.push_back(i);
        const Fit fit = fit_of(causes);
        if (const double told = fit.pull.dot(fit.change); told > best.second) {
          best = {i, told};
        }
        causes.pop_back();
      }
    }
    return best;
  }

  std::vector<TraitEstimate> of(const std::vector<Eigen::Index>& causes,
                                const FamilyMember& before) const {
    const Fit fit = fit_of(causes);
    std::vector<TraitEstimate> traits;
    for (Eigen::Index i = 0; i < std::ssize(causes); ++i) {
      const PhysicalTrait& trait = family_.traits[static_cast<std::size_t>(causes[i])];
      const double reference = value_of(trait, before);
      traits.push_back({trait.name, reference + fit.change(i),
                        std::sqrt(std::max(0.0, fit.covariance(i, i))), reference});
    }
    return traits;
  }

  double told_by(Eigen::Index i) const { const Fit f = fit_of({i}); return f.pull.dot(f.change); }
 private:
  struct Fit {
    Eigen::VectorXd pull;
    Eigen::VectorXd change;
    Eigen::MatrixXd covariance;
  };

  Fit fit_of(const std::vector<Eigen::Index>& causes) const {
    Eigen::MatrixXd along(pull_.size(), std::ssize(causes));
    for (Eigen::Index i = 0; i < along.cols(); ++i) {
      along.col(i) = family_.traits[static_cast<std::size_t>(causes[i])].along.cast<double>();
    }
    Fit fit;
    fit.pull = along.transpose() * pull_;
    fit.covariance =
        (along.transpose() * precision_ * along).completeOrthogonalDecomposition().pseudoInverse();
    fit.change = fit.covariance * fit.pull;
    return fit;
  }

  const ArmFamily& family_;
  const Eigen::MatrixXd& precision_;
  const Eigen::VectorXd& pull_;
};

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

std::vector<TraitEstimate> changed_traits(const ArmFamily& family, const FamilyMember& before,
                                          const Eigen::MatrixXd& precision,
                                          const Eigen::VectorXd& pull) {
  const Changes changes(family, precision, pull);
  const double most = pull.dot(precision.ldlt().solve(pull));  // were every number of e free
  std::vector<Eigen::Index> causes;
  double explained = 0.0;
  for (Eigen::Index i = 0; i < std::ssize(family.traits); ++i) { fprintf(stderr, "DBG %s %.1f of %.1f\n", family.traits[i].name.c_str(), changes.told_by(i), most); }
  while (causes.size() < kMostCauses) {
    const auto [next, by_then] = changes.best_with(causes);
    if (!(by_then - explained > std::max(kSureBy, kShareOfCause * most))) {
      break;
    }
    causes.push_back(next);
    explained = by_then;
  }
  return causes.empty() ? std::vector<TraitEstimate>() : changes.of(causes, before);
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
