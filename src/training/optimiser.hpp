#pragma once

#include <cstdint>
#include <memory>

#include <Eigen/Core>

#include "limber/training/parameter_layout.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

/// Everything that an optimiser remembers between steps, so that a run can be stored and continued.
struct OptimiserState {
  Eigen::VectorXf first_moment;   ///< Adam's m; empty for SGD
  Eigen::VectorXf second_moment;  ///< Adam's v; empty for SGD
  Eigen::VectorXf rotations;      ///< SOAP's (soap.hpp); empty for all others
  std::int64_t step = 0;          ///< steps taken
};

/// The steps of one kind of optimiser, over all networks that are trained together.
class OptimiserSteps {
 public:
  virtual ~OptimiserSteps() = default;

  /// No step taken: all zero.
  virtual OptimiserState first_state() const = 0;
  /// @param gradient  of the parameters, as long as they are
  virtual void step(const Eigen::VectorXf& gradient, double learning_rate, OptimiserState& state,
                    Eigen::VectorXf& parameters) = 0;
};

/// @param networks  ≥ 1, of this layout, one behind the other among the parameters
/// @param jobs      threads, 0: one per core
std::unique_ptr<OptimiserSteps> make_optimiser(Optimiser optimiser, const ParameterLayout& layout,
                                               int networks, int jobs);

/// Adam with β₁ = 0.9, β₂ = 0.999, ε = 1e-8 (Kingma & Ba 2015, algorithm 1), its step number `step`
/// ≥ 1, of `count` parameters with their gradient and moments.
void adam_step(std::int64_t step, double learning_rate, int count, const float* gradient,
               float* first_moment, float* second_moment, float* parameters);

/// Shortens `gradient` to `limit` if it is longer; 0 means no limit.
void limit_norm(Eigen::Ref<Eigen::VectorXf> gradient, double limit);

/// Half a cosine from `rate` at progress 0 to zero at 1.
double cosine_decayed(double rate, double progress);

}  // namespace limber
