// GemmKernels of CpuLevel::avx2; CMakeLists.txt gives this file its instruction set.
#include "cpu_kernels.hpp"

namespace limber {

extern const GemmKernels kAvx2Kernels;
constexpr GemmKernels kAvx2Kernels = kernels_of_this_level();

}  // namespace limber
