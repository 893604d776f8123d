#pragma once

// The kernels of GemmKernels for the instruction set that the including file is compiled for; see
// vector_float.hpp for why nothing here may leave the unnamed namespace.

#include "common/vector_sincos.hpp"
#include "gemm_tiles.hpp"
#include "limber/network/gemm_kernels.hpp"
#include "query_layer.hpp"

namespace limber {
namespace {

Start start_of(bool accumulate) {
  return accumulate ? Start::c : Start::zero;
}

void gemm_nn(int m, int n, int k, const float* a, int lda, const float* b, int ldb, float* c,
             int ldc, bool accumulate) {
  multiply({m, n, k, a, lda, b, 1, ldb, c, ldc, start_of(accumulate), nullptr, false});
}

void gemm_nt(int m, int n, int k, const float* a, int lda, const float* b, int ldb, float* c,
             int ldc, bool accumulate) {
  multiply({m, n, k, a, lda, b, ldb, 1, c, ldc, start_of(accumulate), nullptr, false});
}

// Rows of A come from columns of the stored matrix: transposed into a panel a block at a time.
void gemm_tn(int m, int n, int k, const float* a, int lda, const float* b, int ldb, float* c,
             int ldc, bool accumulate) {
  constexpr int kRows = kTileVectors * kLanes;
  alignas(64) float panel[kRows * kBlock];
  for (int i = 0; i < m; i += kRows) {
    const int rows = m - i < kRows ? m - i : kRows;
    for (int from = 0; from == 0 || from < k; from += kBlock) {
      const int depth = k - from < kBlock ? k - from : kBlock;
      for (int r = 0; r < rows; ++r) {
        const float* column = a + from + static_cast<std::ptrdiff_t>(i + r) * lda;
        for (int s = 0; s < depth; ++s) {
          panel[s * kRows + r] = column[s];
        }
      }
      multiply_panels({rows, n, depth, panel, kRows, b + from, 1, ldb, c + i, ldc,
                       start_of(accumulate || from > 0), nullptr, false});
    }
  }
}

void layer(int m, int n, int k, const float* a, int lda, const float* b, int ldb, const float* bias,
           bool relu, float* c, int ldc) {
  multiply({m, n, k, a, lda, b, 1, ldb, c, ldc, Start::row_bias, bias, relu});
}

void layer_of_rows(int m, int n, int k, const float* a, int lda, const float* b, int ldb,
                   const float* bias, bool relu, float* c, int ldc) {
  multiply({m, n, k, a, lda, b, 1, ldb, c, ldc, Start::column_bias, bias, relu});
}

void relu_gradient(int m, int n, const float* activation, int ld_activation, float* gradient,
                   int ld_gradient) {
  for (int j = 0; j < n; ++j) {
    const float* y = activation + static_cast<std::ptrdiff_t>(j) * ld_activation;
    float* g = gradient + static_cast<std::ptrdiff_t>(j) * ld_gradient;
    int i = 0;
    for (; i + kLanes <= m; i += kLanes) {
      store(g + i, load(y + i) > Vector{} ? load(g + i) : Vector{});
    }
    for (; i < m; ++i) {
      g[i] = y[i] > 0.0F ? g[i] : 0.0F;
    }
  }
}

void row_sums(int m, int n, const float* a, int lda, float* sums, bool accumulate) {
  for (int i = 0; i < m; i += kLanes) {
    const int count = m - i < kLanes ? m - i : kLanes;
    Vector sum = accumulate ? load_part(sums + i, count) : Vector{};
    for (int j = 0; j < n; ++j) {
      sum += load_part(a + i + static_cast<std::ptrdiff_t>(j) * lda, count);
    }
    store_part(sums + i, sum, count);
  }
}

void sincos_array(int count, const float* angle_rad, float* sine, float* cosine) {
  for (int i = 0; i < count; i += kLanes) {
    const int part = count - i < kLanes ? count - i : kLanes;
    Vector s;
    Vector c;
    sincos(load_part(angle_rad + i, part), s, c);
    store_part(sine + i, s, part);
    store_part(cosine + i, c, part);
  }
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

constexpr auto query_layer_of_halves() {
  decltype(GemmKernels::query_layer_of_halves) kernel = nullptr;
  if constexpr (kLoadsHalves) {
    kernel = query_layer<unsigned short>;
  }
  return kernel;
}

constexpr GemmKernels kernels_of_this_level() {
  return {kLanes,
          gemm_nn,
          gemm_tn,
          gemm_nt,
          layer,
          layer_of_rows,
          query_layer<float>,
          query_layer_of_halves(),
          relu_gradient,
          row_sums,
          sincos_array,
          multiply_add_rounds,
          kChains * kLanes};
}

}  // namespace
}  // namespace limber
