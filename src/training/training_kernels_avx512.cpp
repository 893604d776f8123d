// WindowKernels and OptimiserKernels of CpuLevel::avx512; CMakeLists.txt gives this file its
// instruction set.
#include "training_kernels_impl.hpp"

namespace limber {

extern const WindowKernels<float> kAvx512WindowKernels;
constexpr WindowKernels<float> kAvx512WindowKernels = window_kernels_of_this_level();
extern const OptimiserKernels kAvx512OptimiserKernels;
constexpr OptimiserKernels kAvx512OptimiserKernels = optimiser_kernels_of_this_level();

}  // namespace limber
