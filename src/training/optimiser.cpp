#include "limber/training/optimiser.hpp"

#include <cmath>
#include <numbers>

namespace limber {

namespace {

constexpr double kBeta1 = 0.9;
constexpr double kBeta2 = 0.999;
constexpr double kEpsilon = 1e-8;

void adam_step(const Eigen::VectorXf& gradient, double learning_rate, OptimiserState& state,
               Eigen::VectorXf& parameters) {
  const auto step = static_cast<double>(state.step);
  const double bias1 = 1.0 - std::pow(kBeta1, step);
  const double bias2 = 1.0 - std::pow(kBeta2, step);
  const auto rate = static_cast<float>(learning_rate / bias1);
  const auto root_bias2 = static_cast<float>(1.0 / std::sqrt(bias2));
  auto m = state.first_moment.array();
  auto v = state.second_moment.array();
  m = static_cast<float>(kBeta1) * m + static_cast<float>(1.0 - kBeta1) * gradient.array();
  v = static_cast<float>(kBeta2) * v + static_cast<float>(1.0 - kBeta2) * gradient.array().square();
  parameters.array() -= rate * m / (v.sqrt() * root_bias2 + static_cast<float>(kEpsilon));
}

}  // namespace

OptimiserState::OptimiserState(Optimiser optimiser, Eigen::Index parameters) {
  if (optimiser == Optimiser::adam) {
    first_moment.setZero(parameters);
    second_moment.setZero(parameters);
  }
}

void optimiser_step(Optimiser optimiser, const Eigen::VectorXf& gradient, double learning_rate,
                    OptimiserState& state, Eigen::VectorXf& parameters) {
  ++state.step;
  if (optimiser == Optimiser::adam) {
    adam_step(gradient, learning_rate, state, parameters);
  } else {
    parameters -= static_cast<float>(learning_rate) * gradient;
  }
}

double limit_norm(Eigen::VectorXf& gradient, double limit) {
  const double norm = std::sqrt(gradient.cast<double>().squaredNorm());
  if (limit > 0.0 && norm > limit) {
    gradient *= static_cast<float>(limit / norm);
  }
  return norm;
}

double cosine_decayed(double rate, double progress) {
  return 0.5 * rate * (1.0 + std::cos(std::numbers::pi * progress));
}

}  // namespace limber
