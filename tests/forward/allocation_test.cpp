#include <gtest/gtest.h>

#include "limber/forward/forward_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/allocation_count.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

TEST(ForwardModel, HotPathAllocatesNothing) {
  if (!kCountsAllocations) {
    GTEST_SKIP() << "the heap belongs to the sanitizer";
  }
  const ArmDescription arm = sample_arm(3);
  for (const BackboneLayout layout : {BackboneLayout::base_poses, BackboneLayout::gap_poses}) {
    const ForwardModel model(
        arm, untrained_model(arm, layout, {100, 100, 100}, 1, OutputForm::gated_change));
    ForwardModel::Workspace workspace;
    const Pressures pressures = Pressures::Constant(3, 20.0F);
    Backbone backbone(arm.point_count(), 3);
    backbone.setZero();
    const Eigen::MatrixXf many_pressures = Eigen::MatrixXf::Constant(3, 200, 20.0F);
    Eigen::MatrixXf many = Eigen::MatrixXf::Zero(backbone.size(), 200);

    const long before_first = allocations;
    model.step(pressures, pressures, backbone, backbone, workspace);
    EXPECT_GT(allocations, before_first) << "the counter does not count";
    const long before = allocations;
    model.step(pressures, pressures, backbone, backbone, workspace);
    model.step_batch(many_pressures, many_pressures, many, many, workspace);
    model.rollout(many_pressures, many, workspace);
    EXPECT_EQ(allocations, before);
  }
}

}  // namespace
}  // namespace limber
