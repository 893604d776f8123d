#include "optimiser.hpp"

#include <cmath>
#include <numbers>

#include "training_kernels.hpp"

namespace limber {

namespace {

constexpr double kBeta1 = 0.9;
constexpr double kBeta2 = 0.999;

}  // namespace

OptimiserState::OptimiserState(Optimiser optimiser, Eigen::Index parameters) {
  if (optimiser == Optimiser::adam) {
    first_moment.setZero(parameters);
    second_moment.setZero(parameters);
  }
}

void adam_step(std::int64_t step, double learning_rate, int count, const float* gradient,
               float* first_moment, float* second_moment, float* parameters) {
  const double bias1 = 1.0 - std::pow(kBeta1, static_cast<double>(step));
  const double bias2 = 1.0 - std::pow(kBeta2, static_cast<double>(step));
  optimiser_kernels().adam(count, gradient, static_cast<float>(learning_rate / bias1),
                           static_cast<float>(1.0 / std::sqrt(bias2)), first_moment, second_moment,
                           parameters);
}

void optimiser_step(Optimiser optimiser, const Eigen::VectorXf& gradient, double learning_rate,
                    OptimiserState& state, Eigen::VectorXf& parameters) {
  ++state.step;
  if (optimiser == Optimiser::adam) {
    adam_step(state.step, learning_rate, static_cast<int>(parameters.size()), gradient.data(),
              state.first_moment.data(), state.second_moment.data(), parameters.data());
  } else {
    parameters -= static_cast<float>(learning_rate) * gradient;
  }
}

double limit_norm(Eigen::Ref<Eigen::VectorXf> gradient, double limit) {
  const double norm =
      std::sqrt(optimiser_kernels().square_sum(static_cast<int>(gradient.size()), gradient.data()));
  if (limit > 0.0 && norm > limit) {
    gradient *= static_cast<float>(limit / norm);
  }
  return norm;
}

double cosine_decayed(double rate, double progress) {
  return 0.5 * rate * (1.0 + std::cos(std::numbers::pi * progress));
}

}  // namespace limber
