#pragma once

// WindowKernels and OptimiserKernels for the instruction set that the including file is compiled
// for (see common/vector_float.hpp).

#include "common/vector_logistic.hpp"
#include "common/vector_sincos.hpp"
#include "network/gemm_tiles.hpp"
#include "training/training_kernels.hpp"
#include "training/window_products.hpp"

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

inline float lane_sum(Vector v) {
  float sum = 0.0F;
  for (int i = 0; i < kLanes; ++i) {
    sum += v[i];
  }
  return sum;
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

// Runs of kRun lanes change places between vectors kRun apart: after runs of 1, 2, 4 … lanes, lane
// i of vector j is what lane j of vector i was.
template <int kRun = 1>
inline void transpose(Vector* v) {
#pragma GCC unroll 16
  for (int i = 0; i < kLanes; ++i) {
    if ((i & kRun) == 0) {
      const Vector a = v[i];
      const Vector b = v[i + kRun];
      v[i] = __builtin_shuffle(a, b, runs<kRun, false>());
      v[i + kRun] = __builtin_shuffle(a, b, runs<kRun, true>());
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
    const float* column = columns + static_cast<std::ptrdiff_t>(index[j]) * ld;
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
        v[i] = load_part(columns + static_cast<std::ptrdiff_t>(index[q + i]) * ld + r, count);
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

// factor where difference > 0, −factor below, 0 at 0.
inline Vector with_sign_of(Vector difference, Vector factor) {
  return select(difference > Vector{}, factor, select(difference < Vector{}, -factor, Vector{}));
}

float entry_error(int size, int stride, const float* weight, const float* state,
                  const float* target, const float* window_weight, float* gradient) {
  Vector sum{};
  for (int q = 0; q < stride; q += kLanes) {
    const Vector of_window = load(window_weight + q);
    Vector error{};
    for (int r = 0; r < size; ++r) {
      const int at = r * stride + q;
      const Vector difference = load(state + at) - load(target + at);
      const Vector factor = broadcast(weight[r]);
      error = multiply_add(factor, absolute(difference), error);
      store(gradient + at, with_sign_of(difference, factor * of_window));
    }
    sum = multiply_add(error, of_window, sum);
  }
  return lane_sum(sum);
}

// One vector of windows of chained_error. The equations: FrameError in frame_error.hpp.
struct ChainedError {
  int gaps, stride;
  const float* weight;
  const float* scale;
  const float* offset;
  const float* state;
  const float* target;
  Vector window_weight;
  float* gradient;
  float* scratch;

  Vector gap(int r) const {
    return multiply_add(load(state + r * stride), broadcast(scale[r]), broadcast(offset[r]));
  }

  // Leaves weight ∘ sign(error) in the gradient's place.
  Vector compare(int r, Vector predicted) const {
    const Vector difference = predicted - load(target + r * stride);
    const Vector factor = broadcast(weight[r]);
    store(gradient + r * stride, with_sign_of(difference, factor * window_weight));
    return factor * absolute(difference);
  }

  Vector forward() const {
    Vector x{};
    Vector y{};
    Vector theta{};
    Vector error{};
    for (int i = 0; i < gaps; ++i) {
      Vector sine;
      Vector cosine;
      sincos(theta, sine, cosine);
      store(scratch + 2 * i * kLanes, cosine);
      store(scratch + (2 * i + 1) * kLanes, sine);
      const Vector dx = gap(3 * i);
      const Vector dy = gap(3 * i + 1);
      x = multiply_add(cosine, dx, multiply_add(-sine, dy, x));
      y = multiply_add(sine, dx, multiply_add(cosine, dy, y));
      theta += gap(3 * i + 2);
      error += compare(3 * i, x) + compare(3 * i + 1, y) + compare(3 * i + 2, theta);
    }
    return error;
  }

  void backward() const {
    Vector by_x{};
    Vector by_y{};
    Vector by_theta{};
    for (int i = gaps - 1; i >= 0; --i) {
      float* g = gradient + 3 * i * stride;
      by_x += load(g);
      by_y += load(g + stride);
      by_theta += load(g + 2 * stride);
      const Vector cosine = load(scratch + 2 * i * kLanes);
      const Vector sine = load(scratch + (2 * i + 1) * kLanes);
      const Vector along = multiply_add(cosine, by_x, sine * by_y);
      const Vector across = multiply_add(cosine, by_y, -(sine * by_x));
      store(g, along * broadcast(scale[3 * i]));
      store(g + stride, across * broadcast(scale[3 * i + 1]));
      store(g + 2 * stride, by_theta * broadcast(scale[3 * i + 2]));
      by_theta += multiply_add(gap(3 * i), across, -(gap(3 * i + 1) * along));
    }
  }
};

float chained_error(int gaps, int stride, const float* weight, const float* scale,
                    const float* offset, const float* state, const float* target,
                    const float* window_weight, float* gradient, float* scratch) {
  Vector sum{};
  for (int q = 0; q < stride; q += kLanes) {
    const ChainedError part = {gaps,         stride,    weight,     scale,
                               offset,       state + q, target + q, load(window_weight + q),
                               gradient + q, scratch};
    sum = multiply_add(part.forward(), part.window_weight, sum);
    part.backward();
  }
  return lane_sum(sum);
}

void add(int count, const float* term, float* sum) {
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    store(sum + i, load(sum + i) + load(term + i));
  }
  for (; i < count; ++i) {
    sum[i] += term[i];
  }
}

double square_sum(int count, const float* x) {
  constexpr int kRun = 64 * kLanes;  // short enough for float's rounding
  double sum = 0.0;
  for (int from = 0; from < count; from += kRun) {
    const int end = count - from < kRun ? count : from + kRun;
    Vector part{};
    int i = from;
    for (; i + kLanes <= end; i += kLanes) {
      part = multiply_add(load(x + i), load(x + i), part);
    }
    const Vector rest = load_part(x + i, end - i);
    sum += static_cast<double>(lane_sum(multiply_add(rest, rest, part)));
  }
  return sum;
}

inline Vector square_root(Vector v) {
#if defined(__AVX512F__)
  return _mm512_sqrt_ps(v);
#elif defined(__AVX2__)
  return _mm256_sqrt_ps(v);
#elif defined(__SSE2__)
  return _mm_sqrt_ps(v);
#elif defined(__aarch64__)
  return vsqrtq_f32(v);
#else
  for (int i = 0; i < kLanes; ++i) {
    v[i] = __builtin_sqrtf(v[i]);
  }
  return v;
#endif
}

void adam(int count, const float* gradient, float rate, float root_bias2, float* first_moment,
          float* second_moment, float* parameters) {
  constexpr float kBeta1 = 0.9F;
  constexpr float kBeta2 = 0.999F;
  constexpr float kEpsilon = 1e-8F;
  for (int i = 0; i < count; i += kLanes) {
    const int part = count - i < kLanes ? count - i : kLanes;
    const Vector g = load_part(gradient + i, part);
    const Vector m =
        broadcast(kBeta1) * load_part(first_moment + i, part) + broadcast(1.0F - kBeta1) * g;
    const Vector v =
        broadcast(kBeta2) * load_part(second_moment + i, part) + broadcast(1.0F - kBeta2) * (g * g);
    store_part(first_moment + i, m, part);
    store_part(second_moment + i, v, part);
    const Vector step =
        broadcast(rate) * m / (square_root(v) * broadcast(root_bias2) + broadcast(kEpsilon));
    store_part(parameters + i, load_part(parameters + i, part) - step, part);
  }
}

constexpr WindowKernels<float> window_kernels_of_this_level() {
  return {kLanes,     layer, layer_back,   weight_gradient, bias_gradient, relu_gradient, gather,
          add_scaled, carry, gated_change, gated_carry,     entry_error,   chained_error};
}

constexpr OptimiserKernels optimiser_kernels_of_this_level() {
  return {add, square_sum, adam};
}

}  // namespace
}  // namespace limber
