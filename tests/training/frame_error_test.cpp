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
  Vector states = random_vector(30, -1.0, 1.0, 4);
  const Vector targets = random_vector(30, -1.0, 1.0, 5);
  Vector gradient(30);
  Vector unused(30);
  const Eigen::Vector2d weight(1.0, 0.3);
  error.compute(2, states.data(), targets.data(), weight.data(), gradient.data());
  for (Eigen::Index i = 0; i < 30; ++i) {
    const double value = states[i];
    states[i] = value + kDifferenceStep;
    const double above =
        error.compute(2, states.data(), targets.data(), weight.data(), unused.data());
    states[i] = value - kDifferenceStep;
    const double below =
        error.compute(2, states.data(), targets.data(), weight.data(), unused.data());
    states[i] = value;
    EXPECT_NEAR(gradient[i], (above - below) / (2 * kDifferenceStep), kDifferenceTolerance) << i;
  }
}

}  // namespace
}  // namespace limber
