#pragma once

// OptimiserKernels for the instruction set that the including file is compiled for (see
// kernels/vector_float.hpp).

#include "frame_error_kernels.hpp"

namespace limber {
namespace {

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
    sum += double(lane_sum(multiply_add(rest, rest, part)));
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

}  // namespace
}  // namespace limber
