// RowKernels of CpuLevel::avx512; CMakeLists.txt gives this file its instruction set.
#include "row_kernels_impl.hpp"

namespace limber {

extern const RowKernels kAvx512RowKernels;
constexpr RowKernels kAvx512RowKernels = row_kernels_of_this_level();

}  // namespace limber
