#pragma once

// The kernel of exact_network.hpp for the instruction set that the including file is compiled for.
// Nothing here may leave the unnamed namespace, or the linker could take one file's code for all.

#include "exact_network.hpp"

namespace limber {
namespace {

using Vector = double __attribute__((vector_size(64), may_alias));

// As many as stay in registers: two sums each.
#if defined(__AVX512F__)
constexpr std::size_t kAtOnce = 4;
#elif defined(__AVX2__)
constexpr std::size_t kAtOnce = 2;
#else
constexpr std::size_t kAtOnce = 1;
#endif

inline const Vector& vector(const Eight& eight) {
  return *reinterpret_cast<const Vector*>(eight.value);
}

inline void store(const Vector& sum, bool with_relu, Eight& result) {
  const Vector zero{};
  *reinterpret_cast<Vector*>(result.value) = with_relu ? (sum > zero ? sum : zero) : sum;
}

template <std::size_t kCount>
void rows(const LayerOfTwo& layer, std::size_t first, const std::size_t* nonzero,
          std::size_t nonzero_count, const double* const (&x)[2], Eight* const (&y)[2]) {
  Vector left[kCount];
  Vector right[kCount];
#pragma GCC unroll 4
  for (std::size_t v = 0; v < kCount; ++v) {
    left[v] = right[v] = vector(layer.bias[first + v]);
  }
  const Eight* weight = layer.weight + first * layer.columns;
  for (std::size_t i = 0; i < nonzero_count; ++i) {
    const std::size_t k = nonzero[i];
    const double x_left = x[0][k];
    const double x_right = x[1][k];
#pragma GCC unroll 4
    for (std::size_t v = 0; v < kCount; ++v) {
      const Vector& w = vector(weight[v * layer.columns + k]);
      left[v] += w * x_left;
      right[v] += w * x_right;
    }
  }
#pragma GCC unroll 4
  for (std::size_t v = 0; v < kCount; ++v) {
    store(left[v], layer.with_relu, y[0][first + v]);
    store(right[v], layer.with_relu, y[1][first + v]);
  }
}

void layer_of_two(const LayerOfTwo& layer, const std::size_t* nonzero, std::size_t nonzero_count,
                  const double* const (&x)[2], Eight* const (&y)[2]) {
  std::size_t first = 0;
  for (; first + kAtOnce <= layer.eights; first += kAtOnce) {
    rows<kAtOnce>(layer, first, nonzero, nonzero_count, x, y);
  }
  for (; first < layer.eights; ++first) {
    rows<1>(layer, first, nonzero, nonzero_count, x, y);
  }
}

constexpr LayerOfTwoKernel kLayerOfTwoKernel = layer_of_two;

}  // namespace
}  // namespace limber
