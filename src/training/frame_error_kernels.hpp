#pragma once

// Frame errors (FrameError in limber/training/frame_error.hpp has the equations) for the
// instruction set that the including file is compiled for (see kernels/vector_float.hpp), one lane
// a window.

#include "kernels/vector_sincos.hpp"
#include "limber/arm/pose_size.hpp"
#include "space_frame_error.hpp"

namespace limber {
namespace {

inline float lane_sum(Vector v) {
  float sum = 0.0F;
  for (int i = 0; i < kLanes; ++i) {
    sum += v[i];
  }
  return sum;
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

// One vector of windows. The equations: FrameError in frame_error.hpp.
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
      const Vector dx = gap(kPoseSize * i);
      const Vector dy = gap(kPoseSize * i + 1);
      x = multiply_add(cosine, dx, multiply_add(-sine, dy, x));
      y = multiply_add(sine, dx, multiply_add(cosine, dy, y));
      theta += gap(kPoseSize * i + 2);
      error += compare(kPoseSize * i, x) + compare(kPoseSize * i + 1, y) +
               compare(kPoseSize * i + 2, theta);
    }
    return error;
  }

  void backward() const {
    Vector by_x{};
    Vector by_y{};
    Vector by_theta{};
    for (int i = gaps - 1; i >= 0; --i) {
      float* g = gradient + kPoseSize * i * stride;
      by_x += load(g);
      by_y += load(g + stride);
      by_theta += load(g + 2 * stride);
      const Vector cosine = load(scratch + 2 * i * kLanes);
      const Vector sine = load(scratch + (2 * i + 1) * kLanes);
      const Vector along = multiply_add(cosine, by_x, sine * by_y);
      const Vector across = multiply_add(cosine, by_y, -(sine * by_x));
      store(g, along * broadcast(scale[kPoseSize * i]));
      store(g + stride, across * broadcast(scale[kPoseSize * i + 1]));
      store(g + 2 * stride, by_theta * broadcast(scale[kPoseSize * i + 2]));
      by_theta += multiply_add(gap(kPoseSize * i), across, -(gap(kPoseSize * i + 1) * along));
    }
  }
};

struct LanesOfWindows {
  static constexpr int kLanesOfN = kLanes;
  static Vector load(const float* p) { return limber::load(p); }
  static void store(float* p, Vector v) { limber::store(p, v); }
  static Vector all(float x) { return broadcast(x); }
  static Vector signed_weight(Vector difference, Vector weight) {
    return with_sign_of(difference, weight);
  }
};

using InPlane = ChainedError;
using InSpace = SpaceChainedError<Vector, LanesOfWindows, float>;

// Of all windows, a vector of them at a time. @tparam Error  InPlane or InSpace
template <class Error>
float chain(int gaps, int stride, const float* weight, const float* scale, const float* offset,
            const float* state, const float* target, const float* window_weight, float* gradient,
            float* scratch) {
  Vector sum{};
  for (int q = 0; q < stride; q += kLanes) {
    const Error part = {gaps,         stride,    weight,     scale,
                        offset,       state + q, target + q, load(window_weight + q),
                        gradient + q, scratch};
    sum = multiply_add(part.forward(), part.window_weight, sum);
    part.backward();
  }
  return lane_sum(sum);
}

}  // namespace
}  // namespace limber
