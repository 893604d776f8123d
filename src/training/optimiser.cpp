#include "optimiser.hpp"

#include <cmath>
#include <numbers>

#include "soap.hpp"
#include "training_kernels.hpp"

namespace limber {

namespace {

constexpr double kBeta1 = 0.9;
constexpr double kBeta2 = 0.999;

/// θ ← θ − η g.
class Sgd final : public OptimiserSteps {
 public:
  OptimiserState first_state() const override { return {}; }
  void step(const Eigen::VectorXf& gradient, double learning_rate, OptimiserState& state,
            Eigen::VectorXf& parameters) override {
    ++state.step;
    parameters -= float(learning_rate) * gradient;
  }
};

class Adam final : public OptimiserSteps {
 public:
  explicit Adam(Eigen::Index parameters) : parameters_(parameters) {}

  OptimiserState first_state() const override {
    OptimiserState state;
    state.first_moment.setZero(parameters_);
    state.second_moment.setZero(parameters_);
    return state;
  }
  void step(const Eigen::VectorXf& gradient, double learning_rate, OptimiserState& state,
            Eigen::VectorXf& parameters) override {
    ++state.step;
    adam_step(state.step, learning_rate, int(parameters.size()), gradient.data(),
              state.first_moment.data(), state.second_moment.data(), parameters.data());
  }

 private:
  Eigen::Index parameters_;
};

}  // namespace

std::unique_ptr<OptimiserSteps> make_optimiser(Optimiser optimiser, const ParameterLayout& layout,
                                               int networks, int jobs) {
  switch (optimiser) {
    case Optimiser::sgd:
      return std::make_unique<Sgd>();
    case Optimiser::adam:
      return std::make_unique<Adam>(layout.size() * networks);
    case Optimiser::soap:
      break;
  }
  return std::make_unique<Soap>(layout, networks, jobs);
}

void adam_step(std::int64_t step, double learning_rate, int count, const float* gradient,
               float* first_moment, float* second_moment, float* parameters) {
  const double bias1 = 1.0 - std::pow(kBeta1, double(step));
  const double bias2 = 1.0 - std::pow(kBeta2, double(step));
  optimiser_kernels().adam(count, gradient, float(learning_rate / bias1),
                           float(1.0 / std::sqrt(bias2)), first_moment, second_moment, parameters);
}

void limit_norm(Eigen::Ref<Eigen::VectorXf> gradient, double limit) {
  const double norm =
      std::sqrt(optimiser_kernels().square_sum(int(gradient.size()), gradient.data()));
  if (limit > 0.0 && norm > limit) {
    gradient *= float(limit / norm);
  }
}

double cosine_decayed(double rate, double progress) {
  return 0.5 * rate * (1.0 + std::cos(std::numbers::pi * progress));
}

}  // namespace limber
