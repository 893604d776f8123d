#include "src/forward/row_kernels.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limber/arm/pose_size.hpp"

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
  row_kernels(GetParam()).in_plane.encode(1, base.data(), gap.data(), kCount);
  for (int i = 0; i < kCount; ++i) {
    const float angle = base(2, i);
    ASSERT_NEAR(gap(0, i), std::cos(double(angle)), kSineTolerance) << angle;
    ASSERT_NEAR(gap(1, i), -std::sin(double(angle)), kSineTolerance) << angle;
  }
}

// One query's numbers side by side come out as those of a row do, to the bit: for fewer gaps than a
// vector has lanes, and for more.
void expect_one_as_rows(const GapKernels& kernels, int lanes) {
  for (const int gaps : {1, 3, 15, 16, 17, 40}) {
    std::srand(static_cast<unsigned>(gaps));
    const int pose = kernels.pose_size;
    Eigen::VectorXf column = 3.0F * Eigen::VectorXf::Random(pose * (gaps + 1));
    for (int plate = 0; pose == kSpacePoseSize && plate <= gaps; ++plate) {
      column.segment<4>(pose * plate + 3).normalize();
    }
    const Rows base = column.replicate(1, lanes);
    Rows gap(kernels.gap_size * gaps, lanes);
    kernels.encode(gaps, base.data(), gap.data(), lanes);
    Eigen::VectorXf gap_of_one(kernels.gap_size * gaps);
    kernels.encode_one(gaps, column.data(), gap_of_one.data());
    EXPECT_EQ(gap_of_one, gap.col(0)) << gaps << " gaps";
    Rows back(pose * (gaps + 1), lanes);
    kernels.decode(gaps, gap.data(), back.data(), lanes);
    Eigen::VectorXf back_of_one(pose * (gaps + 1));
    kernels.decode_one(gaps, gap_of_one.data(), back_of_one.data());
    EXPECT_EQ(back_of_one, back.col(0)) << gaps << " gaps";
  }
}

TEST_P(RowKernelsOfLevel, GapsOfOneQueryAreThoseOfTheRows) {
  const RowKernels& kernels = row_kernels(GetParam());
  expect_one_as_rows(kernels.in_plane, kernels.lanes);
  expect_one_as_rows(kernels.in_space, kernels.lanes);
}

// Chained by Eigen's own quaternions, in double.
TEST_P(RowKernelsOfLevel, GapsInSpaceAgreeWithTheStandardLibrary) {
  constexpr int kGaps = 6;
  const RowKernels& kernels = row_kernels(GetParam());
  for (const float size : {0.0F, 1e-4F, 0.3F, 1.7F}) {  // of each number of ω: up to 2.9 rad in all
    std::srand(7);
    Rows gap = size * Rows::Random(kSpaceGapSize * kGaps, kernels.lanes);
    Rows base(kSpacePoseSize * (kGaps + 1), kernels.lanes);
    kernels.in_space.decode(kGaps, gap.data(), base.data(), kernels.lanes);
    for (int q = 0; q < kernels.lanes; ++q) {
      Eigen::Vector3d position = Eigen::Vector3d::Zero();
      Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
      for (int g = 0; g < kGaps; ++g) {
        const Eigen::VectorXd numbers =
            gap.col(q).segment<kSpaceGapSize>(kSpaceGapSize * g).cast<double>();
        position += rotation * numbers.head<3>();
        const Eigen::Vector3d omega = numbers.tail<3>();
        rotation =
            rotation * Eigen::AngleAxisd(omega.norm(), omega.norm() > 0.0
                                                           ? Eigen::Vector3d(omega.normalized())
                                                           : Eigen::Vector3d::UnitX());
        const Eigen::VectorXd found =
            base.col(q).segment<kSpacePoseSize>(kSpacePoseSize * (g + 1)).cast<double>();
        EXPECT_LT((found.head<3>() - position).norm(), 1e-5);
        EXPECT_LT(
            rotation.angularDistance(Eigen::Quaterniond(found[6], found[3], found[4], found[5])),
            2e-3);  // acos near 1 in float
      }
    }
    Rows again(kSpaceGapSize * kGaps, kernels.lanes);
    kernels.in_space.encode(kGaps, base.data(), again.data(), kernels.lanes);
    EXPECT_LT((again - gap).cwiseAbs().maxCoeff(), 5e-6F) << size;
  }
}

}  // namespace
}  // namespace limber
