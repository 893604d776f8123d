#include "src/forward/row_kernels.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Core>

namespace limber {
namespace {

constexpr double kSineTolerance = 2e-7;  // promised by kernels/vector_sincos.hpp, |angle| ≤ 100 rad

using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class RowKernelsOfLevel : public ::testing::TestWithParam<CpuLevel> {};

INSTANTIATE_TEST_SUITE_P(Levels, RowKernelsOfLevel, ::testing::ValuesIn(available_cpu_levels()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

// A plate one metre along the base's x, seen from a plate turned by each angle: (cos, −sin).
TEST_P(RowKernelsOfLevel, SineAndCosineAgreeWithTheStandardLibrary) {
  constexpr int kCount = 20000;  // a multiple of the lanes of every level
  Rows base = Rows::Zero(6, kCount);
  base.row(2).setLinSpaced(-100.0F, 100.0F);
  base(2, 7) = 0.0F;
  base.row(3).setOnes();
  Rows gap(3, kCount);
  row_kernels(GetParam()).encode_gaps(1, base.data(), gap.data(), kCount);
  for (int i = 0; i < kCount; ++i) {
    const float angle = base(2, i);
    ASSERT_NEAR(gap(0, i), std::cos(double(angle)), kSineTolerance) << angle;
    ASSERT_NEAR(gap(1, i), -std::sin(double(angle)), kSineTolerance) << angle;
  }
}

// One query's numbers side by side come out as those of a row do, to the bit: for fewer gaps than a
// vector has lanes, and for more.
TEST_P(RowKernelsOfLevel, GapsOfOneQueryAreThoseOfTheRows) {
  const RowKernels& kernels = row_kernels(GetParam());
  for (const int gaps : {1, 3, 15, 16, 17, 40}) {
    std::srand(static_cast<unsigned>(gaps));
    const Eigen::VectorXf column = 3.0F * Eigen::VectorXf::Random(3 * (gaps + 1));
    const Rows base = column.replicate(1, kernels.lanes);
    Rows gap(3 * gaps, kernels.lanes);
    kernels.encode_gaps(gaps, base.data(), gap.data(), kernels.lanes);
    Eigen::VectorXf gap_of_one(3 * gaps);
    kernels.encode_gaps_of_one(gaps, column.data(), gap_of_one.data());
    EXPECT_EQ(gap_of_one, gap.col(0)) << gaps << " gaps";
    Rows back(3 * (gaps + 1), kernels.lanes);
    kernels.decode_gaps(gaps, gap.data(), back.data(), kernels.lanes);
    Eigen::VectorXf back_of_one(3 * (gaps + 1));
    kernels.decode_gaps_of_one(gaps, gap_of_one.data(), back_of_one.data());
    EXPECT_EQ(back_of_one, back.col(0)) << gaps << " gaps";
  }
}

}  // namespace
}  // namespace limber
