#pragma once

// WindowKernels and OptimiserKernels for the instruction set that the including file is compiled
// for (see kernels/vector_float.hpp).

#include "bounded_rows.hpp"
#include "frame_error_kernels.hpp"
#include "kernels/gemm_tiles.hpp"
#include "kernels/vector_logistic.hpp"
#include "optimiser_kernels.hpp"
#include "training_kernels.hpp"
#include "window_products.hpp"

namespace limber {
namespace {

void layer(int stride, int m, int k, const float* x, const float* weight, const float* bias,
           bool relu, float* y) {
  multiply({stride, m, k, x, stride, weight, m, 1, y, stride, Start::column_bias, bias, relu});
}

void layer_back(int stride, int m, int k, const float* dy, const float* weight, float* dx) {
  multiply({stride, k, m, dy, stride, weight, 1, m, dx, stride, Start::zero, nullptr, false});
}

void weight_gradient(int blocks, int stride, int m, int k, const float* dy, const float* x,
                     int x_block, float* gradient) {
  add_columns({blocks, stride, std::ptrdiff_t{m} * stride, x_block}, m, k, dy, x, gradient);
}

void bias_gradient(int blocks, int stride, int m, const float* dy, float* gradient) {
  for (int i = 0; i < m; ++i) {
    Vector sum{};
    for (int block = 0; block < blocks; ++block) {
      const float* row = dy + (std::ptrdiff_t{block} * m + i) * stride;
      for (int q = 0; q < stride; q += kLanes) {
        sum += load(row + q);
      }
    }
    gradient[i] += lane_sum(sum);
  }
}

void relu_gradient(int count, const float* activation, float* gradient) {
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    store(gradient + i, select(load(activation + i) > Vector{}, load(gradient + i), Vector{}));
  }
  for (; i < count; ++i) {
    gradient[i] = activation[i] > 0.0F ? gradient[i] : 0.0F;
  }
}

void modulate(int count, const float* gain, const float* shift, float* y) {
  for (int i = 0; i < count; i += kLanes) {
    store(y + i, load(gain + i) * relu(load(y + i) + load(shift + i)));
  }
}

void modulate_back(int count, const float* gain, const float* y, float* dy, float* dlog_gain,
                   float* dshift) {
  for (int i = 0; i < count; i += kLanes) {
    const Vector value = load(y + i);
    const Vector delta = load(dy + i);
    const Vector before = select(value > Vector{}, load(gain + i) * delta, Vector{});
    store(dlog_gain + i, multiply_add(delta, value, load(dlog_gain + i)));
    store(dshift + i, load(dshift + i) + before);
    store(dy + i, before);
  }
}

// Runs of kRun lanes change places between vectors kRun apart: after runs of 1, 2, 4 … lanes, lane
// i of vector j is what lane j of vector i was.
template <int kRun = 1>
inline void transpose(Vector* v) {
#pragma GCC unroll 16
  for (int i = 0; i < kLanes; ++i) {
    if ((i & kRun) == 0) {
      const Vector a = v[i];
      const Vector b = v[i + kRun];
      v[i] = shuffled(a, b, runs<kRun, false>());
      v[i + kRun] = shuffled(a, b, runs<kRun, true>());
    }
  }
  if constexpr (2 * kRun < kLanes) {
    transpose<2 * kRun>(v);
  }
}

void gather(int row_count, int stride, const float* columns, int ld, const int* index,
            float* rows) {
  // Windows lie anywhere in memory: all of it is asked for before the first is waited for.
  constexpr int kLine = 64 / sizeof(float);
  for (int j = 0; j < stride; ++j) {
    const float* column = columns + std::ptrdiff_t(index[j]) * ld;
    for (int r = 0; r < row_count; r += kLine) {
      __builtin_prefetch(column + r);
    }
  }
  for (int q = 0; q < stride; q += kLanes) {
    for (int r = 0; r < row_count; r += kLanes) {
      const int count = row_count - r < kLanes ? row_count - r : kLanes;
      Vector v[kLanes];
#pragma GCC unroll 16
      for (int i = 0; i < kLanes; ++i) {
        v[i] = load_part(columns + std::ptrdiff_t(index[q + i]) * ld + r, count);
      }
      transpose(v);
      for (int i = 0; i < count; ++i) {
        store(rows + (r + i) * stride + q, v[i]);
      }
    }
  }
}

void add_scaled(int size, int stride, const float* scale, const float* output,
                const float* uncompensated, float* state) {
  for (int r = 0; r < size; ++r) {
    const Vector factor = broadcast(scale[r]);
    for (int q = r * stride; q < (r + 1) * stride; q += kLanes) {
      store(state + q, multiply_add(load(output + q), factor, load(uncompensated + q)));
    }
  }
}

void carry(int size, int stride, const float* scale, const float* error, float* carried,
           float* delta) {
  for (int r = 0; r < size; ++r) {
    const Vector factor = broadcast(scale[r]);
    for (int q = r * stride; q < (r + 1) * stride; q += kLanes) {
      const Vector sum = load(carried + q) + load(error + q);
      store(carried + q, sum);
      store(delta + q, factor * sum);
    }
  }
}

void gated_change(int size, int stride, const float* scale, const float* output,
                  const float* uncompensated, const float* previous, float* gate, float* state) {
  const float* gate_output = output + size * stride;
  for (int r = 0; r < size; ++r) {
    const Vector factor = broadcast(scale[r]);
    for (int q = r * stride; q < (r + 1) * stride; q += kLanes) {
      const Vector open = logistic(load(gate_output + q));
      const Vector before = load(previous + q);
      const Vector pull = load(uncompensated + q) - before;
      store(gate + q, open);
      store(state + q, multiply_add(open, pull, multiply_add(load(output + q), factor, before)));
    }
  }
}

void gated_carry(int size, int stride, const float* scale, const float* error,
                 const float* uncompensated, const float* previous, const float* gate,
                 const float* carried, float* direct, float* delta) {
  float* gate_delta = delta + size * stride;
  for (int r = 0; r < size; ++r) {
    const Vector factor = broadcast(scale[r]);
    for (int q = r * stride; q < (r + 1) * stride; q += kLanes) {
      const Vector sum = load(carried + q) + load(direct + q) + load(error + q);
      const Vector open = load(gate + q);
      const Vector passed = (broadcast(1.0F) - open) * sum;
      store(delta + q, factor * sum);
      store(gate_delta + q, passed * open * (load(uncompensated + q) - load(previous + q)));
      store(direct + q, passed);
    }
  }
}

constexpr WindowKernels<float> kWindowKernels = {
    kLanes,      layer,         layer_back, weight_gradient, bias_gradient,  relu_gradient,
    modulate,    modulate_back, gather,     add_scaled,      carry,          gated_change,
    gated_carry, bound,         bound_back, entry_error,     chain<InPlane>, chain<InSpace>};

constexpr OptimiserKernels kOptimiserKernels = {add, square_sum, adam};

}  // namespace
}  // namespace limber
