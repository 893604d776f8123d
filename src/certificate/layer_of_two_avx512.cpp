// The kernel of CpuLevel::avx512; CMakeLists.txt gives this file its instruction set.
#include "layer_of_two_impl.hpp"

namespace limber {

extern const LayerOfTwoKernel kAvx512LayerOfTwo;
constexpr LayerOfTwoKernel kAvx512LayerOfTwo = layer_of_two;

}  // namespace limber
