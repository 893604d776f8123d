#include "limber/network/backbone_layout.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr double kRoundTrip = 1e-12;      // [m, rad] in double, over 15 gaps
constexpr float kRoundTripFloat = 2e-6F;  // [m, rad] encoded gaps rounded to float
constexpr float kSameGap = 1e-6F;         // [m, rad] float rounding of one gap

Eigen::MatrixXd random_gaps(int gaps, int columns) {
  RandomStream random(5, 1);
  return Eigen::MatrixXd::NullaryExpr(3 * gaps, columns, [&](Eigen::Index row, Eigen::Index) {
    return row % 3 == 2 ? random.uniform(-0.9, 0.9) : random.uniform(-0.05, 0.05);
  });
}

TEST(GapPoses, ComeBackAfterARoundTrip) {
  const Eigen::MatrixXd gaps = random_gaps(15, 40);
  const Eigen::MatrixXd base = base_poses_of(gaps);
  EXPECT_LT((gap_poses_of(base) - gaps).cwiseAbs().maxCoeff(), kRoundTrip);
  EXPECT_TRUE(base.topRows(3).isZero());
}

TEST(GapPoses, KeepAnglesPastHalfATurnUnwrapped) {
  Eigen::MatrixXd gaps = Eigen::MatrixXd::Zero(45, 1);
  for (int g = 0; g < 15; ++g) {
    gaps(3 * g + 2, 0) = 0.5;
  }
  const Eigen::MatrixXd base = base_poses_of(gaps);
  EXPECT_DOUBLE_EQ(base(47, 0), 7.5);
  EXPECT_DOUBLE_EQ(gap_poses_of(base)(44, 0), 0.5);
}

TEST(GapPoses, DoNotChangeWhenTheArmIsMovedAsAWhole) {
  Eigen::MatrixXd base = base_poses_of(random_gaps(15, 1));
  const Eigen::MatrixXd gaps = gap_poses_of(base);
  const Eigen::Rotation2Dd turn(0.7);
  for (int p = 0; p < 16; ++p) {
    base.block<2, 1>(3 * p, 0) = turn * base.block<2, 1>(3 * p, 0) + Eigen::Vector2d(0.2, -0.1);
    base(3 * p + 2, 0) += 0.7;
  }
  EXPECT_LT((gap_poses_of(base) - gaps).cwiseAbs().maxCoeff(), kRoundTrip);
}

TEST(NetworkLayout, HasThePapersSizesForThePapersArm) {
  const NetworkLayout layout(BackboneLayout::base_poses, OutputForm::compensation, sample_arm(3));
  EXPECT_EQ(layout.input_size(), 102);
  EXPECT_EQ(layout.output_size(), 48);
  EXPECT_EQ(layout.no_load_row(), 54);
}

TEST(NetworkLayout, DropsTheBaseAndRepeatedGapsInGapPoses) {
  const NetworkLayout layout(BackboneLayout::gap_poses, OutputForm::compensation, sample_arm(3));
  EXPECT_EQ(layout.input_size(), 6 + 45 + 9);
  EXPECT_EQ(layout.output_size(), 45);
}

TEST(NetworkLayout, GatesDoubleTheOutputsAndNothingElse) {
  const NetworkLayout layout(BackboneLayout::gap_poses, OutputForm::gated_change, sample_arm(3));
  EXPECT_EQ(layout.input_size(), 60);
  EXPECT_EQ(layout.backbone_size(), 45);
  EXPECT_EQ(layout.output_size(), 90);
}

TEST(NetworkLayout, DecodesWhatItEncoded) {
  const Eigen::MatrixXf base = base_poses_of(random_gaps(15, 7)).cast<float>();
  for (const BackboneLayout kind : {BackboneLayout::base_poses, BackboneLayout::gap_poses}) {
    const NetworkLayout layout(kind, OutputForm::compensation, sample_arm(3));
    const Eigen::MatrixXf encoded = layout.encode(base);
    EXPECT_EQ(encoded.rows(), layout.backbone_size());
    EXPECT_LT((layout.decode(encoded) - base).cwiseAbs().maxCoeff(), kRoundTripFloat);
  }
}

// One gap stands for all of its segment, because an unloaded segment is an arc.
TEST(NetworkLayout, EveryGapOfAnUnloadedSegmentIsTheOneInTheInput) {
  const ArmDescription arm = sample_arm(5);
  const NetworkLayout layout(BackboneLayout::gap_poses, OutputForm::compensation, arm);
  Backbone backbone(arm.point_count(), 3);
  NoLoadModel(arm).backbone(Eigen::VectorXf(Eigen::VectorXf::LinSpaced(5, -90.0F, 80.0F)),
                            backbone);
  const Eigen::MatrixXf gaps =
      layout.encode(Eigen::Map<const Eigen::VectorXf>(backbone.data(), backbone.size()));
  const Eigen::MatrixXf input = layout.no_load_input(gaps);
  ASSERT_EQ(input.rows(), 15);
  for (int g = 0; g + 1 < arm.point_count(); ++g) {
    const int segment = arm.segment_of_gap(g);
    EXPECT_LT((gaps.middleRows(3 * g, 3) - input.middleRows(3 * segment, 3)).cwiseAbs().maxCoeff(),
              kSameGap)
        << "gap " << g;
  }
}

}  // namespace
}  // namespace limber
