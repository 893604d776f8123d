#pragma once

// (20) for rows of windows, with its derivative, for the instruction set that the including file is
// compiled for (see kernels/vector_float.hpp). Bounds are hardly ever reached: a vector of windows
// tells whether any of its lanes is near one, and only then is each window looked at.

#include "kernels/vector_float.hpp"
#include "state_bound_kernels.hpp"

namespace limber {
namespace {

inline Vector gap_number(const StateBoundsView<float>& bounds, const float* state, int stride,
                         int row) {
  return multiply_add(load(state + row * stride), broadcast(bounds.scale[row]),
                      broadcast(bounds.offset[row]));
}

// Whether any lane of gap g, of kSize numbers, lies so close to a bound that it may be beyond it.
template <int kSize>
inline bool any_near_bound_of(const StateBoundsView<float>& bounds, int g, const float* state,
                              int stride) {
  constexpr float kRounding = 1e-5F;
  constexpr bool kInSpace = kSize == kSpaceGapSize;
  const GapBound<float>& bound = bounds.gaps[g];
  Vector of[kSize];
  for (int i = 0; i < kSize; ++i) {
    of[i] = gap_number(bounds, state, stride, kSize * g + i);
  }
  Vector square = of[0] * of[0] + of[1] * of[1];
  if constexpr (kInSpace) {
    square += of[2] * of[2];
  }
  const Vector turn = of[kInSpace ? 3 : 2];
  IntVector near = (square < broadcast(bound.min_square * (1.0F + kRounding))) |
                   (square > broadcast(bound.max_square * (1.0F - kRounding))) |
                   (turn < broadcast(bound.min_turn + kRounding)) |
                   (turn > broadcast(bound.max_turn - kRounding));
  if constexpr (kInSpace) {
    const Vector bend = of[4] * of[4] + of[5] * of[5];
    near |= bend > broadcast(bound.max_bend * bound.max_bend * (1.0F - kRounding));
  }
  return non_zero_lanes(reinterpret_cast<Vector>(near)) != 0;
}

inline bool any_near_bound(const StateBoundsView<float>& bounds, int g, const float* state,
                           int stride) {
  return bounds.gap_size == kSpaceGapSize
             ? any_near_bound_of<kSpaceGapSize>(bounds, g, state, stride)
             : any_near_bound_of<kPoseSize>(bounds, g, state, stride);
}

void bound(const StateBoundsView<float>& bounds, int stride, const float* unbounded, float* state) {
  if (bounds.of_base_poses) {
    for (int j = 0; j < stride; ++j) {
      bound_base_window(bounds, stride, unbounded + j, state + j);
    }
    return;
  }
  for (int i = 0; i < bounds.gap_size * bounds.gap_count * stride; i += kLanes) {
    store(state + i, load(unbounded + i));
  }
  for (int g = 0; g < bounds.gap_count; ++g) {
    for (int q = 0; q < stride; q += kLanes) {
      if (any_near_bound(bounds, g, unbounded + q, stride)) {
        for (int j = q; j < q + kLanes; ++j) {
          bound_gap_of_window(bounds, g, stride, unbounded + j, state + j);
        }
      }
    }
  }
}

void bound_back(const StateBoundsView<float>& bounds, int stride, const float* unbounded,
                float* carried, float* direct, float* error) {
  if (bounds.of_base_poses) {
    for (int j = 0; j < stride; ++j) {
      bound_base_window_back(bounds, stride, unbounded + j, carried + j, direct + j, error + j);
    }
    return;
  }
  for (int g = 0; g < bounds.gap_count; ++g) {
    for (int q = 0; q < stride; q += kLanes) {
      if (any_near_bound(bounds, g, unbounded + q, stride)) {
        for (int j = q; j < q + kLanes; ++j) {
          bound_gap_of_window_back(bounds, g, stride, unbounded + j, carried + j, direct + j,
                                   error + j);
        }
      }
    }
  }
}

}  // namespace
}  // namespace limber
