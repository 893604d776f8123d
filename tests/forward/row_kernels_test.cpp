#include "forward/row_kernels.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Core>

namespace limber {
namespace {

constexpr double kSineTolerance = 2e-7;  // promised by common/vector_sincos.hpp, |angle| ≤ 100 rad

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

}  // namespace
}  // namespace limber
