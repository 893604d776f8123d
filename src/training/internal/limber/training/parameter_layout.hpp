#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/network/compensation_model.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

/// The vectors e of a family's training arms, as parameters: k numbers for each of N arms.
struct ArmVectorTable {
  int size = 0;   ///< k; 0: one arm, and no such vectors
  int count = 0;  ///< N
};

/// Where the weights and biases of a network lie in one flat vector: layer by layer, the weight
/// (out × in, column-major), then the bias. Behind them, of a family, what e does to each hidden
/// layer (2·out × k: the units' log gains, then their shifts), and arm by arm the vectors e divided
/// by kArmVectorScale. Optimisers see the flat vector alone.
class ParameterLayout {
 public:
  /// @param widths  inputs, hidden layers, outputs: at least two numbers ≥ 1
  explicit ParameterLayout(std::vector<int> widths, ArmVectorTable arms = {});

  int layer_count() const { return int(widths_.size()) - 1; }
  int inputs(int layer) const { return widths_[layer]; }
  int outputs(int layer) const { return widths_[std::size_t(layer) + 1]; }
  /// Numbers in the flat vector.
  Eigen::Index size() const { return arm_offset(arms_.count); }
  const ArmVectorTable& arms() const { return arms_; }
  Eigen::Index arm_offset(int arm) const { return arms_at_ + Eigen::Index(arm) * arms_.size; }
  /// Of what e does to hidden layer `layer`.
  Eigen::Index modulation_offset(int layer) const { return modulation_offsets_[layer]; }
  Eigen::Index weight_offset(int layer) const { return offsets_[layer]; }
  Eigen::Index bias_offset(int layer) const {
    return weight_offset(layer) + Eigen::Index(inputs(layer)) * outputs(layer);
  }

 private:
  std::vector<int> widths_;
  ArmVectorTable arms_;
  std::vector<Eigen::Index> offsets_;
  std::vector<Eigen::Index> modulation_offsets_;  ///< of the hidden layers
  Eigen::Index arms_at_ = 0;
};

/// An optimiser whose steps are of one size moves the arms' vectors by so much more than weights.
inline constexpr float kArmVectorScale = 7.0F;

/// He's weights are uniform within ± √(6 / inputs), those of the last layer a tenth of that: so
/// training starts near the no-load model. Draws from the streams `first_stream`,
/// `first_stream` + 1, … of `seed`, one per layer, and one for the arms' vectors, which are normal
/// with a standard deviation of 0.3.
Eigen::VectorXf initial_parameters(const ParameterLayout& layout, std::uint64_t seed,
                                   std::uint64_t first_stream = 0,
                                   FirstWeights kind = FirstWeights::he);

/// Sets the biases of the last `gates` outputs, those of (16)'s gates.
void set_gate_biases(const ParameterLayout& layout, int gates, double bias,
                     Eigen::VectorXf& parameters);

std::vector<Layer> to_layers(const ParameterLayout& layout, const Eigen::VectorXf& parameters);
Eigen::VectorXf to_parameters(const ParameterLayout& layout, const std::vector<Layer>& layers);

/// The family that such a network and its arms' vectors are, in a scale in which these have mean 0
/// and unit covariance.
void make_family(const ParameterLayout& layout, const Eigen::VectorXf& parameters,
                 CompensationModel& model);

}  // namespace limber
