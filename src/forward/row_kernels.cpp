#include "row_kernels.hpp"

#include <cassert>

namespace limber {

extern const RowKernels kBaselineRowKernels;
#if defined(__x86_64__)
extern const RowKernels kAvx2RowKernels;
extern const RowKernels kAvx512RowKernels;
#endif

const RowKernels& row_kernels(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512RowKernels;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2RowKernels;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineRowKernels;
}

}  // namespace limber
