// The kernel of CpuLevel::avx2; CMakeLists.txt gives this file its instruction set.
#include "layer_of_two_impl.hpp"

namespace limber {

extern const LayerOfTwoKernel kAvx2LayerOfTwo;
constexpr LayerOfTwoKernel kAvx2LayerOfTwo = layer_of_two;

}  // namespace limber
