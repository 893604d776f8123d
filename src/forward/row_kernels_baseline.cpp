// RowKernels of CpuLevel::baseline; CMakeLists.txt gives this file its instruction set.
#include "row_kernels_impl.hpp"

namespace limber {

extern const RowKernels kBaselineRowKernels;
constexpr RowKernels kBaselineRowKernels = row_kernels_of_this_level();

}  // namespace limber
