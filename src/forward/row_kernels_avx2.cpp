// RowKernels of CpuLevel::avx2; CMakeLists.txt gives this file its instruction set.
#include "row_kernels_impl.hpp"

namespace limber {

extern const RowKernels kAvx2RowKernels;
constexpr RowKernels kAvx2RowKernels = row_kernels_of_this_level();

}  // namespace limber
