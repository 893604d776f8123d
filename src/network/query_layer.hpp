#pragma once

// One layer for one query, compiled per CPU level. All outputs of up to 128 rows stay in registers
// while the inputs that are not 0 are walked through; the weights stream by once.

#include <cstddef>

#include "common/vector_float.hpp"

namespace limber {
namespace {

constexpr int kQueryBlock = 128;  // inputs listed at a time
constexpr int kQueryVectors = 8;  // vectors of outputs in registers at a time

// Positions and values of the numbers other than 0 among x[0 … count), in order.
struct NonZeros {
  int count;
  int index[kQueryBlock + kLanes];
  float value[kQueryBlock + kLanes];
};

inline void list_non_zeros(const float* x, int count, NonZeros& list) {
  list.count = 0;
#if defined(__AVX512F__)
  const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  for (int i = 0; i < count; i += kLanes) {
    const Vector v = load_part(x + i, count - i < kLanes ? count - i : kLanes);
    const __mmask16 keep = _mm512_cmp_ps_mask(v, Vector{}, _CMP_NEQ_UQ);
    const __m512i position = _mm512_add_epi32(lane, _mm512_set1_epi32(i));
    _mm512_storeu_si512(list.index + list.count, _mm512_maskz_compress_epi32(keep, position));
    store(list.value + list.count, _mm512_maskz_compress_ps(keep, v));
    list.count += __builtin_popcount(keep);
  }
#else
  for (int i = 0; i < count; ++i) {
    list.index[list.count] = i;
    list.value[list.count] = x[i];
    list.count += x[i] != 0.0F ? 1 : 0;
  }
#endif
}

template <int kVectors>
void query_rows(int k, const float* a, std::ptrdiff_t lda, const float* x, const float* bias,
                bool with_relu, float* y) {
  Vector sum[kVectors];
#pragma GCC unroll 8
  for (int v = 0; v < kVectors; ++v) {
    sum[v] = load(bias + v * kLanes);
  }
  NonZeros list;
  for (int from = 0; from < k; from += kQueryBlock) {
    list_non_zeros(x + from, k - from < kQueryBlock ? k - from : kQueryBlock, list);
    for (int s = 0; s < list.count; ++s) {
      const float* column = a + (from + list.index[s]) * lda;
      const Vector value = broadcast(list.value[s]);
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

void query_layer(int m, int k, const float* a, const float* x, const float* bias, bool with_relu,
                 float* y) {
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
