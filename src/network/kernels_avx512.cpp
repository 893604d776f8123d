// GemmKernels at level avx512; src/network/CMakeLists.txt gives this file its instruction set.
#include "cpu_kernels.hpp"

namespace limber {

extern const GemmKernels kGemmKernels_avx512;
constexpr GemmKernels kGemmKernels_avx512 = kernels_of_this_level("avx512");

}  // namespace limber
