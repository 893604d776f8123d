#include "limber/network/gemm_kernels.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Core>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr double kRounding = 1e-5;  // sums of up to 300 products of numbers below 1, in float
constexpr float kUntouched = -77.0F;

MatrixXf random_matrix(int rows, int columns, std::uint64_t stream) {
  RandomStream random(11, stream);
  return MatrixXf::NullaryExpr(rows, columns, [&] { return float(random.uniform(-1.0, 1.0)); });
}

struct Sizes {
  int m, n, k;
};

// Around every edge: nothing, one, a vector and one more, several tiles, several blocks of k.
const Sizes kSizes[] = {{1, 1, 1},     {3, 5, 7},      {16, 6, 4},   {17, 7, 0},    {33, 13, 129},
                        {64, 12, 128}, {100, 65, 102}, {48, 1, 100}, {5, 300, 257}, {0, 3, 2},
                        {100, 2, 129}, {112, 3, 102},  {130, 2, 7},  {272, 3, 300}};

class GemmKernelsOfLevel : public ::testing::TestWithParam<CpuLevel> {};

INSTANTIATE_TEST_SUITE_P(Levels, GemmKernelsOfLevel, ::testing::ValuesIn(available_cpu_levels()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

// C sits in a taller array whose other rows must stay as they are.
struct Guarded {
  explicit Guarded(const MatrixXf& c)
      : storage(MatrixXf::Constant(c.rows() + 3, c.cols(), kUntouched)) {
    storage.topRows(c.rows()) = c;
  }
  void expect(const Eigen::MatrixXd& wanted) const {
    const MatrixXf c = storage.topRows(wanted.rows());
    EXPECT_TRUE(wanted.size() == 0 ||
                (c.cast<double>() - wanted).cwiseAbs().maxCoeff() < kRounding);
    EXPECT_TRUE((storage.bottomRows(3).array() == kUntouched).all());
  }
  float* data() { return storage.data(); }
  int ld() const { return static_cast<int>(storage.rows()); }
  MatrixXf storage;
};

TEST_P(GemmKernelsOfLevel, LayersAddTheirBiasAndCutBelowZero) {
  const GemmKernels& kernels = gemm_kernels(GetParam());
  for (const auto [m, n, k] : kSizes) {
    for (const bool relu : {false, true}) {
      SCOPED_TRACE(testing::Message() << m << "x" << n << "x" << k << " relu " << relu);
      const MatrixXf a = random_matrix(m, k, 1);
      const MatrixXf b = random_matrix(k, n, 2);
      const VectorXf bias = random_matrix(m, 1, 3);
      Eigen::MatrixXd wanted =
          (a.cast<double>() * b.cast<double>()).colwise() + bias.cast<double>().eval();
      if (relu) {
        wanted = wanted.cwiseMax(0.0);
      }
      Guarded c(MatrixXf::Zero(m, n));
      kernels.layer(m, n, k, a.data(), m, b.data(), k, bias.data(), relu, c.data(), c.ld());
      c.expect(wanted);

      // Queries along the rows: the same bits, transposed.
      const MatrixXf at = a.transpose();
      const MatrixXf bt = b.transpose();
      MatrixXf ct(n, m);
      kernels.layer_of_rows(n, m, k, bt.data(), n, at.data(), k, bias.data(), relu, ct.data(), n);
      EXPECT_TRUE(ct.transpose() == c.storage.topRows(m));
    }
  }
}

TEST_P(GemmKernelsOfLevel, ColumnDoesNotDependOnItsNeighbours) {
  const GemmKernels& kernels = gemm_kernels(GetParam());
  const int m = 100;
  const int n = 37;
  const int k = 257;
  const MatrixXf a = random_matrix(m, k, 1);
  const MatrixXf b = random_matrix(k, n, 2);
  const VectorXf bias = random_matrix(m, 1, 3);
  MatrixXf together(m, n);
  kernels.layer(m, n, k, a.data(), m, b.data(), k, bias.data(), true, together.data(), m);
  for (int j = 0; j < n; ++j) {
    VectorXf alone(m);
    kernels.layer(m, 1, k, a.data(), m, b.col(j).data(), k, bias.data(), true, alone.data(), m);
    EXPECT_TRUE(alone == together.col(j)) << "column " << j;
  }
}

TEST_P(GemmKernelsOfLevel, QueryLayerIsALayerWithOneColumn) {
  const GemmKernels& kernels = gemm_kernels(GetParam());
  for (const int m : {16, 48, 112, 144, 272}) {
    for (const int k : {0, 1, 31, 102, 129, 300}) {
      SCOPED_TRACE(testing::Message() << m << "x" << k);
      const MatrixXf a = random_matrix(m, k, 1);
      // Half the inputs are off, as behind a ReLU.
      const VectorXf x = random_matrix(k, 1, 2).cwiseMax(0.0F);
      const VectorXf bias = random_matrix(m, 1, 3);
      VectorXf wanted(m);
      VectorXf y(m);
      kernels.layer(m, 1, k, a.data(), m, x.data(), k, bias.data(), true, wanted.data(), m);
      kernels.query_layer(m, k, a.data(), x.data(), bias.data(), true, y.data());
      EXPECT_TRUE(y == wanted);
    }
  }
}

TEST_P(GemmKernelsOfLevel, NotANumberSurvivesRelu) {
  const float nan = std::nanf("");
  const float one = 1.0F;
  const float zero = 0.0F;
  float c = 0.0F;
  gemm_kernels(GetParam()).layer(1, 1, 1, &nan, 1, &one, 1, &zero, true, &c, 1);
  EXPECT_TRUE(std::isnan(c));
}

TEST_P(GemmKernelsOfLevel, MultiplyAddReachesItsFixedPoint) {
  // x ← 0.999 x + 0.001 tends to 1 in every lane of every chain.
  EXPECT_NEAR(gemm_kernels(GetParam()).multiply_add(20000),
              gemm_kernels(GetParam()).multiply_adds_per_round, 0.2);
}

}  // namespace
}  // namespace limber
