#pragma once

// The matrix product behind GemmKernels, compiled once per CPU level by gemm_kernels_<level>.cpp. A
// tile of C (up to kTileVectors vectors down, or kTallVectors where there are few columns, and as
// many columns across as kAccumulators allow) stays in registers while k runs; each step loads one
// column piece of A and broadcasts one row piece of B.

#include <cstddef>

#include "kernels/vector_float.hpp"

namespace limber {
namespace {

// What stands in C before the products are added.
enum class Start { zero, c, row_bias, column_bias };

// C (m×n, column-major) = start + A·B, A column-major, B(k, j) at b[k·b_step_k + j·b_step_j].
struct Product {
  int m, n, k;
  const float* a;
  std::ptrdiff_t lda;
  const float* b;
  std::ptrdiff_t b_step_k, b_step_j;
  float* c;
  std::ptrdiff_t ldc;
  Start start;
  const float* bias;
  bool relu;
};

// The part of a product that starts at row i and column j; `tail` rows in the last vector, 0: full.
struct Tile {
  int i, j, tail;
};

template <int kVectors, int kColumns, bool kPartial>
inline void start_tile(const Product& p, Tile t, Vector (&sum)[kColumns][kVectors]) {
#pragma GCC unroll 12
  for (int j = 0; j < kColumns; ++j) {
    const float* c = p.c + t.i + (t.j + j) * p.ldc;
#pragma GCC unroll 12
    for (int v = 0; v < kVectors; ++v) {
      const bool last = kPartial && v == kVectors - 1;
      const float* source = p.start == Start::c          ? c
                            : p.start == Start::row_bias ? p.bias + t.i
                                                         : nullptr;
      if (p.start == Start::zero) {
        sum[j][v] = Vector{};
      } else if (p.start == Start::column_bias) {
        sum[j][v] = broadcast(p.bias[t.j + j]);
      } else {
        sum[j][v] = last ? load_part(source + v * kLanes, t.tail) : load(source + v * kLanes);
      }
    }
  }
}

template <int kVectors, int kColumns, bool kPartial>
void multiply_tile(const Product& p, Tile t) {
  Vector sum[kColumns][kVectors];
  start_tile<kVectors, kColumns, kPartial>(p, t, sum);
  const bool has_products = p.k > 0;  // else there may be no A and no B
  const float* a = has_products ? p.a + t.i : nullptr;
  const float* b = has_products ? p.b + t.j * p.b_step_j : nullptr;
  for (int k = 0; k < p.k; ++k, a += p.lda, b += p.b_step_k) {
    if constexpr (kVectors > kTileVectors) {
      // Every row is loaded once, by itself: as an operand of each product, and still on its way
      // from the second cache, it would be asked for once per column.
      Vector columns[kColumns];
#pragma GCC unroll 12
      for (int j = 0; j < kColumns; ++j) {
        columns[j] = broadcast(b[j * p.b_step_j]);
      }
#pragma GCC unroll 12
      for (int v = 0; v < kVectors; ++v) {
        const bool last = kPartial && v == kVectors - 1;
        Vector row = last ? load_part(a + v * kLanes, t.tail) : load(a + v * kLanes);
        keep_in_register(row);
#pragma GCC unroll 12
        for (int j = 0; j < kColumns; ++j) {
          sum[j][v] = multiply_add(row, columns[j], sum[j][v]);
        }
      }
      continue;
    }
    Vector rows[kVectors];
#pragma GCC unroll 12
    for (int v = 0; v < kVectors; ++v) {
      const bool last = kPartial && v == kVectors - 1;
      rows[v] = last ? load_part(a + v * kLanes, t.tail) : load(a + v * kLanes);
    }
#pragma GCC unroll 12
    for (int j = 0; j < kColumns; ++j) {
      const Vector column = broadcast(b[j * p.b_step_j]);
#pragma GCC unroll 12
      for (int v = 0; v < kVectors; ++v) {
        sum[j][v] = multiply_add(rows[v], column, sum[j][v]);
      }
    }
  }
#pragma GCC unroll 12
  for (int j = 0; j < kColumns; ++j) {
    float* c = p.c + t.i + (t.j + j) * p.ldc;
#pragma GCC unroll 12
    for (int v = 0; v < kVectors; ++v) {
      const Vector value = p.relu ? relu(sum[j][v]) : sum[j][v];
      if (kPartial && v == kVectors - 1) {
        store_part(c + v * kLanes, value, t.tail);
      } else {
        store(c + v * kLanes, value);
      }
    }
  }
}

// The widest tile that fits into `columns` after one of `kColumns` did not.
constexpr int narrower(int columns) {
  return columns > 8 ? 8 : columns > 6 ? 6 : columns - 1;
}

// Columns t.j … t.j + columns, in tiles as wide as the registers allow.
template <int kVectors, int kColumns, bool kPartial>
void multiply_columns(const Product& p, Tile t, int columns) {
  for (; columns >= kColumns; columns -= kColumns, t.j += kColumns) {
    multiply_tile<kVectors, kColumns, kPartial>(p, t);
  }
  if constexpr (kColumns > 1) {
    if (columns > 0) {
      multiply_columns<kVectors, narrower(kColumns), kPartial>(p, t, columns);
    }
  }
}

template <int kVectors, bool kPartial>
void multiply_panel(const Product& p, Tile t) {
  constexpr int kFit = kAccumulators / kVectors;
  multiply_columns<kVectors, (kFit < kWidestTile ? kFit : kWidestTile), kPartial>(p, t, p.n);
}

template <bool kPartial, int kVectors = 1>
void multiply_vectors(const Product& p, Tile t, int vectors) {
  if (vectors == kVectors) {
    multiply_panel<kVectors, kPartial>(p, t);
  } else if constexpr (kVectors < kTallVectors) {
    multiply_vectors<kPartial, kVectors + 1>(p, t, vectors);
  }
}

// Pieces of at most `largest` that are as equal as can be: 7 is 4 + 3, 9 is 3 + 3 + 3.
inline int balanced(int remaining, int largest) {
  const int pieces = (remaining + largest - 1) / largest;
  return (remaining + pieces - 1) / pieces;
}

// So few columns leave registers for tiles as tall as most layers: their weights then stream by
// once and in order, which is what they cost.
constexpr int kFewColumns = 3;

inline void multiply_panels(const Product& p) {
  int vectors_left = (p.m + kLanes - 1) / kLanes;
  const int tallest = p.n <= kFewColumns ? kTallVectors : kTileVectors;
  for (int i = 0; vectors_left > 0;) {
    const int vectors = balanced(vectors_left, tallest);
    const int tail = p.m - i < vectors * kLanes ? (p.m - i) % kLanes : 0;
    if (tail != 0) {
      multiply_vectors<true>(p, {i, 0, tail}, vectors);
    } else {
      multiply_vectors<false>(p, {i, 0, 0}, vectors);
    }
    i += vectors * kLanes;
    vectors_left -= vectors;
  }
}

// Steps of k taken at a time: a panel of A, kTileVectors·kLanes rows, then fits the first cache. (A
// tall one is used once, and need not.)
constexpr int kBlock = 128;

void multiply(Product p) {
  const int k = p.k;
  const bool relu_at_end = p.relu;
  for (int from = 0;; from += kBlock) {
    const bool is_last = from + kBlock >= k;
    p.k = is_last ? k - from : kBlock;
    p.relu = relu_at_end && is_last;
    multiply_panels(p);
    if (is_last) {
      return;
    }
    p.a += kBlock * p.lda;
    p.b += kBlock * p.b_step_k;
    p.start = Start::c;
  }
}

}  // namespace
}  // namespace limber
