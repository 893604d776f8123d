#pragma once

// One layer for one query, compiled per CPU level. All outputs of up to 128 rows stay in registers
// while the inputs that are not 0 are walked through; the weights stream by once.

#include <cstddef>

#include "kernels/vector_float.hpp"

namespace limber {
namespace {

constexpr int kQueryVectors = 8;  // vectors of outputs in registers at a time
constexpr int kMaskBits = 64;     // inputs looked at together

// Bit i says whether x[i] is other than 0, i < count ≤ 64.
inline unsigned long long non_zeros(const float* x, int count) {
  unsigned long long mask = 0;
  for (int i = 0; i < count; i += kLanes) {
    const Vector v = load_part(x + i, count - i < kLanes ? count - i : kLanes);
    mask |= static_cast<unsigned long long>(non_zero_lanes(v)) << i;
  }
  return mask;
}

template <int kVectors>
void query_rows(int k, const float* a, std::ptrdiff_t lda, const float* x, const float* bias,
                bool with_relu, float* y) {
  Vector sum[kVectors];
#pragma GCC unroll 8
  for (int v = 0; v < kVectors; ++v) {
    sum[v] = load(bias + v * kLanes);
  }
  for (int from = 0; from < k; from += kMaskBits) {
    const int count = k - from < kMaskBits ? k - from : kMaskBits;
    for (unsigned long long mask = non_zeros(x + from, count); mask != 0; mask &= mask - 1) {
      const int i = from + __builtin_ctzll(mask);
      const float* column = a + i * lda;
      const Vector value = broadcast(x[i]);
#pragma GCC unroll 8
      for (int v = 0; v < kVectors; ++v) {
        sum[v] = multiply_add(load(column + v * kLanes), value, sum[v]);
      }
    }
  }
#pragma GCC unroll 8
  for (int v = 0; v < kVectors; ++v) {
    store(y + v * kLanes, with_relu ? relu(sum[v]) : sum[v]);
  }
}

inline void query_layer(int m, int k, const float* a, const float* x, const float* bias,
                        bool with_relu, float* y) {
  constexpr void (*kRows[])(int, const float*, std::ptrdiff_t, const float*, const float*, bool,
                            float*) = {query_rows<1>, query_rows<2>, query_rows<3>, query_rows<4>,
                                       query_rows<5>, query_rows<6>, query_rows<7>, query_rows<8>};
  int left = m / kLanes;
  for (int i = 0; left > 0;) {
    const int vectors = left < kQueryVectors ? left : kQueryVectors;
    kRows[vectors - 1](k, a + i, m, x, bias + i, with_relu, y + i);
    i += vectors * kLanes;
    left -= vectors;
  }
}

}  // namespace
}  // namespace limber
