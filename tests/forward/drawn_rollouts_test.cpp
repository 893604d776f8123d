// Rollouts of arms drawn by a number, in the plane and in space: the kernels beside the model.
#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/forward/forward_model.hpp"
#include "support/drawn_arm.hpp"
#include "support/property.hpp"

namespace limber {
namespace {

constexpr float kFloat = 2e-5F;  // [m], [rad], of quaternions; float32 over an arm of 2 m

TEST(DrawnRollouts, OfAnyArmAreTheNoLoadShapesOfTheirCommands) {
  expect_law("without a network, a frame is its own commands' shape", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm =
        *rc::gen::arbitrary<bool>() ? drawn::arm(number, random) : drawn::space_arm(number, random);
    const int frames = *rc::gen::inRange(2, 40);
    Eigen::MatrixXf kpa(arm.channel_count(), frames);
    for (int k = 0; k < frames; ++k) {
      kpa.col(k) = drawn::pressures(arm, random);
    }
    const NoLoadModel no_load(arm);
    const int size = arm.point_count() * pose_size(arm.dimension);
    Eigen::VectorXf expected(size);
    for (const CpuLevel level : available_cpu_levels()) {
      const ForwardModel model(arm, level);
      ForwardModel::Workspace workspace;
      Eigen::MatrixXf shapes = Eigen::MatrixXf::Zero(size, frames);
      no_load.poses(kpa.col(0), expected);
      shapes.col(0) = expected;
      model.rollout(kpa, shapes, workspace);
      for (int k = 1; k < frames; ++k) {
        no_load.poses(kpa.col(k), expected);
        RC_ASSERT((shapes.col(k) - expected).cwiseAbs().maxCoeff() <= kFloat);
      }
    }
  });
}

}  // namespace
}  // namespace limber
