#include "src/training/training_kernels.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr double kRounding = 2e-5;  // sums of some hundred products of numbers below 1, in float
constexpr double kChainRounding = 2e-4;  // sums along a chain of gaps, and their derivatives

struct Sizes {
  int blocks, stride, m, k;
};

// Around the tiles' edges; strides are whole vectors of every level.
const Sizes kSizes[] = {
    {1, 16, 1, 1}, {2, 32, 4, 6}, {3, 16, 5, 7}, {4, 48, 45, 101}, {1, 32, 100, 60}};

MatrixXf random_matrix(int rows, int columns, std::uint64_t stream) {
  RandomStream random(12, stream);
  return MatrixXf::NullaryExpr(rows, columns, [&] { return float(random.uniform(-1.0, 1.0)); });
}

double difference(const MatrixXf& a, const MatrixXd& b) {
  return (a.cast<double>() - b).cwiseAbs().maxCoeff();
}

class TrainingKernelsOfLevel : public ::testing::TestWithParam<CpuLevel> {
 protected:
  const WindowKernels<float>& kernels_ = window_kernels<float>(GetParam());
  const WindowKernels<double>& reference_ = window_kernels<double>();
  const OptimiserKernels& optimiser_ = optimiser_kernels(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Levels, TrainingKernelsOfLevel,
                         ::testing::ValuesIn(available_cpu_levels()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

TEST_P(TrainingKernelsOfLevel, LayersAgreeWithTheReference) {
  for (const auto [blocks, stride, m, k] : kSizes) {
    const MatrixXf x = random_matrix(stride, k, 1);
    const MatrixXf weight = random_matrix(m, k, 2);
    const MatrixXf bias = random_matrix(m, 1, 3);
    const MatrixXf dy = random_matrix(stride, m, 4);
    for (const bool relu : {false, true}) {
      MatrixXf y(stride, m);
      MatrixXd wanted(stride, m);
      kernels_.layer(stride, m, k, x.data(), weight.data(), bias.data(), relu, y.data());
      reference_.layer(stride, m, k, MatrixXd(x.cast<double>()).data(),
                       MatrixXd(weight.cast<double>()).data(), MatrixXd(bias.cast<double>()).data(),
                       relu, wanted.data());
      EXPECT_LT(difference(y, wanted), kRounding) << m << "x" << k;
    }
    MatrixXf dx(stride, k);
    kernels_.layer_back(stride, m, k, dy.data(), weight.data(), dx.data());
    EXPECT_LT(difference(dx, dy.cast<double>() * weight.cast<double>()), kRounding)
        << m << "x" << k;
  }
}

TEST_P(TrainingKernelsOfLevel, GradientsSumOverAllWindowsOfAllBlocks) {
  for (const auto [blocks, stride, m, k] : kSizes) {
    const int gap = 3;  // rows of x that belong to nobody, between its blocks
    const MatrixXf dy = random_matrix(stride, m * blocks, 1);
    const MatrixXf x = random_matrix(stride, (k + gap) * blocks, 2);
    const MatrixXf before = random_matrix(m, k + 1, 3);
    MatrixXd wanted = before.cast<double>();
    for (int block = 0; block < blocks; ++block) {
      const MatrixXd part = dy.middleCols(block * m, m).cast<double>();
      wanted.leftCols(k) += part.transpose() * x.middleCols(block * (k + gap), k).cast<double>();
      wanted.col(k) += part.colwise().sum();
    }
    MatrixXf gradient = before;
    kernels_.weight_gradient(blocks, stride, m, k, dy.data(), x.data(), (k + gap) * stride,
                             gradient.data());
    kernels_.bias_gradient(blocks, stride, m, dy.data(), gradient.col(k).data());
    EXPECT_LT(difference(gradient, wanted), kRounding) << m << "x" << k;
  }
}

TEST_P(TrainingKernelsOfLevel, GatherTurnsColumnsIntoRows) {
  for (const int rows : {1, 3, 16, 45}) {
    const MatrixXf columns = random_matrix(rows, 70, 1);
    std::vector<int> index;
    for (int j = 0; j < 32; ++j) {
      index.push_back((j * 37) % 70);
    }
    MatrixXf gathered(32, rows);
    kernels_.gather(rows, 32, columns.data(), rows, index.data(), gathered.data());
    for (int j = 0; j < 32; ++j) {
      EXPECT_EQ(gathered.row(j).transpose(), columns.col(index[static_cast<std::size_t>(j)])) << j;
    }
  }
}

TEST_P(TrainingKernelsOfLevel, StatesAndTheirGradientsAreScaledRowByRow) {
  const MatrixXf scale = random_matrix(1, 5, 1);
  const MatrixXf output = random_matrix(32, 5, 2);
  const MatrixXf base = random_matrix(32, 5, 3);
  MatrixXf state(32, 5);
  kernels_.add_scaled(5, 32, scale.data(), output.data(), base.data(), state.data());
  EXPECT_LT((state - base - output * scale.row(0).asDiagonal()).cwiseAbs().maxCoeff(), kRounding);

  MatrixXf carried = base;
  MatrixXf delta(32, 5);
  kernels_.carry(5, 32, scale.data(), output.data(), carried.data(), delta.data());
  EXPECT_EQ(carried, base + output);
  EXPECT_EQ(delta, carried * scale.row(0).asDiagonal());

  MatrixXf gradient = output;
  kernels_.relu_gradient(32 * 5 - 3, base.data(), gradient.data());
  for (int i = 0; i < 32 * 5; ++i) {
    EXPECT_EQ(gradient.data()[i], i < 32 * 5 - 3 && base.data()[i] <= 0 ? 0 : output.data()[i]);
  }
}

TEST_P(TrainingKernelsOfLevel, GainsAndShiftsOfUnitsAgreeWithTheReference) {
  constexpr int kCount = 32 * 5;
  const MatrixXf gain = random_matrix(32, 5, 1).array().exp();
  const MatrixXf shift = random_matrix(32, 5, 2);
  const MatrixXf delta = random_matrix(32, 5, 3);
  MatrixXf y = random_matrix(32, 5, 4);
  MatrixXf dy = delta;
  MatrixXf dlog_gain = random_matrix(32, 5, 5);  // they add up over frames
  MatrixXf dshift = random_matrix(32, 5, 6);
  const auto exact = [](const MatrixXf& m) { return MatrixXd(m.cast<double>()); };
  MatrixXd exact_y = exact(y);
  MatrixXd exact_dy = exact(dy);
  MatrixXd exact_dlog_gain = exact(dlog_gain);
  MatrixXd exact_dshift = exact(dshift);
  const MatrixXd exact_gain = exact(gain);
  const MatrixXd exact_shift = exact(shift);
  const WindowKernels<double>& reference = window_kernels<double>();
  reference.modulate(kCount, exact_gain.data(), exact_shift.data(), exact_y.data());
  reference.modulate_back(kCount, exact_gain.data(), exact_y.data(), exact_dy.data(),
                          exact_dlog_gain.data(), exact_dshift.data());
  kernels_.modulate(kCount, gain.data(), shift.data(), y.data());
  kernels_.modulate_back(kCount, gain.data(), y.data(), dy.data(), dlog_gain.data(), dshift.data());
  EXPECT_GT((y.array() > 0.0F).count(), 20);
  EXPECT_GT((y.array() == 0.0F).count(), 20);
  EXPECT_LT((exact(y) - exact_y).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT((exact(dy) - exact_dy).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT((exact(dlog_gain) - exact_dlog_gain).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT((exact(dshift) - exact_dshift).cwiseAbs().maxCoeff(), kRounding);
}

// A loss that is no number stops a run: what has diverged must not come back as a dead unit.
TEST_P(TrainingKernelsOfLevel, UnitsThatAreNoNumberStaySo) {
  constexpr int kCount = 32;
  const VectorXf gain = VectorXf::Constant(kCount, 2.0F);
  const VectorXf shift = VectorXf::Ones(kCount);
  VectorXf y = VectorXf::Zero(kCount);
  y[5] = std::numeric_limits<float>::quiet_NaN();
  kernels_.modulate(kCount, gain.data(), shift.data(), y.data());
  EXPECT_TRUE(std::isnan(y[5]));
  EXPECT_EQ(y[4], 2.0F);
}

TEST_P(TrainingKernelsOfLevel, GatedChangesAgreeWithTheReference) {
  constexpr int kSize = 5;
  constexpr int kStride = 32;
  const MatrixXf scale = random_matrix(kSize, 1, 1);
  const MatrixXf output = 20.0F * random_matrix(kStride, 2 * kSize, 2);  // gates from 0 to 1
  const MatrixXf base = random_matrix(kStride, kSize, 3);
  const MatrixXf previous = random_matrix(kStride, kSize, 4);
  const MatrixXf error = random_matrix(kStride, kSize, 5);
  const MatrixXf carried = random_matrix(kStride, kSize, 6);
  const auto exact = [](const MatrixXf& m) { return MatrixXd(m.cast<double>()); };
  MatrixXf gate(kStride, kSize);
  MatrixXf state(kStride, kSize);
  MatrixXd exact_gate(kStride, kSize);
  MatrixXd exact_state(kStride, kSize);
  kernels_.gated_change(kSize, kStride, scale.data(), output.data(), base.data(), previous.data(),
                        gate.data(), state.data());
  reference_.gated_change(kSize, kStride, exact(scale).data(), exact(output).data(),
                          exact(base).data(), exact(previous).data(), exact_gate.data(),
                          exact_state.data());
  EXPECT_LT(difference(gate, exact_gate), kRounding);
  EXPECT_LT(difference(state, exact_state), kRounding);

  MatrixXf direct = random_matrix(kStride, kSize, 7);
  MatrixXd exact_direct = exact(direct);
  MatrixXf delta(kStride, 2 * kSize);
  MatrixXd exact_delta(kStride, 2 * kSize);
  kernels_.gated_carry(kSize, kStride, scale.data(), error.data(), base.data(), previous.data(),
                       gate.data(), carried.data(), direct.data(), delta.data());
  reference_.gated_carry(kSize, kStride, exact(scale).data(), exact(error).data(),
                         exact(base).data(), exact(previous).data(), exact_gate.data(),
                         exact(carried).data(), exact_direct.data(), exact_delta.data());
  EXPECT_LT(difference(direct, exact_direct), kRounding);
  EXPECT_LT(difference(delta, exact_delta), kRounding);
}

TEST_P(TrainingKernelsOfLevel, FrameErrorsAgreeWithTheReference) {
  constexpr int kGaps = 15;
  constexpr int kSize = 3 * kGaps;
  constexpr int kStride = 32;
  const MatrixXf weight = random_matrix(kSize, 1, 1).array() + 1.5F;
  const MatrixXf scale = 0.2F * random_matrix(kSize, 1, 2).array() + 0.4F;
  const MatrixXf offset = 0.2F * random_matrix(kSize, 1, 3);
  const MatrixXf state = random_matrix(kStride, kSize, 4);
  const MatrixXf target = random_matrix(kStride, kSize, 5);
  const MatrixXf of_window = random_matrix(kStride, 1, 6).cwiseAbs();
  const auto exact = [](const MatrixXf& m) { return MatrixXd(m.cast<double>()); };
  MatrixXf gradient(kStride, kSize);
  MatrixXd wanted(kStride, kSize);
  VectorXf scratch(2 * kGaps * kernels_.lanes);
  Eigen::VectorXd exact_scratch(2 * kGaps);

  double error = kernels_.entry_error(kSize, kStride, weight.data(), state.data(), target.data(),
                                      of_window.data(), gradient.data());
  double exact_error =
      reference_.entry_error(kSize, kStride, exact(weight).data(), exact(state).data(),
                             exact(target).data(), exact(of_window).data(), wanted.data());
  EXPECT_NEAR(error, exact_error, kRounding * exact_error);
  EXPECT_LT(difference(gradient, wanted), kRounding);

  error = kernels_.chained_error(kGaps, kStride, weight.data(), scale.data(), offset.data(),
                                 state.data(), target.data(), of_window.data(), gradient.data(),
                                 scratch.data());
  exact_error =
      reference_.chained_error(kGaps, kStride, exact(weight).data(), exact(scale).data(),
                               exact(offset).data(), exact(state).data(), exact(target).data(),
                               exact(of_window).data(), wanted.data(), exact_scratch.data());
  EXPECT_NEAR(error, exact_error, kRounding * exact_error);
  EXPECT_LT(difference(gradient, wanted), kChainRounding * wanted.cwiseAbs().maxCoeff());
}

TEST_P(TrainingKernelsOfLevel, EqualStatesHaveNoErrorAndNoGradient) {
  const MatrixXf state = random_matrix(16, 6, 1);
  const VectorXf ones = VectorXf::Ones(16);
  MatrixXf gradient(16, 6);
  EXPECT_EQ(kernels_.entry_error(6, 16, ones.data(), state.data(), state.data(), ones.data(),
                                 gradient.data()),
            0.0F);
  EXPECT_TRUE(gradient.isZero(0.0F));
}

TEST_P(TrainingKernelsOfLevel, VectorsAddUp) {
  for (const int count : {1, 15, 16, 1000, 5003}) {
    const VectorXf a = random_matrix(count, 1, 1);
    VectorXf sum = random_matrix(count, 1, 2);
    const VectorXf wanted = sum + a;
    optimiser_.add(count, a.data(), sum.data());
    EXPECT_EQ(sum, wanted);
    const double square = a.cast<double>().squaredNorm();
    EXPECT_NEAR(optimiser_.square_sum(count, a.data()), square, 1e-6 * square);
  }
}

}  // namespace
}  // namespace limber
