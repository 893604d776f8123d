#include "src/training/optimiser.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr float kRounding = 1e-6F;

/// One optimiser's steps over four parameters: 1, 2, 3, 4 at first.
struct Steps {
  explicit Steps(Optimiser kind)
      : optimiser(make_optimiser(kind, ParameterLayout({1, 2}), 1, 1)),
        state(optimiser->first_state()) {}

  void step(const Eigen::Vector4f& gradient, double learning_rate) {
    optimiser->step(gradient, learning_rate, state, parameters);
  }

  std::unique_ptr<OptimiserSteps> optimiser;
  OptimiserState state;
  Eigen::VectorXf parameters = Eigen::Vector4f(1.0F, 2.0F, 3.0F, 4.0F);
};

TEST(Optimiser, SgdGoesAgainstTheGradientInProportion) {
  Steps sgd(Optimiser::sgd);
  sgd.step({10.0F, -4.0F, 0.0F, 1.0F}, 0.1);
  EXPECT_TRUE(sgd.parameters.isApprox(Eigen::Vector4f(0.0F, 2.4F, 3.0F, 3.9F), kRounding));
}

// Kingma & Ba 2015: with bias correction the first step is the learning rate, whatever the
// gradient.
TEST(Optimiser, AdamsFirstStepIsTheLearningRateInEachParameter) {
  Steps adam(Optimiser::adam);
  adam.step({1e-3F, -20.0F, 0.0F, 1.0F}, 0.01);
  EXPECT_TRUE(adam.parameters.isApprox(Eigen::Vector4f(0.99F, 2.01F, 3.0F, 3.99F), 1e-4F))
      << adam.parameters;
}

// Second step by hand: m = 0.19 g, v = 0.001999 g² of a constant gradient, both corrected to g, g².
TEST(Optimiser, AdamsStepStaysTheLearningRateUnderAConstantGradient) {
  Steps adam(Optimiser::adam);
  for (int k = 0; k < 10; ++k) {
    adam.step(Eigen::Vector4f::Constant(3.0F), 0.01);
  }
  EXPECT_NEAR(adam.parameters[0], 0.9F, 1e-4F);
  EXPECT_EQ(adam.state.step, 10);
}

TEST(Optimiser, EveryKindFindsTheMinimumOfAParabola) {
  const Eigen::Vector4f goal(3.0F, -1.0F, 0.5F, 2.0F);
  for (const Optimiser kind : {Optimiser::sgd, Optimiser::adam, Optimiser::soap}) {
    Steps run(kind);
    for (int k = 0; k < 2000; ++k) {
      run.step(2.0F * (run.parameters - goal), cosine_decayed(0.05, k / 2000.0));
    }
    EXPECT_TRUE(run.parameters.isApprox(goal, 1e-3F)) << int(kind) << ": " << run.parameters;
  }
}

TEST(LimitNorm, ShortensLongGradientsAndLeavesShortOnes) {
  Eigen::VectorXf gradient = Eigen::Vector2f(3.0F, 4.0F);
  limit_norm(gradient, 10.0);
  EXPECT_EQ(gradient, Eigen::Vector2f(3.0F, 4.0F));
  limit_norm(gradient, 0.0);
  EXPECT_EQ(gradient, Eigen::Vector2f(3.0F, 4.0F));
  limit_norm(gradient, 1.0);
  EXPECT_TRUE(gradient.isApprox(Eigen::Vector2f(0.6F, 0.8F), kRounding));
}

TEST(CosineDecay, GoesFromTheRateToZero) {
  EXPECT_DOUBLE_EQ(cosine_decayed(0.2, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(cosine_decayed(0.2, 0.5), 0.1);
  EXPECT_NEAR(cosine_decayed(0.2, 1.0), 0.0, 1e-17);
}

}  // namespace
}  // namespace limber
