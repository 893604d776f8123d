#include "training_kernels.hpp"

#include <cassert>

namespace limber {

extern const WindowKernels<float> kBaselineWindowKernels;
extern const OptimiserKernels kBaselineOptimiserKernels;
#if defined(__x86_64__)
extern const WindowKernels<float> kAvx2WindowKernels;
extern const OptimiserKernels kAvx2OptimiserKernels;
extern const WindowKernels<float> kAvx512WindowKernels;
extern const OptimiserKernels kAvx512OptimiserKernels;
#endif

template <>
const WindowKernels<float>& window_kernels(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512WindowKernels;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2WindowKernels;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineWindowKernels;
}

const OptimiserKernels& optimiser_kernels(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512OptimiserKernels;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2OptimiserKernels;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineOptimiserKernels;
}

}  // namespace limber
