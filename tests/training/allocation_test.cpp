// Counts what a batch takes from the heap: malloc is replaced for this program. Sanitizers replace
// it themselves, so there the count is not taken.
#include <atomic>
#include <cstdlib>

#include <gtest/gtest.h>

#include "limber/training/training_tables.hpp"
#include "limber/training/window_gradient.hpp"
#include "training/toy_arm.hpp"
#include "training/training_kernels.hpp"

namespace {
std::atomic<long> allocations{0};
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool kCounting = true;
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
#else
constexpr bool kCounting = false;
#endif

namespace limber {
namespace {

// What runs for every window of every batch; TBB's own task objects are not ours to count.
TEST(WindowGradient, AllocatesNothingOnceItStands) {
  if (!kCounting) {
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
    const Eigen::MatrixXf noise =
        Eigen::MatrixXf::Zero(tables.frames.state.rows(), static_cast<Eigen::Index>(starts.size()));
    const long before = allocations;
    window.load(tables.frames, starts);
    window.disturb(noise);
    window.forward(parameters.data());
    window.backward(parameters.data(), gradient.data());
    EXPECT_EQ(allocations, before);
  }
}

}  // namespace
}  // namespace limber
