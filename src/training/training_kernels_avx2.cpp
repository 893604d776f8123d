// WindowKernels and OptimiserKernels of CpuLevel::avx2; CMakeLists.txt gives this file its
// instruction set.
#include "training_kernels_impl.hpp"

namespace limber {

extern const WindowKernels<float> kAvx2WindowKernels;
constexpr WindowKernels<float> kAvx2WindowKernels = window_kernels_of_this_level();
extern const OptimiserKernels kAvx2OptimiserKernels;
constexpr OptimiserKernels kAvx2OptimiserKernels = optimiser_kernels_of_this_level();

}  // namespace limber
