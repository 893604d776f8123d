#include "limber/forward/ensemble_forward.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/arm/space_pose.hpp"
#include "limber/common/error.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

using Eigen::MatrixXf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr float kRounding = 1e-6F;  // float32, of numbers of the order of 1

/// Networks of one normalisation, each of weights of its own.
CompensationModel ensemble(const ArmDescription& arm, int count) {
  CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {9}, 1);
  for (int k = 1; k < count; ++k) {
    model.more_members.push_back(
        untrained_model(arm, BackboneLayout::gap_poses, {9}, static_cast<std::uint64_t>(k) + 1)
            .layers);
  }
  return model;
}

MatrixXf ramp(int segments, int frames) {
  return MatrixXf::NullaryExpr(segments, frames, [](auto i, auto t) {
    return 2.0F * static_cast<float>(t) * (i % 2 == 0 ? 1.0F : -1.0F);
  });
}

TEST(EnsembleForward, MeanAndSpreadAreThoseOfTheMembersOwnRollouts) {
  const ArmDescription arm = sample_arm(3);
  const CompensationModel model = ensemble(arm, 3);
  const EnsembleForward forward(arm, model);
  ASSERT_EQ(forward.member_count(), 3);
  const MatrixXf pressures = ramp(3, 12);
  const Eigen::VectorXf first = Eigen::VectorXf::Zero(48);
  const EnsembleForward::Prediction prediction = forward.rollout(pressures, first);

  MatrixXf sum = MatrixXf::Zero(48, 12);
  MatrixXf square = MatrixXf::Zero(48, 12);
  for (int k = 0; k < 3; ++k) {
    ForwardModel::Workspace workspace;
    MatrixXf alone = MatrixXf::Zero(48, 12);
    ForwardModel(arm, model.member(k)).rollout(pressures, alone, workspace);
    sum += alone;
    square += alone.cwiseAbs2();
  }
  const MatrixXf mean = sum / 3.0F;
  EXPECT_LT((prediction.mean - mean).cwiseAbs().maxCoeff(), kRounding);
  const MatrixXf variance = square / 3.0F - mean.cwiseAbs2();
  EXPECT_LT((prediction.standard_deviation.cwiseAbs2() - variance).cwiseAbs().maxCoeff(),
            10 * kRounding);
  EXPECT_TRUE(prediction.standard_deviation.col(0).isZero(0.0F));
  EXPECT_GT(prediction.standard_deviation.col(11).maxCoeff(), 1e-3F);
}

// Against the members' own rollouts, and rotations by the mean rotation of two: their half way.
TEST(EnsembleForward, OfAnArmInSpaceMeansPosesOfItsMembers) {
  const ArmDescription arm = testing_support::space_arm();
  const CompensationModel model = ensemble(arm, 2);
  const EnsembleForward forward(arm, model);
  const MatrixXf pressures = ramp(6, 12).cwiseAbs();
  Eigen::VectorXf first(kSpacePoseSize * arm.point_count());
  NoLoadModel(arm).poses(pressures.col(0), first);
  const EnsembleForward::Prediction prediction = forward.rollout(pressures, first);
  MatrixXf members[2];
  for (int k = 0; k < 2; ++k) {
    ForwardModel::Workspace workspace;
    members[k] = MatrixXf::Zero(first.size(), 12);
    members[k].col(0) = first;
    ForwardModel(arm, model.member(k)).rollout(pressures, members[k], workspace);
  }
  for (int plate = 0; plate < arm.point_count(); ++plate) {
    const auto pose = [&](const MatrixXf& of) {
      return space_pose_of(of.col(11).segment<kSpacePoseSize>(kSpacePoseSize * plate));
    };
    const SpacePoseOf<float> mean = pose(prediction.mean);
    const SpacePoseOf<float> a = pose(members[0]);
    const SpacePoseOf<float> b = pose(members[1]);
    EXPECT_LT((mean.position_m - 0.5F * (a.position_m + b.position_m)).norm(), kRounding);
    EXPECT_NEAR(mean.rotation.norm(), 1.0F, kRounding);
    EXPECT_LT(mean.rotation.angularDistance(a.rotation.slerp(0.5F, b.rotation)), 1e-3F);
    const auto spread = prediction.standard_deviation.col(11).segment<3>(kSpacePoseSize * plate);
    EXPECT_NEAR(spread.norm(), 0.5F * (a.position_m - b.position_m).norm(), 10 * kRounding);
  }
  EXPECT_TRUE(prediction.standard_deviation.col(0).isZero(0.0F));
  EXPECT_GT(prediction.standard_deviation.col(11).maxCoeff(), 1e-3F);
}

TEST(EnsembleForward, ASingleNetworkHasNoSpread) {
  const ArmDescription arm = sample_arm(2);
  const EnsembleForward forward(arm, ensemble(arm, 1));
  const auto points = 3 * arm.point_count();
  const auto prediction = forward.rollout(ramp(2, 5), Eigen::VectorXf::Zero(points));
  EXPECT_TRUE(prediction.standard_deviation.isZero(0.0F));
}

// What plans are made with: one network, whatever the file holds besides.
TEST(EnsembleForward, ForwardModelIsTheFirstMember) {
  const ArmDescription arm = sample_arm(3);
  const CompensationModel model = ensemble(arm, 3);
  const Pressures pressures = Pressures::Constant(3, 30.0F);
  const Backbone start = Backbone::Zero(arm.point_count(), 3);
  const Backbone whole = ForwardModel(arm, model).checked_step(pressures, pressures, start);
  EXPECT_EQ(whole, ForwardModel(arm, model.member(0)).checked_step(pressures, pressures, start));
  EXPECT_NE(whole, ForwardModel(arm, model.member(1)).checked_step(pressures, pressures, start));
}

TEST(EnsembleForward, RefusesOtherSizes) {
  const ArmDescription arm = sample_arm(3);
  const EnsembleForward forward(arm, ensemble(arm, 2));
  EXPECT_THAT([&] { (void)forward.rollout(ramp(2, 4), Eigen::VectorXf::Zero(48)); },
              ThrowsMessage<InputError>(HasSubstr("got 2 pressures per frame, 4 frames and a "
                                                  "backbone of 48 numbers; expected 3")));
}

}  // namespace
}  // namespace limber
