#include "limber/lab/family_traits.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "limber/common/error.hpp"
#include "limber/network/physical_traits.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

using Parameters = VirtualArmParameters;

constexpr double kShareTold = 0.7;  // of the variance over arms not fitted to; less is no trait
constexpr int kParts = 5;           // that are left out in turn
constexpr Eigen::Index kArmsPerNumber = 8;  // of e; fewer fit anything

/// A quantity whose value is worth knowing.
struct Quantity {
  std::string name;
  std::function<double(const Parameters&)> value;
};

std::vector<Quantity> quantities_of(const ArmDescription& arm) {
  std::vector<Quantity> quantities = {
      {"friction_coefficient", &Parameters::friction_coefficient},
      {"joint_friction_n_m", &Parameters::joint_friction_n_m},
      {"tip_load_kg", &Parameters::tip_load_kg},
      {"plate_payload_kg", &Parameters::plate_payload_kg},
      {"table_fall_x_rad",
       [](const Parameters& p) { return p.table_tilt_rad * std::cos(p.table_downhill_rad); }},
      {"table_fall_y_rad",
       [](const Parameters& p) { return p.table_tilt_rad * std::sin(p.table_downhill_rad); }},
      {"actuator_gain", &Parameters::actuator_gain},
      {"actuator_strain_scale", &Parameters::actuator_strain_scale},
      {"actuator_bow", &Parameters::actuator_bow},
      {"hysteresis_fraction", &Parameters::hysteresis_fraction},
      {"side_elasticity_n", &Parameters::side_elasticity_n},
      {"hinge_damping_n_m_s_per_rad", &Parameters::hinge_damping_n_m_s_per_rad},
  };
  for (int segment = 0; !arm.is_spatial() && segment < arm.segment_count(); ++segment) {
    quantities.push_back({sides_trait(segment), [segment](const Parameters& p) {
                            const double left = side_strength(p, 2 * segment);
                            const double right = side_strength(p, 2 * segment + 1);
                            return 2.0 * (left - right) / (left + right);
                          }});
  }
  return quantities;
}

/// The virtual arms of a family: what each is, and its e, a row each after a 1.
struct KnownArms {
  std::vector<Parameters> physics;
  Eigen::MatrixXd rows;
};

/// None of arms of whom something else is noted: recordings may say what they like.
std::optional<Parameters> parameters_of(const Parameters& of_file, const std::string& physics,
                                        Dimension dimension) {
  if (physics.empty()) {
    return std::nullopt;
  }
  try {
    return with_differences(of_file, physics, dimension, "physics");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

KnownArms known_arms(const ArmDescription& arm, const std::vector<std::string>& physics,
                     const ArmFamily& family) {
  const Parameters of_file = virtual_arm_parameters(arm);
  KnownArms known;
  known.rows.resize(family.arms.cols(), 1 + family.size());
  for (Eigen::Index i = 0; i < std::min(std::ssize(physics), family.arms.cols()); ++i) {
    if (const auto parameters = parameters_of(of_file, physics[i], arm.dimension)) {
      known.rows.row(std::ssize(known.physics)) << 1.0,
          family.arms.col(i).cast<double>().transpose();
      known.physics.push_back(*parameters);
    }
  }
  known.rows.conservativeResize(std::ssize(known.physics), Eigen::NoChange);
  return known;
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& rows, const Eigen::VectorXd& values) {
  return (rows.transpose() * rows).ldlt().solve(rows.transpose() * values);
}

/// How e changes with each quantity, when none of the others does: a column each.
Eigen::MatrixXf directions(const KnownArms& known, const std::vector<Quantity>& quantities) {
  Eigen::MatrixXd rows(known.rows.rows(), 1 + std::ssize(quantities));
  rows.col(0).setOnes();
  for (std::size_t j = 0; j < quantities.size(); ++j) {
    auto column = rows.col(1 + Eigen::Index(j));
    std::ranges::transform(known.physics, column.begin(), quantities[j].value);
  }
  // Some do not vary, and are of no consequence.
  const Eigen::VectorXd scale = rows.cwiseAbs().colwise().maxCoeff().cwiseMax(1e-12).transpose();
  const Eigen::MatrixXd found = (rows * scale.cwiseInverse().asDiagonal())
                                    .completeOrthogonalDecomposition()
                                    .solve(known.rows.rightCols(known.rows.cols() - 1));
  return (scale.cwiseInverse().asDiagonal() * found)
      .bottomRows(std::ssize(quantities))
      .transpose()
      .cast<float>();
}

/// What is left of each arm's value where the fit did not know that arm.
Eigen::VectorXd left_of_others(const Eigen::MatrixXd& rows, const Eigen::VectorXd& values) {
  Eigen::VectorXd left(values.size());
  for (int part = 0; part < kParts; ++part) {
    std::vector<Eigen::Index> fitted;
    std::vector<Eigen::Index> others;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      (i % kParts == part ? others : fitted).push_back(i);
    }
    const Eigen::VectorXd found =
        least_squares(rows(fitted, Eigen::all), Eigen::VectorXd(values(fitted)));
    left(others) = values(others) - rows(others, Eigen::all) * found;
  }
  return left;
}

double mean_square(const Eigen::VectorXd& values) {
  return values.squaredNorm() / double(values.size());
}

}  // namespace

std::vector<PhysicalTrait> fit_traits(const ArmDescription& arm,
                                      const std::vector<std::string>& physics,
                                      const ArmFamily& family) {
  const KnownArms known = known_arms(arm, physics, family);
  std::vector<PhysicalTrait> traits;
  if (known.rows.rows() < kArmsPerNumber * family.size()) {
    return traits;
  }
  const Parameters of_file = virtual_arm_parameters(arm);
  const std::vector<Quantity> quantities = quantities_of(arm);
  const Eigen::MatrixXf along = directions(known, quantities);
  Eigen::VectorXd values(known.rows.rows());
  for (std::size_t j = 0; j < quantities.size(); ++j) {
    const Quantity& quantity = quantities[j];
    std::ranges::transform(known.physics, values.begin(), quantity.value);
    const double variance = mean_square((values.array() - values.mean()).matrix());
    const double left = mean_square(left_of_others(known.rows, values));
    if (!(left < (1.0 - kShareTold) * variance)) {
      continue;
    }
    const Eigen::VectorXf found = least_squares(known.rows, values).cast<float>();
    traits.push_back({quantity.name, float(quantity.value(of_file)), found(0),
                      float(std::sqrt(left)), found.tail(family.size()),
                      along.col(Eigen::Index(j))});
  }
  return traits;
}

std::vector<TraitEstimate> beside_truth(const ArmDescription& virtual_arm,
                                        std::vector<TraitEstimate> traits) {
  const Parameters own = virtual_arm_parameters(virtual_arm);
  const std::vector<Quantity> quantities = quantities_of(virtual_arm);
  for (TraitEstimate& trait : traits) {
    const auto quantity = std::ranges::find(quantities, trait.name, &Quantity::name);
    if (quantity != quantities.end()) {
      trait.reference = quantity->value(own);
    }
  }
  return traits;
}

}  // namespace limber
