// The kernel of CpuLevel::baseline; CMakeLists.txt gives this file its instruction set.
#include "layer_of_two_impl.hpp"

namespace limber {

extern const LayerOfTwoKernel kBaselineLayerOfTwo;
constexpr LayerOfTwoKernel kBaselineLayerOfTwo = layer_of_two;

}  // namespace limber
