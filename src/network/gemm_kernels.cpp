#include "limber/network/gemm_kernels.hpp"

#include <cassert>

namespace limber {

extern const GemmKernels kBaselineKernels;
#if defined(__x86_64__)
extern const GemmKernels kAvx2Kernels;
extern const GemmKernels kAvx512Kernels;
#endif

const GemmKernels& gemm_kernels(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512Kernels;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2Kernels;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineKernels;
}

}  // namespace limber
