// GemmKernels at level baseline; src/network/CMakeLists.txt gives this file its instruction set.
#include "cpu_kernels.hpp"

namespace limber {

extern const GemmKernels kGemmKernels_baseline;
constexpr GemmKernels kGemmKernels_baseline = kernels_of_this_level("baseline");

}  // namespace limber
