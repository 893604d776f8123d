#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "kernels/job_arena.hpp"
#include "limber/training/parameter_layout.hpp"
#include "optimiser.hpp"

namespace limber {

/// SOAP (Vyas et al. 2024, "SOAP: Improving and Stabilizing Shampoo using Adam"): Adam, but the
/// gradient G (m×k) of a weight is first turned into the directions in which its gradients vary,
/// Uᵀ·G·V with the eigenvectors of the moving averages of G·Gᵀ and of Gᵀ·G. Biases and the vectors
/// of a family's arms take Adam's own steps. Letters: N networks, m outputs and k inputs of a layer
/// each.
///
/// A weight's moments lie in OptimiserState where the weight lies among the parameters, in turned
/// directions; averages and eigenvectors lie in its `rotations`. The same bits for any number of
/// threads.
class Soap final : public OptimiserSteps {
 public:
  /// @param networks  N ≥ 1, of this layout, one behind the other among the parameters
  /// @param jobs      threads, 0: one per core
  Soap(const ParameterLayout& layout, int networks, int jobs);

  OptimiserState first_state() const override;
  /// The first step leaves the weights as they are, and begins the averages.
  void step(const Eigen::VectorXf& gradient, double learning_rate, OptimiserState& state,
            Eigen::VectorXf& parameters) override;

 private:
  /// One network's weight of a layer.
  struct Weight {
    int m;
    int k;
    Eigen::Index at;            ///< among the parameters
    Eigen::Index rotations_at;  ///< in OptimiserState::rotations
  };

  void add_weight(int m, int k, Eigen::Index at);
  static void step_weight(const Weight& weight, const float* gradient, double learning_rate,
                          OptimiserState& state, float* parameters);

  Eigen::Index parameters_;  ///< of all networks
  Eigen::Index rotations_ = 0;
  std::vector<Weight> weights_;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> others_;  ///< first and behind the last
  JobArena arena_;
};

}  // namespace limber
