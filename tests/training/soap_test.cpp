#include "src/training/soap.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

using Eigen::Map;
using Eigen::MatrixXf;
using Eigen::VectorXf;

MatrixXf random_matrix(int rows, int columns, std::uint64_t stream) {
  RandomStream random(31, stream);
  return MatrixXf::NullaryExpr(rows, columns, [&] { return float(random.normal()); });
}

MatrixXf random_rotation(int size, std::uint64_t stream) {
  const Eigen::HouseholderQR<MatrixXf> factors(random_matrix(size, size, stream));
  return factors.householderQ();
}

/// ½‖A·(W − goal)·B‖² of one weight, whose two sides stretch some directions 10 times as much as
/// others.
struct Valley {
  static constexpr int kRows = 6;
  static constexpr int kColumns = 6;

  static MatrixXf stretched(int size, std::uint64_t stream) {
    const VectorXf lengths = VectorXf::LinSpaced(size, 0.0F, 1.0F).unaryExpr([](float v) {
      return std::pow(10.0F, -v);
    });
    return random_rotation(size, stream) * lengths.asDiagonal() *
           random_rotation(size, stream + 1).transpose();
  }
  MatrixXf gradient(const MatrixXf& weight) const {
    return a.transpose() * a * (weight - goal) * b * b.transpose();
  }
  float left(const MatrixXf& weight) const { return (weight - goal).norm() / goal.norm(); }

  MatrixXf goal = random_matrix(kRows, kColumns, 0);
  MatrixXf a = stretched(kRows, 1);
  MatrixXf b = stretched(kColumns, 3);
};

const ParameterLayout kLayout({Valley::kColumns, Valley::kRows});

VectorXf parameters_of(const MatrixXf& weight) {
  VectorXf parameters = VectorXf::Zero(kLayout.size());
  parameters.head(weight.size()) = weight.reshaped();
  return parameters;
}

MatrixXf weight_of(const VectorXf& parameters) {
  return Map<const MatrixXf>(parameters.data(), Valley::kRows, Valley::kColumns);
}

TEST(Soap, DescendsAValleyThatAdamCreepsAlong) {
  constexpr int kSteps = 600;
  const Valley valley;
  VectorXf by_adam = VectorXf::Zero(kLayout.size());
  VectorXf by_soap = by_adam;
  const std::unique_ptr<OptimiserSteps> adam = make_optimiser(Optimiser::adam, kLayout, 1, 1);
  OptimiserState adam_state = adam->first_state();
  Soap soap(kLayout, 1, 1);
  OptimiserState state = soap.first_state();
  for (int k = 0; k < kSteps; ++k) {
    const double rate = cosine_decayed(0.02, double(k) / kSteps);
    adam->step(parameters_of(valley.gradient(weight_of(by_adam))), rate, adam_state, by_adam);
    soap.step(parameters_of(valley.gradient(weight_of(by_soap))), rate, state, by_soap);
  }
  EXPECT_LT(valley.left(weight_of(by_soap)), 0.5F * valley.left(weight_of(by_adam)));
}

// Who turns inputs and outputs of a layer gets the turned steps: Adam's steps know no such law.
TEST(Soap, StepsTurnWithTheCoordinates) {
  const MatrixXf p = random_rotation(Valley::kRows, 7);
  const MatrixXf q = random_rotation(Valley::kColumns, 8);
  Soap soap(kLayout, 1, 1);
  OptimiserState plain_state = soap.first_state();
  OptimiserState turned_state = soap.first_state();
  VectorXf plain = VectorXf::Zero(kLayout.size());
  VectorXf turned = plain;
  for (int k = 0; k < 60; ++k) {  // more than one set of eigenvectors
    // Whole in every direction: what no gradient has is moved by rounding alone.
    const MatrixXf g =
        Valley().a * random_matrix(Valley::kRows, Valley::kColumns, 100 + k) * Valley().b;
    soap.step(parameters_of(g), 0.01, plain_state, plain);
    soap.step(parameters_of(p * g * q), 0.01, turned_state, turned);
  }
  const MatrixXf expected = p * weight_of(plain) * q;
  EXPECT_GT(expected.norm(), 0.3F);
  EXPECT_LT((weight_of(turned) - expected).norm(), 0.02F * expected.norm());
}

TEST(Soap, BiasesAndArmsTakeAdamsSteps) {
  const ParameterLayout layout({4, 3, 2}, {2, 5});
  Soap soap(layout, 1, 1);
  OptimiserState state = soap.first_state();
  VectorXf by_soap = VectorXf::Zero(layout.size());
  VectorXf by_adam = by_soap;
  const std::unique_ptr<OptimiserSteps> adam = make_optimiser(Optimiser::adam, layout, 1, 1);
  OptimiserState adam_state = adam->first_state();
  for (int k = 0; k < 5; ++k) {
    const VectorXf gradient = random_matrix(int(layout.size()), 1, 300 + k);
    soap.step(gradient, 0.01, state, by_soap);
    adam->step(gradient, 0.01, adam_state, by_adam);
  }
  for (const int layer : {0, 1}) {
    const auto bias = [&](const VectorXf& parameters) {
      return VectorXf(parameters.segment(layout.bias_offset(layer), layout.outputs(layer)));
    };
    EXPECT_EQ(bias(by_soap), bias(by_adam));
  }
  EXPECT_EQ(VectorXf(by_soap.tail(10)), VectorXf(by_adam.tail(10)));
}

TEST(Soap, EachOfSeveralNetworksStepsAsAloneWithAnyNumberOfThreads) {
  const ParameterLayout layout({21, 17, 3});
  constexpr int kNetworks = 3;
  Soap alone(layout, 1, 1);
  Soap together(layout, kNetworks, 2);
  std::vector<OptimiserState> states(kNetworks, alone.first_state());
  std::vector<VectorXf> one_by_one(kNetworks, VectorXf::Zero(layout.size()));
  OptimiserState state = together.first_state();
  VectorXf all = VectorXf::Zero(layout.size() * kNetworks);
  for (int k = 0; k < 50; ++k) {
    const VectorXf gradient = random_matrix(int(all.size()), 1, 500 + k);
    together.step(gradient, 0.01, state, all);
    for (int n = 0; n < kNetworks; ++n) {
      const auto own = static_cast<std::size_t>(n);
      alone.step(gradient.segment(n * layout.size(), layout.size()), 0.01, states[own],
                 one_by_one[own]);
    }
  }
  for (int n = 0; n < kNetworks; ++n) {
    EXPECT_EQ(VectorXf(all.segment(n * layout.size(), layout.size())),
              one_by_one[static_cast<std::size_t>(n)]);
  }
}

}  // namespace
}  // namespace limber
