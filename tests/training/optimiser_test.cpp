#include "src/training/optimiser.hpp"

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr float kRounding = 1e-6F;

TEST(Optimiser, SgdGoesAgainstTheGradientInProportion) {
  Eigen::VectorXf parameters = Eigen::Vector2f(1.0F, 2.0F);
  OptimiserState state(Optimiser::sgd, 2);
  optimiser_step(Optimiser::sgd, Eigen::Vector2f(10.0F, -4.0F), 0.1, state, parameters);
  EXPECT_TRUE(parameters.isApprox(Eigen::Vector2f(0.0F, 2.4F), kRounding));
}

// Kingma & Ba 2015: with bias correction the first step is the learning rate, whatever the
// gradient.
TEST(Optimiser, AdamsFirstStepIsTheLearningRateInEachParameter) {
  Eigen::VectorXf parameters = Eigen::Vector3f(1.0F, 1.0F, 1.0F);
  OptimiserState state(Optimiser::adam, 3);
  optimiser_step(Optimiser::adam, Eigen::Vector3f(1e-3F, -20.0F, 0.0F), 0.01, state, parameters);
  EXPECT_TRUE(parameters.isApprox(Eigen::Vector3f(0.99F, 1.01F, 1.0F), 1e-4F)) << parameters;
}

// Second step by hand: m = 0.19 g, v = 0.001999 g² of a constant gradient, both corrected to g, g².
TEST(Optimiser, AdamsStepStaysTheLearningRateUnderAConstantGradient) {
  Eigen::VectorXf parameters = Eigen::VectorXf::Zero(1);
  OptimiserState state(Optimiser::adam, 1);
  for (int k = 0; k < 10; ++k) {
    optimiser_step(Optimiser::adam, Eigen::VectorXf::Constant(1, 3.0F), 0.01, state, parameters);
  }
  EXPECT_NEAR(parameters[0], -0.1F, 1e-4F);
  EXPECT_EQ(state.step, 10);
}

TEST(Optimiser, FindsTheMinimumOfAParabola) {
  const Eigen::Vector2f goal(3.0F, -1.0F);
  Eigen::VectorXf parameters = Eigen::VectorXf::Zero(2);
  OptimiserState state(Optimiser::adam, 2);
  for (int k = 0; k < 2000; ++k) {
    const Eigen::VectorXf gradient = 2.0F * (parameters - goal);
    optimiser_step(Optimiser::adam, gradient, cosine_decayed(0.05, k / 2000.0), state, parameters);
  }
  EXPECT_TRUE(parameters.isApprox(goal, 1e-3F)) << parameters;
}

TEST(LimitNorm, ShortensLongGradientsAndLeavesShortOnes) {
  Eigen::VectorXf gradient = Eigen::Vector2f(3.0F, 4.0F);
  EXPECT_NEAR(limit_norm(gradient, 10.0), 5.0, kRounding);
  EXPECT_EQ(gradient, Eigen::Vector2f(3.0F, 4.0F));
  EXPECT_NEAR(limit_norm(gradient, 1.0), 5.0, kRounding);
  EXPECT_TRUE(gradient.isApprox(Eigen::Vector2f(0.6F, 0.8F), kRounding));
  EXPECT_NEAR(limit_norm(gradient, 0.0), 1.0, kRounding);
}

TEST(CosineDecay, GoesFromTheRateToZero) {
  EXPECT_DOUBLE_EQ(cosine_decayed(0.2, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(cosine_decayed(0.2, 0.5), 0.1);
  EXPECT_NEAR(cosine_decayed(0.2, 1.0), 0.0, 1e-17);
}

}  // namespace
}  // namespace limber
