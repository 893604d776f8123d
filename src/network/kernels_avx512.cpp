// GemmKernels of CpuLevel::avx512; CMakeLists.txt gives this file its instruction set.
#include "cpu_kernels.hpp"

namespace limber {

extern const GemmKernels kAvx512Kernels;
constexpr GemmKernels kAvx512Kernels = kernels_of_this_level();

}  // namespace limber
