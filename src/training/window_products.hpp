#pragma once

// The gradient of a weight, Σ dy·xᵀ over many windows, compiled once per CPU level. Both factors
// have their windows contiguous, so a tile of sums (kTileOutputs × kTileInputs) holds one partial
// sum per lane while whole vectors of both stream by; the lanes are added up once, at the end.

#include <cstddef>

#include "kernels/vector_float.hpp"

namespace limber {
namespace {

#if defined(__AVX512F__) || defined(__aarch64__)
constexpr int kTileOutputs = 4;
constexpr int kTileInputs = 6;
#else
constexpr int kTileOutputs = 3;
constexpr int kTileInputs = 4;
#endif

// Lanes of a, and those of b behind them, by their numbers. clang, which fuzzes, has no such
// instruction for numbers that are not literals.
inline Vector shuffled(Vector a, Vector b, IntVector lanes) {
#if defined(__clang__)
  Vector result;
  for (int i = 0; i < kLanes; ++i) {
    result[i] = lanes[i] < kLanes ? a[lanes[i]] : b[lanes[i] - kLanes];
  }
  return result;
#else
  return __builtin_shuffle(a, b, lanes);
#endif
}

// Lane numbers for shuffled(a, b, ·): of every second run of kRun lanes of a, and of b in
// between; the first runs, or the second ones where kOdd.
template <int kRun, bool kOdd>
inline IntVector runs() {
  IntVector lanes;
  for (int i = 0; i < kLanes; ++i) {
    const bool from_b = (i / kRun) % 2 == 1;
    lanes[i] = (from_b ? kLanes + i - kRun : i) + (kOdd ? kRun : 0);
  }
  return lanes;
}

// Adds v[2i] and v[2i + 1] pairwise until one vector is left; lane i of it is the sum of v[i].
template <int kRun = 1>
inline void add_lanes(Vector* v) {
#pragma GCC unroll 16
  for (int i = 0; i < kLanes / (2 * kRun); ++i) {
    const Vector a = v[2 * i];
    const Vector b = v[2 * i + 1];
    v[i] = shuffled(a, b, runs<kRun, false>()) + shuffled(a, b, runs<kRun, true>());
  }
  if constexpr (2 * kRun < kLanes) {
    add_lanes<2 * kRun>(v);
  }
}

// Blocks of windows: dy has m rows per block, x begins `x_block` numbers after the block before.
struct WindowBlocks {
  int count, stride;
  std::ptrdiff_t dy_block, x_block;
};

template <int kOutputs, int kInputs>
void add_products(const WindowBlocks& blocks, const float* dy, const float* x, float* gradient,
                  std::ptrdiff_t ld) {
  Vector sum[kInputs][kOutputs];
#pragma GCC unroll 6
  for (int j = 0; j < kInputs; ++j) {
#pragma GCC unroll 4
    for (int i = 0; i < kOutputs; ++i) {
      sum[j][i] = Vector{};
    }
  }
  for (int block = 0; block < blocks.count; ++block) {
    for (int q = 0; q < blocks.stride; q += kLanes) {
      Vector a[kOutputs];
#pragma GCC unroll 4
      for (int i = 0; i < kOutputs; ++i) {
        a[i] = load(dy + i * blocks.stride + q);
      }
#pragma GCC unroll 6
      for (int j = 0; j < kInputs; ++j) {
        const Vector b = load(x + j * blocks.stride + q);
#pragma GCC unroll 4
        for (int i = 0; i < kOutputs; ++i) {
          sum[j][i] = multiply_add(a[i], b, sum[j][i]);
        }
      }
    }
    dy += blocks.dy_block;
    x += blocks.x_block;
  }
  constexpr int kVectors = (kOutputs * kInputs + kLanes - 1) / kLanes;
  Vector flat[kVectors * kLanes];
  float total[kVectors * kLanes];
#pragma GCC unroll 32
  for (int t = 0; t < kVectors * kLanes; ++t) {
    flat[t] = t < kOutputs * kInputs ? sum[t / kOutputs][t % kOutputs] : Vector{};
  }
#pragma GCC unroll 4
  for (int v = 0; v < kVectors; ++v) {
    add_lanes(flat + v * kLanes);
    store(total + v * kLanes, flat[v * kLanes]);
  }
  for (int j = 0; j < kInputs; ++j) {
    for (int i = 0; i < kOutputs; ++i) {
      gradient[j * ld + i] += total[j * kOutputs + i];
    }
  }
}

template <int kInputs, int kOutputs = kTileOutputs>
void add_rows(const WindowBlocks& blocks, int m, const float* dy, const float* x, float* gradient,
              std::ptrdiff_t ld) {
  int i = 0;
  for (; i + kOutputs <= m; i += kOutputs) {
    add_products<kOutputs, kInputs>(blocks, dy + i * blocks.stride, x, gradient + i, ld);
  }
  if constexpr (kOutputs > 1) {
    if (i < m) {
      add_rows<kInputs, kOutputs - 1>(blocks, m - i, dy + i * blocks.stride, x, gradient + i, ld);
    }
  }
}

template <int kInputs = kTileInputs>
void add_columns(const WindowBlocks& blocks, int m, int k, const float* dy, const float* x,
                 float* gradient) {
  int j = 0;
  for (; j + kInputs <= k; j += kInputs) {
    add_rows<kInputs>(blocks, m, dy, x + j * blocks.stride, gradient + std::ptrdiff_t{j} * m, m);
  }
  if constexpr (kInputs > 1) {
    if (j < k) {
      add_columns<kInputs - 1>(blocks, m, k - j, dy, x + j * blocks.stride,
                               gradient + std::ptrdiff_t{j} * m);
    }
  }
}

}  // namespace
}  // namespace limber
