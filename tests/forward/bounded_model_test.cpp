// (20): whatever a network says, predictions keep the shape of an arm.

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"
#include "limber/forward/ensemble_forward.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr int kFrames = 2000;
constexpr float kRounding = 2e-6F;  // float32 poses about the base of a 0.7 m arm [m, rad]

/// Every gap's two positions creep by 0.2 mm a frame, and its turn by 5 mrad, without end.
CompensationModel creeping_model(const ArmDescription& arm, BackboneLayout layout) {
  CompensationModel model = untrained_model(arm, layout, {8}, 1, OutputForm::gated_change);
  for (Layer& layer : model.layers) {
    layer.weight.setZero();
    layer.bias.setZero();
  }
  const Eigen::Index size = model.output.scale.size();
  model.output.scale.setOnes();
  Eigen::VectorXf& bias = model.layers.back().bias;
  for (Eigen::Index i = 0; i < size; ++i) {
    bias[i] = i % 3 == 2 ? 0.005F : 2e-4F;
    bias[size + i] = -30.0F;  // the gate is shut: nothing pulls back
  }
  return model;
}

GapBounds bounds_of(const ArmDescription& arm) {
  const int gaps = arm.point_count() - 1;
  return {Eigen::VectorXf::Constant(gaps, 0.04F), Eigen::VectorXf::Constant(gaps, 0.051F),
          Eigen::VectorXf::Constant(gaps, -0.6F), Eigen::VectorXf::Constant(gaps, 0.4F)};
}

void expect_within(const GapBounds& bounds, const Eigen::Ref<const Eigen::VectorXf>& backbone) {
  for (Eigen::Index g = 0; g < bounds.min_length_m.size(); ++g) {
    const Eigen::Vector3f step = backbone.segment<3>(3 * (g + 1)) - backbone.segment<3>(3 * g);
    ASSERT_GE(step.head<2>().norm(), bounds.min_length_m[g] - kRounding) << g;
    ASSERT_LE(step.head<2>().norm(), bounds.max_length_m[g] + kRounding) << g;
    ASSERT_GE(step[2], bounds.min_turn_rad[g] - 10 * kRounding) << g;
    ASSERT_LE(step[2], bounds.max_turn_rad[g] + 10 * kRounding) << g;
  }
}

Eigen::MatrixXf random_pressures(const ArmDescription& arm, int frames) {
  RandomStream random(4, 0);
  return Eigen::MatrixXf::NullaryExpr(arm.segment_count(), frames, [&] {
    return static_cast<float>(random.uniform(-100.0, 100.0));
  });
}

Eigen::VectorXf rest(const ArmDescription& arm) {
  Backbone straight(arm.point_count(), 3);
  NoLoadModel(arm).backbone(Pressures(Pressures::Zero(arm.segment_count())), straight);
  return straight.reshaped<Eigen::RowMajor>();
}

class CreepingModel : public testing::TestWithParam<BackboneLayout> {};

INSTANTIATE_TEST_SUITE_P(BothLayouts, CreepingModel,
                         testing::Values(BackboneLayout::base_poses, BackboneLayout::gap_poses));

TEST_P(CreepingModel, RunsAwayWithoutBoundsAndNeverWithThem) {
  const ArmDescription arm = sample_arm(3);
  const Eigen::MatrixXf pressures = random_pressures(arm, kFrames);
  CompensationModel creeping = creeping_model(arm, GetParam());
  ForwardModel::Workspace workspace;
  Eigen::MatrixXf free(3 * arm.point_count(), kFrames);
  free.col(0) = rest(arm);
  ForwardModel(arm, creeping).rollout(pressures, free, workspace);
  EXPECT_GT(free.rightCols(1).cwiseAbs().maxCoeff(), 1.0F);

  creeping.bounds = bounds_of(arm);
  for (const CpuLevel level : available_cpu_levels()) {
    Eigen::MatrixXf held = free;
    ForwardModel(arm, creeping, level).rollout(pressures, held, workspace);
    for (int t = 1; t < kFrames; ++t) {
      expect_within(*creeping.bounds, held.col(t));
      ASSERT_FALSE(HasFatalFailure()) << to_string(level) << ", frame " << t;
    }
  }
}

TEST_P(CreepingModel, IsHeldInBatchesAndEnsemblesToo) {
  const ArmDescription arm = sample_arm(3);
  CompensationModel creeping = creeping_model(arm, GetParam());
  creeping.bounds = bounds_of(arm);
  creeping.more_members = {creeping.layers};
  const ForwardModel forward(arm, creeping);
  const MotionModel model(forward, ValveModel(arm, {}));
  RolloutBatch batch(model);
  const Eigen::VectorXf start = rest(arm);
  const MotionState at_rest =
      model.settled_state(Pressures::Zero(arm.segment_count()),
                          Eigen::Map<const Backbone>(start.data(), arm.point_count(), 3));
  const Eigen::MatrixXf to = random_pressures(arm, 40);
  for (int k = 0; k < 40; ++k) {
    batch.add(k, at_rest, to.col(k), 300);
  }
  for (int t = 0; t < 300; ++t) {
    batch.step();
  }
  for (int k = 0; k < 40; ++k) {
    const Backbone now = batch.now(k);
    expect_within(*creeping.bounds, now.reshaped<Eigen::RowMajor>());
  }
  const EnsembleForward ensemble(arm, creeping);
  const EnsembleForward::Prediction predicted = ensemble.rollout(random_pressures(arm, 300), start);
  expect_within(*creeping.bounds, predicted.mean.rightCols(1));
}

TEST_P(CreepingModel, NumbersWithoutEndAreHeldToo) {
  const ArmDescription arm = sample_arm(3);
  CompensationModel wild = creeping_model(arm, GetParam());
  wild.bounds = bounds_of(arm);
  wild.layers.back().bias.head(wild.output.scale.size()).setConstant(3e38F);
  const Eigen::VectorXf start = rest(arm);
  for (const int count : {1, 40}) {
    const Eigen::MatrixXf kpa = Eigen::MatrixXf::Zero(3, count);
    Eigen::MatrixXf next = start.replicate(1, count);
    ForwardModel::Workspace workspace;
    ForwardModel(arm, wild).step_batch(kpa, kpa, next, next, workspace);
    ASSERT_TRUE(next.allFinite());
  }
}

// What bounds leave alone keeps its bits, so that a model given bounds predicts as before.
TEST(BoundedModel, WideBoundsChangeNothing) {
  const ArmDescription arm = sample_arm(3);
  CompensationModel model =
      untrained_model(arm, BackboneLayout::gap_poses, {30}, 2, OutputForm::gated_change);
  const int gaps = arm.point_count() - 1;
  CompensationModel bounded = model;
  bounded.bounds = {Eigen::VectorXf::Constant(gaps, 1e-5F), Eigen::VectorXf::Constant(gaps, 10.0F),
                    Eigen::VectorXf::Constant(gaps, -9.0F), Eigen::VectorXf::Constant(gaps, 9.0F)};
  const Eigen::MatrixXf pressures = random_pressures(arm, 50);
  ForwardModel::Workspace workspace;
  Eigen::MatrixXf as_before(3 * arm.point_count(), 50);
  as_before.col(0) = rest(arm);
  Eigen::MatrixXf now = as_before;
  ForwardModel(arm, model).rollout(pressures, as_before, workspace);
  ForwardModel(arm, bounded).rollout(pressures, now, workspace);
  EXPECT_EQ(now, as_before);
}

}  // namespace
}  // namespace limber
