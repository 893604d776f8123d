#include "limber/forward/rollout_batch.hpp"

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

TEST(ParallelForward, AnswersDoNotDependOnTheNumberOfThreads) {
  constexpr int kQueries = 6 * 512 + 1;  // one more than parts are full: it must not be left out
  const ArmDescription arm = sample_arm(3);
  const ForwardModel model(arm, untrained_model(arm, BackboneLayout::gap_poses, {40, 40}, 1));
  RandomStream random(1, 0);
  const auto pressure = [&] { return static_cast<float>(random.uniform(-100.0, 100.0)); };
  const Eigen::MatrixXf before = Eigen::MatrixXf::NullaryExpr(3, kQueries, pressure);
  const Eigen::MatrixXf now = Eigen::MatrixXf::NullaryExpr(3, kQueries, pressure);
  const Eigen::MatrixXf previous = Eigen::MatrixXf::Zero(48, kQueries);
  Eigen::MatrixXf wanted(48, kQueries);
  ForwardModel::Workspace workspace;
  model.step_batch(before, now, previous, wanted, workspace);
  for (const int jobs : {1, 2, 3}) {
    ParallelForward parallel(jobs);
    EXPECT_EQ(parallel.jobs(), jobs);
    Eigen::MatrixXf answers = Eigen::MatrixXf::Zero(48, kQueries);
    parallel.step_batch(model, before, now, previous, answers);
    EXPECT_TRUE(answers == wanted) << jobs << " jobs";
  }
}

}  // namespace
}  // namespace limber
