// GemmKernels of CpuLevel::baseline; CMakeLists.txt gives this file its instruction set.
#include "cpu_kernels.hpp"

namespace limber {

extern const GemmKernels kBaselineKernels;
constexpr GemmKernels kBaselineKernels = kernels_of_this_level();

}  // namespace limber
