#include "limber/arm/arm_identity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/pressure_limits.hpp"

namespace limber {

namespace {

constexpr std::size_t kMaxNamed = 4;  // differences in a message

/// Compares two arms key by key.
class Comparison {
 public:
  Comparison(const ArmDescription& there, const ArmDescription& here)
      : there_(there), here_(here) {}

  std::vector<std::string> run() {
    if (there_.is_spatial() != here_.is_spatial()) {
      add("dimension", there_.is_spatial() ? 3 : 2, here_.is_spatial() ? 3 : 2);
      return found_;
    }
    word("command.name", there_.command.name, here_.command.name);
    word("command.unit", there_.command.unit, here_.command.unit);
    word("no_load", to_string(there_.no_load), to_string(here_.no_load));
    number("frame_rate_hz", there_.frame_rate_hz, here_.frame_rate_hz);
    number("actuator_radius_m", there_.actuator_radius_m, here_.actuator_radius_m);
    for (int axis = 0; axis < 3; ++axis) {
      number(fmt::format("gravity[{}]", axis), there_.gravity[axis], here_.gravity[axis]);
    }
    if (there_.segment_count() != here_.segment_count()) {
      add("segments", there_.segment_count(), here_.segment_count());
      return found_;
    }
    for (std::size_t i = 0; i < here_.segments.size(); ++i) {
      segment(fmt::format("segments[{}].", i), there_.segments[i], here_.segments[i]);
    }
    if (there_.channel_count() == here_.channel_count()) {
      commands();
    }
    return found_;
  }

 private:
  /// Shares of commands; names only say which column of a log is which.
  void commands() {
    if (there_.commands.size() != here_.commands.size()) {
      add("commands", there_.commands.size(), here_.commands.size());
      return;
    }
    for (std::size_t k = 0; k < here_.commands.size(); ++k) {
      for (std::size_t i = 0; i < here_.commands[k].shares.size(); ++i) {
        number(fmt::format("commands[{}].acts_on[{}]", k, i), there_.commands[k].shares[i],
               here_.commands[k].shares[i]);
      }
    }
  }

  template <class Value>
  void add(const std::string& key, const Value& there, const Value& here) {
    found_.push_back(fmt::format("{}: {} there, {} here", key, there, here));
  }

  void word(const char* key, const std::string& there, const std::string& here) {
    if (there != here) {
      add(key, "'" + there + "'", "'" + here + "'");
    }
  }

  static bool is_same(double there, double here) {
    return std::abs(there - here) <= kSameNumber * std::max(std::abs(there), std::abs(here));
  }

  void number(const std::string& key, double there, double here) {
    if (!is_same(there, here)) {
      add(key, there, here);
    }
  }

  void limits(const std::string& key, const PressureLimits& there, const PressureLimits& here) {
    if (!is_same(there.lower_kpa, here.lower_kpa) || !is_same(there.upper_kpa, here.upper_kpa)) {
      add(key, limits_to_yaml(there), limits_to_yaml(here));
    }
  }

  void segment(const std::string& prefix, const Segment& there, const Segment& here) {
    number(prefix + "length_m", there.length_m, here.length_m);
    number(prefix + "width_m", there.width_m, here.width_m);
    if (there.gaps != here.gaps) {
      add(prefix + "gaps", there.gaps, here.gaps);
    }
    if (here_.is_spatial()) {
      chambers(prefix, there, here);
      return;
    }
    limits(prefix + limit_key(), there.pressure_limit_kpa, here.pressure_limit_kpa);
    if (there_.no_load == here_.no_load && here_.no_load == NoLoadKind::curvature) {
      number(prefix + "curvature_per_unit", there.curvature_per_unit, here.curvature_per_unit);
    }
    if (there_.no_load == here_.no_load && here_.no_load == NoLoadKind::strain_polynomial) {
      strain(prefix, there.strain_polynomial, here.strain_polynomial, here.pressure_limit_kpa);
    }
  }

  const char* limit_key() const {
    return here_.command.is_pressure_kpa() ? "pressure_limit_kpa" : "limit";
  }

  void chambers(const std::string& segment, const Segment& there, const Segment& here) {
    if (there.chambers.size() != here.chambers.size()) {
      add(segment + "chambers", there.chambers.size(), here.chambers.size());
      return;
    }
    for (std::size_t c = 0; c < here.chambers.size(); ++c) {
      const std::string prefix = fmt::format("{}chambers[{}].", segment, c);
      const Chamber& a = there.chambers[c];
      const Chamber& b = here.chambers[c];
      number(prefix + "angle_deg", a.angle_deg, b.angle_deg);
      number(prefix + "radius_m", a.radius_m, b.radius_m);
      if (a.sense != b.sense) {
        add(prefix + "sense", a.sense, b.sense);
      }
      limits(prefix + limit_key(), a.limit_kpa, b.limit_kpa);
      strain(prefix, a.strain_polynomial, b.strain_polynomial, b.limit_kpa);
    }
    if (there_.no_load == here_.no_load) {
      shape(segment + "shape_of_strains", there.shape_of_strains, here.shape_of_strains);
    }
  }

  void shape(const std::string& key, const Eigen::MatrixXd& there, const Eigen::MatrixXd& here) {
    if (there.cols() != here.cols()) {
      add(key + " columns", there.cols(), here.cols());
      return;
    }
    for (Eigen::Index row = 0; row < here.rows(); ++row) {
      for (Eigen::Index column = 0; column < here.cols(); ++column) {
        number(fmt::format("{}[{}][{}]", key, row, column), there(row, column), here(row, column));
      }
    }
  }

  void strain(const std::string& prefix, const StrainPolynomial& there,
              const StrainPolynomial& here, const PressureLimits& limits) {
    const StrainDifference largest = max_strain_difference(there, here, limits.largest_kpa());
    if (!(largest.strain <= kSameStrain)) {
      found_.push_back(fmt::format(
          "{}strain_polynomial: a strain of {:.6f} there, {:.6f} here at {:.4g} {}", prefix,
          strain_at(there, largest.pressure_kpa), strain_at(here, largest.pressure_kpa),
          largest.pressure_kpa, here_.command.unit));
    }
  }

  const ArmDescription& there_;
  const ArmDescription& here_;
  std::vector<std::string> found_;
};

}  // namespace

ArmIdentity identity_of(const ArmDescription& arm) {
  return {arm.name, arm.hash(), arm_keys_to_yaml(arm)};
}

std::vector<std::string> arm_differences(const ArmDescription& there, const ArmDescription& here) {
  return Comparison(there, here).run();
}

std::optional<double> rate_limit_of(const ArmIdentity& made_for, const std::string& file) {
  if (made_for.description.empty()) {
    return std::nullopt;
  }
  return read_arm_keys(made_for.description, file + ": arm_description",
                       PolynomialsOf::characterisation)
      .pressure_rate_limit_kpa_per_s;
}

ArmDescription at_rate_of(const ArmIdentity& made_for, ArmDescription arm,
                          const std::string& file) {
  double& own = arm.pressure_rate_limit_kpa_per_s;
  if (made_for.hash != arm.hash() && why_another_arm(made_for, arm, file).empty()) {
    own = std::min(own, rate_limit_of(made_for, file).value_or(own));
  }
  return arm;
}

std::string why_another_arm(const ArmIdentity& made_for, const ArmDescription& arm,
                            const std::string& file) {
  if (made_for.hash == arm.hash()) {
    return {};
  }
  if (made_for.description.empty()) {
    return "what differs is not known, because an earlier limber wrote the file and kept only a "
           "hash; the arm file of a demo is arm.yaml in its folder";
  }
  const ArmDescription there = read_arm_keys(made_for.description, file + ": arm_description",
                                             PolynomialsOf::characterisation);
  std::vector<std::string> differences = arm_differences(there, arm);
  if (differences.size() > kMaxNamed) {
    const std::string more = fmt::format("and {} more", differences.size() - kMaxNamed);
    differences.resize(kMaxNamed);
    differences.push_back(more);
  }
  return fmt::format("{}", fmt::join(differences, "; "));
}

}  // namespace limber
