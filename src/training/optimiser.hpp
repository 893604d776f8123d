#pragma once

#include <Eigen/Core>

#include "limber/training/training_settings.hpp"

namespace limber {

/// Everything that an optimiser remembers between steps, so that a run can be stored and continued.
struct OptimiserState {
  Eigen::VectorXf first_moment;   ///< Adam's m; empty for SGD
  Eigen::VectorXf second_moment;  ///< Adam's v; empty for SGD
  Eigen::VectorXf rotations;      ///< SOAP's (soap.hpp); empty for all others
  std::int64_t step = 0;          ///< steps taken

  OptimiserState() = default;
  OptimiserState(Optimiser optimiser, Eigen::Index parameters);
};

/// Adam with β₁ = 0.9, β₂ = 0.999, ε = 1e-8 (Kingma & Ba 2015, algorithm 1), its step number `step`
/// ≥ 1, of `count` parameters with their gradient and moments.
void adam_step(std::int64_t step, double learning_rate, int count, const float* gradient,
               float* first_moment, float* second_moment, float* parameters);

/// One step of SGD or of Adam.
void optimiser_step(Optimiser optimiser, const Eigen::VectorXf& gradient, double learning_rate,
                    OptimiserState& state, Eigen::VectorXf& parameters);

/// Shortens `gradient` to `limit` if it is longer; 0 means no limit. Returns its norm before.
double limit_norm(Eigen::Ref<Eigen::VectorXf> gradient, double limit);

/// Half a cosine from `rate` at progress 0 to zero at 1.
double cosine_decayed(double rate, double progress);

}  // namespace limber
