// WindowKernels and OptimiserKernels of CpuLevel::baseline; CMakeLists.txt gives this file its
// instruction set.
#include "training_kernels_impl.hpp"

namespace limber {

extern const WindowKernels<float> kBaselineWindowKernels;
constexpr WindowKernels<float> kBaselineWindowKernels = window_kernels_of_this_level();
extern const OptimiserKernels kBaselineOptimiserKernels;
constexpr OptimiserKernels kBaselineOptimiserKernels = optimiser_kernels_of_this_level();

}  // namespace limber
