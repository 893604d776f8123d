#pragma once

// (20) for one window's normalised state, whose number r stands at [r·stride], and its derivative.
// Plain numbers, one window at a time: bounds are hardly ever reached.

#include "kernels/space_gap_bound.hpp"
#include "limber/arm/pose_size.hpp"
#include "training_kernels.hpp"

namespace limber {
namespace {

template <class Scalar>
inline Scalar in_metres(const StateBoundsView<Scalar>& bounds, int row, Scalar normalised) {
  return normalised * bounds.scale[row] + bounds.offset[row];
}

// A gap's numbers in metres and rad, and what (20) makes of numbers like them.
template <class Scalar>
struct GapNumbers {
  Scalar of[kSpaceGapSize];  // in a plane the first kPoseSize

  SpaceGap<Scalar> in_space() const { return {{of[0], of[1], of[2]}, {of[3], of[4], of[5]}}; }
  void take(const SpaceGap<Scalar>& gap) {
    for (int i = 0; i < 3; ++i) {
      of[i] = gap.d[i];
      of[3 + i] = gap.omega[i];
    }
  }
};

template <class Scalar>
inline GapNumbers<Scalar> gap_numbers(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                      const Scalar* state) {
  GapNumbers<Scalar> numbers{};
  for (int i = 0; i < bounds.gap_size; ++i) {
    const int r = bounds.gap_size * g + i;
    numbers.of[i] = in_metres(bounds, r, state[r * stride]);
  }
  return numbers;
}

template <class Scalar>
inline void bound_numbers(const StateBoundsView<Scalar>& bounds, int g,
                          GapNumbers<Scalar>& numbers) {
  if (bounds.gap_size == kSpaceGapSize) {
    SpaceGap<Scalar> gap = numbers.in_space();
    bound_gap(bounds.gaps[g], gap);
    numbers.take(gap);
  } else {
    bound_gap(bounds.gaps[g], numbers.of[0], numbers.of[1], numbers.of[2]);
  }
}

template <class Scalar>
inline void bound_numbers_back(const StateBoundsView<Scalar>& bounds, int g,
                               const GapNumbers<Scalar>& given, GapNumbers<Scalar>& by) {
  if (bounds.gap_size == kSpaceGapSize) {
    SpaceGap<Scalar> by_gap = by.in_space();
    bound_gap_back(bounds.gaps[g], bounds.lead_back, given.in_space(), by_gap);
    by.take(by_gap);
  } else {
    bound_gap_back(bounds.gaps[g], bounds.lead_back, given.of[0], given.of[1], given.of[2],
                   by.of[0], by.of[1], by.of[2]);
  }
}

// Writes what the bounds change, and nothing else: what they leave keeps its bits.
template <class Scalar>
inline void bound_gap_of_window(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                const Scalar* unbounded, Scalar* state) {
  const GapNumbers<Scalar> given = gap_numbers(bounds, g, stride, unbounded);
  GapNumbers<Scalar> kept = given;
  bound_numbers(bounds, g, kept);
  for (int i = 0; i < bounds.gap_size; ++i) {
    if (kept.of[i] != given.of[i]) {
      const int r = bounds.gap_size * g + i;
      state[r * stride] = (kept.of[i] - bounds.offset[r]) / bounds.scale[r];
    }
  }
}

template <class Scalar>
inline void bound_gap_of_window_back(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                     const Scalar* unbounded, Scalar* carried, Scalar* direct,
                                     Scalar* error) {
  const GapNumbers<Scalar> given = gap_numbers(bounds, g, stride, unbounded);
  GapNumbers<Scalar> before{};
  for (int i = 0; i < bounds.gap_size; ++i) {
    const int r = bounds.gap_size * g + i;
    const int at = r * stride;
    before.of[i] = (carried[at] + direct[at] + error[at]) / bounds.scale[r];
  }
  GapNumbers<Scalar> by = before;
  bound_numbers_back(bounds, g, given, by);
  for (int i = 0; i < bounds.gap_size; ++i) {
    if (by.of[i] != before.of[i]) {
      const int r = bounds.gap_size * g + i;
      const int at = r * stride;
      carried[at] = by.of[i] * bounds.scale[r];
      direct[at] = 0;
      error[at] = 0;
    }
  }
}

// Of base poses, each plate's step from the plate before is bounded, and all steps are chained
// again from the origin.
template <class Scalar>
inline void bound_base_window(const StateBoundsView<Scalar>& bounds, int stride,
                              const Scalar* unbounded, Scalar* state) {
  Scalar before[kPoseSize] = {};
  Scalar now[kPoseSize] = {};
  for (int i = 0; i < kPoseSize; ++i) {
    state[i * stride] = -bounds.offset[i] / bounds.scale[i];
  }
  for (int g = 0; g < bounds.gap_count; ++g) {
    Scalar step[kPoseSize];
    for (int i = 0; i < kPoseSize; ++i) {
      const int r = kPoseSize * (g + 1) + i;
      const Scalar given = in_metres(bounds, r, unbounded[r * stride]);
      step[i] = given - before[i];
      before[i] = given;
    }
    bound_gap(bounds.gaps[g], step[0], step[1], step[2]);
    for (int i = 0; i < kPoseSize; ++i) {
      const int r = kPoseSize * (g + 1) + i;
      now[i] += step[i];
      state[r * stride] = (now[i] - bounds.offset[r]) / bounds.scale[r];
    }
  }
}

// From the tip to the base: a step moves all plates behind it.
template <class Scalar>
inline void bound_base_window_back(const StateBoundsView<Scalar>& bounds, int stride,
                                   const Scalar* unbounded, Scalar* carried, Scalar* direct,
                                   Scalar* error) {
  Scalar behind[kPoseSize] = {};     // gradient by all plates from here to the tip
  Scalar from_next[kPoseSize] = {};  // by the step to the next plate
  for (int g = bounds.gap_count - 1; g >= -1; --g) {
    Scalar by[kPoseSize] = {};
    if (g >= 0) {
      Scalar step[kPoseSize];
      for (int i = 0; i < kPoseSize; ++i) {
        const int r = kPoseSize * (g + 1) + i;
        const int at = r * stride;
        behind[i] += (carried[at] + direct[at] + error[at]) / bounds.scale[r];
        by[i] = behind[i];
        const Scalar base =
            g > 0 ? in_metres(bounds, r - kPoseSize, unbounded[at - kPoseSize * stride])
                  : Scalar(0);
        step[i] = in_metres(bounds, r, unbounded[at]) - base;
      }
      bound_gap_back(bounds.gaps[g], bounds.lead_back, step[0], step[1], step[2], by[0], by[1],
                     by[2]);
    }
    for (int i = 0; i < kPoseSize; ++i) {
      const int r = kPoseSize * (g + 1) + i;
      const int at = r * stride;
      carried[at] = g >= 0 ? (by[i] - from_next[i]) * bounds.scale[r] : Scalar(0);
      direct[at] = 0;
      error[at] = 0;
      from_next[i] = by[i];
    }
  }
}

}  // namespace
}  // namespace limber
