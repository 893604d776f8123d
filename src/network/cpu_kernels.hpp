#pragma once

// The kernels of GemmKernels for the instruction set that the including file is compiled for; see
// vector_float.hpp for why nothing here may leave the unnamed namespace.

#include "kernels/gemm_tiles.hpp"
#include "limber/network/gemm_kernels.hpp"
#include "query_layer.hpp"

namespace limber {
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
    x[c] = term * static_cast<float>(c);
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

constexpr GemmKernels kernels_of_this_level() {
  return {kLanes, layer, layer_of_rows, query_layer, multiply_add_rounds, kChains * kLanes};
}

}  // namespace
}  // namespace limber
