#include "limber/training/frame_error.hpp"

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"
#include "limber/network/backbone_layout.hpp"

namespace limber {
namespace {

using Vector = Eigen::VectorXd;

constexpr double kDifferenceStep = 1e-6;
constexpr double kDifferenceTolerance = 1e-7;
constexpr double kRounding = 1e-13;

Vector random_vector(Eigen::Index size, double low, double high, std::uint64_t stream) {
  RandomStream random(4, stream);
  return Vector::NullaryExpr(size, [&] { return random.uniform(low, high); });
}

/// Compares the gradient of two windows with central differences, number by number.
void expect_gradient(FrameError<double>& error, Vector states, const Vector& targets,
                     double tolerance) {
  const Eigen::Vector2d weight(1.0, 0.3);
  Vector gradient(states.size());
  Vector unused(states.size());
  error.compute(2, states.data(), targets.data(), weight.data(), gradient.data());
  for (Eigen::Index i = 0; i < states.size(); ++i) {
    const double value = states[i];
    states[i] = value + kDifferenceStep;
    const double above =
        error.compute(2, states.data(), targets.data(), weight.data(), unused.data());
    states[i] = value - kDifferenceStep;
    const double below =
        error.compute(2, states.data(), targets.data(), weight.data(), unused.data());
    states[i] = value;
    EXPECT_NEAR(gradient[i], (above - below) / (2.0 * kDifferenceStep), tolerance) << i;
  }
}

TEST(FrameError, EntrywiseIsTheWeightedSumOfAbsoluteDifferences) {
  FrameError<double> error(Eigen::Vector2d(2.0, 10.0));
  // Two windows along the rows: (1, 1) and (0, 0.5).
  const Eigen::Vector4d states(1.0, 0.0, 1.0, 0.5);
  const Eigen::Vector4d targets(0.0, 0.0, 1.5, 0.25);
  const Eigen::Vector2d window_weight(1.0, 0.5);
  Eigen::Vector4d gradient;
  EXPECT_DOUBLE_EQ(
      error.compute(2, states.data(), targets.data(), window_weight.data(), gradient.data()),
      7.0 + 0.5 * 2.5);
  EXPECT_EQ(gradient, Eigen::Vector4d(2.0, 0.0, -10.0, 5.0));
}

TEST(FrameError, ChainedComparesPosesAboutTheBase) {
  const Vector scale = random_vector(15, 0.1, 0.5, 1);
  const Vector offset = random_vector(15, -0.2, 0.2, 2);
  const Vector weight = random_vector(15, 1.0, 3.0, 3);
  const Vector state = random_vector(15, -1.0, 1.0, 4);
  const Vector target = random_vector(15, -1.0, 1.0, 5);
  FrameError<double> error(weight, scale, offset);
  Vector gradient(15);
  const Vector poses = base_poses_of(state.cwiseProduct(scale) + offset).bottomRows(15);
  const double whole = 1.0;
  EXPECT_NEAR(error.compute(1, state.data(), target.data(), &whole, gradient.data()),
              weight.dot((poses - target).cwiseAbs()), kRounding);
}

TEST(FrameError, ChainedGradientAgreesWithFiniteDifferences) {
  FrameError<double> error(random_vector(15, 1.0, 3.0, 3), random_vector(15, 0.1, 0.5, 1),
                           random_vector(15, -0.2, 0.2, 2));
  expect_gradient(error, random_vector(30, -1.0, 1.0, 4), random_vector(30, -1.0, 1.0, 5),
                  kDifferenceTolerance);
}

constexpr int kSpaceGaps = 4;
constexpr Eigen::Index kSpaceStates = kSpaceGapSize * kSpaceGaps;
constexpr Eigen::Index kSpacePoses = kSpacePoseSize * kSpaceGaps;

FrameError<double> space_error() {
  return FrameError<double>(random_vector(kSpacePoses, 1.0, 3.0, 3),
                            random_vector(kSpaceStates, 0.1, 0.9, 1),
                            random_vector(kSpaceStates, -0.2, 0.2, 2), Dimension::space);
}

TEST(FrameError, InSpaceItComparesPosesAboutTheBase) {
  FrameError<double> error = space_error();
  const Vector state = random_vector(kSpaceStates, -1.0, 1.0, 4);
  const Vector target = random_vector(kSpacePoses, -1.0, 1.0, 5);
  Vector gradient(kSpaceStates);
  const Vector poses =
      base_poses_of(state.cwiseProduct(error.scale()) + error.offset(), Dimension::space)
          .bottomRows(kSpacePoses);
  const double whole = 1.0;
  EXPECT_NEAR(error.compute(1, state.data(), target.data(), &whole, gradient.data()),
              error.weight().dot((poses - target).cwiseAbs()), 1e-9);
}

TEST(FrameError, InSpaceItsGradientAgreesWithFiniteDifferences) {
  FrameError<double> error = space_error();
  expect_gradient(error, random_vector(2 * kSpaceStates, -1.0, 1.0, 4),
                  random_vector(2 * kSpacePoses, -1.0, 1.0, 5), 1e-6);
}

TEST(FrameError, InSpaceFloatAgreesWithDouble) {
  FrameError<double> error = space_error();
  FrameError<float> fast = error.cast<float>();
  constexpr int kStride = 32;
  const Vector states = random_vector(kStride * kSpaceStates, -1.0, 1.0, 4);
  const Vector targets = random_vector(kStride * kSpacePoses, -1.0, 1.0, 5);
  const Vector weight = random_vector(kStride, 0.1, 1.0, 6);
  Vector gradient(states.size());
  const double expected =
      error.compute(kStride, states.data(), targets.data(), weight.data(), gradient.data());
  const Eigen::VectorXf states_f = states.cast<float>();
  const Eigen::VectorXf targets_f = targets.cast<float>();
  const Eigen::VectorXf weight_f = weight.cast<float>();
  Eigen::VectorXf gradient_f(states.size());
  EXPECT_NEAR(double(fast.compute(kStride, states_f.data(), targets_f.data(), weight_f.data(),
                                  gradient_f.data())),
              expected, 1e-4 * expected);
  EXPECT_LT((gradient_f.cast<double>() - gradient).norm(), 1e-4 * gradient.norm());
}

}  // namespace
}  // namespace limber
