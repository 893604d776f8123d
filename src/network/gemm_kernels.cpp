#include "limber/network/gemm_kernels.hpp"

#include <cassert>

namespace limber {

extern const GemmKernels kBaselineGemmKernels;
#if defined(__x86_64__)
extern const GemmKernels kAvx2GemmKernels;
extern const GemmKernels kAvx512GemmKernels;
#endif

const GemmKernels& gemm_kernels(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512GemmKernels;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2GemmKernels;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineGemmKernels;
}

}  // namespace limber
