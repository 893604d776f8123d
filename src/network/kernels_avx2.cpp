// GemmKernels at level avx2; src/network/CMakeLists.txt gives this file its instruction set.
#include "cpu_kernels.hpp"

namespace limber {

extern const GemmKernels kGemmKernels_avx2;
constexpr GemmKernels kGemmKernels_avx2 = kernels_of_this_level("avx2");

}  // namespace limber
