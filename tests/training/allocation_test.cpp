#include <gtest/gtest.h>

#include "limber/training/window_gradient.hpp"
#include "src/training/training_kernels.hpp"
#include "src/training/training_tables.hpp"
#include "support/allocation_count.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

// What runs for every window of every batch; TBB's own task objects are not ours to count.
TEST(WindowGradient, AllocatesNothingOnceItStands) {
  if (!kCountsAllocations) {
    GTEST_SKIP() << "the heap belongs to the sanitizer";
  }
  const ArmDescription arm = three_segment_arm();
  for (const OutputForm form : {OutputForm::compensation, OutputForm::gated_change}) {
    TrainingSettings settings;
    settings.form = form;
    const TrainingTables tables = make_training_tables(arm, {toy_episode(arm, 9, 20, 3)}, settings);
    const ParameterLayout layout(
        {static_cast<int>(tables.input.scale.size()), 20, 30, tables.map.output_count()});
    const Eigen::VectorXf parameters = initial_parameters(layout, 5);
    const std::vector<int> starts = window_starts(tables.episodes, {}, 4, 0);
    Eigen::VectorXf gradient(layout.size());
    const long before_construction = allocations;
    WindowGradient<float> window(layout, tables.map, 3, 4, static_cast<int>(starts.size()));
    EXPECT_GT(allocations, before_construction) << "the counter does not count";
    const long before = allocations;
    window.load(tables.frames, starts);
    window.forward(parameters.data());
    window.backward(parameters.data(), gradient.data());
    EXPECT_EQ(allocations, before);
  }
}

}  // namespace
}  // namespace limber
