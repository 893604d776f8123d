#include "src/training/batch_gradient.hpp"

#include <gtest/gtest.h>

#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr float kRounding = 1e-5F;  // relative, of float32 sums in another order

class BatchGradientTest : public testing::Test {
 protected:
  BatchGradientTest()
      : tables_(make_training_tables(arm_, {toy_episode(arm_, 60, 20, 3)}, best_preset())),
        layout_({105, 20, 90}),
        parameters_(initial_parameters(layout_, 5)),
        starts_(window_starts(tables_.episodes, {}, 4, 0)) {}

  Eigen::VectorXf gradient(int jobs, double* loss = nullptr) const {
    BatchGradient batch(tables_, layout_, 4, static_cast<int>(starts_.size()), jobs);
    Eigen::VectorXf result;
    const double sum = batch.compute(starts_, parameters_, result).front();
    if (loss != nullptr) {
      *loss = sum;
    }
    return result;
  }

  const ArmDescription arm_ = three_segment_arm();
  const TrainingTables tables_;
  const ParameterLayout layout_;
  const Eigen::VectorXf parameters_;
  const std::vector<int> starts_;
};

TEST_F(BatchGradientTest, HasTheSameBitsForAnyNumberOfThreads) {
  const Eigen::VectorXf one = gradient(1);
  EXPECT_EQ(one, gradient(2));
  EXPECT_EQ(one, gradient(5));
}

TEST_F(BatchGradientTest, IsTheSumOverTheWindows) {
  double loss = 0.0;
  const Eigen::VectorXf all = gradient(2, &loss);
  WindowGradient<float> whole(layout_, tables_.map, 3, 4, static_cast<int>(starts_.size()));
  whole.load(tables_.frames, starts_);
  EXPECT_NEAR(whole.forward(parameters_.data()), loss, kRounding * loss);
  Eigen::VectorXf expected(layout_.size());
  whole.backward(parameters_.data(), expected.data());
  EXPECT_LT((all - expected).norm(), kRounding * expected.norm());
}

}  // namespace
}  // namespace limber
