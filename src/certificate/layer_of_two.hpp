#pragma once

#include <cstddef>

namespace limber {

enum class CpuLevel;

/// Eight rows of a column, which are computed together.
struct alignas(64) Eight {
  double value[8] = {};
};

/// One layer of a network for two inputs at once, so that its weights are read once. A row's sum
/// starts with its bias and grows in the order of the columns, without fused multiply-adds: the
/// result is the same to the bit on every CPU.
struct LayerOfTwo {
  const Eight* weight;  ///< all columns of the first eight rows, then those of the next eight, …
  const Eight* bias;    ///< one value per row
  std::size_t eights;   ///< rows, in eights
  std::size_t columns;
  bool with_relu;
};

/// @param nonzero  the columns where either input is not 0; the others add nothing
/// @param x        the two inputs
/// @param y        the two results, `eights` each, overwritten
using LayerOfTwoKernel = void (*)(const LayerOfTwo& layer, const std::size_t* nonzero,
                                  std::size_t nonzero_count, const double* const (&x)[2],
                                  Eight* const (&y)[2]);

LayerOfTwoKernel layer_of_two_kernel(CpuLevel level);

}  // namespace limber
