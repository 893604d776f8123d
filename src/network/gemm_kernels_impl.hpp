#pragma once

// The kernels of GemmKernels for the instruction set that the including file is compiled for; see
// vector_float.hpp for why nothing here may leave the unnamed namespace.

#include <cstddef>

#include "kernels/gemm_tiles.hpp"
#include "kernels/vector_float.hpp"
#include "limber/network/gemm_kernels.hpp"

namespace limber {

// One layer for one query, compiled per CPU level. All outputs of up to 128 rows stay in registers
// while the inputs that are not 0 are walked through; the weights stream by once.

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
    const float* rows = k > 0 ? a + i : nullptr;  // else there may be no A
    kRows[vectors - 1](k, rows, m, x, bias + i, with_relu, y + i);
    i += vectors * kLanes;
    left -= vectors;
  }
}

}  // namespace

namespace {

void layer(int m, int n, int k, const float* a, int lda, const float* b, int ldb, const float* bias,
           bool relu, float* c, int ldc) {
  multiply({m, n, k, a, lda, b, 1, ldb, c, ldc, Start::row_bias, bias, relu});
}

void layer_of_rows(int m, int n, int k, const float* a, int lda, const float* b, int ldb,
                   const float* bias, bool relu, float* c, int ldc) {
  multiply({m, n, k, a, lda, b, 1, ldb, c, ldc, Start::column_bias, bias, relu});
}

constexpr int kChains = 12;  // more than two multiply-add units times a latency of four cycles

float multiply_add_rounds(long rounds) {
  // Volatile: nothing may be computed ahead by the compiler.
  const volatile float factor_source = 0.999F;
  const volatile float term_source = 0.001F;
  const Vector factor = broadcast(factor_source);
  const Vector term = broadcast(term_source);
  Vector x[kChains];
#pragma GCC unroll 12
  for (int c = 0; c < kChains; ++c) {
    x[c] = term * float(c);
  }
  for (long r = 0; r < rounds; ++r) {
#pragma GCC unroll 12
    for (int c = 0; c < kChains; ++c) {
      x[c] = multiply_add(x[c], factor, term);
    }
  }
  Vector sum{};
#pragma GCC unroll 12
  for (int c = 0; c < kChains; ++c) {
    sum += x[c];
  }
  float total = 0.0F;
  for (int i = 0; i < kLanes; ++i) {
    total += sum[i];
  }
  return total;
}

constexpr GemmKernels kGemmKernels = {
    kLanes, layer, layer_of_rows, query_layer, multiply_add_rounds, kChains* kLanes};

}  // namespace

}  // namespace limber
