#pragma once

// (20) for one window's normalised state, whose number r stands at [r·stride], and its derivative.
// Plain numbers, one window at a time: bounds are hardly ever reached.

#include "kernels/space_gap_bound.hpp"
#include "limber/arm/pose_size.hpp"
#include "training_kernels.hpp"

namespace limber {
namespace {

// A gap's numbers in metres and rad.
template <class Scalar>
struct GapNumbers {
  Scalar x, y, turn;
};

template <class Scalar>
inline Scalar in_metres(const StateBoundsView<Scalar>& bounds, int row, Scalar normalised) {
  return normalised * bounds.scale[row] + bounds.offset[row];
}

template <class Scalar>
inline GapNumbers<Scalar> gap_numbers(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                      const Scalar* state) {
  const int r = kPoseSize * g;
  return {in_metres(bounds, r, state[r * stride]),
          in_metres(bounds, r + 1, state[(r + 1) * stride]),
          in_metres(bounds, r + 2, state[(r + 2) * stride])};
}

// Writes what the bounds change, and nothing else: what they leave keeps its bits.
template <class Scalar>
inline void bound_gap_of_window(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                const Scalar* unbounded, Scalar* state) {
  const GapNumbers<Scalar> given = gap_numbers(bounds, g, stride, unbounded);
  GapNumbers<Scalar> kept = given;
  bound_gap(bounds.gaps[g], kept.x, kept.y, kept.turn);
  const Scalar before[kPoseSize] = {given.x, given.y, given.turn};
  const Scalar after[kPoseSize] = {kept.x, kept.y, kept.turn};
  for (int i = 0; i < kPoseSize; ++i) {
    if (after[i] != before[i]) {
      const int r = kPoseSize * g + i;
      state[r * stride] = (after[i] - bounds.offset[r]) / bounds.scale[r];
    }
  }
}

template <class Scalar>
inline void bound_gap_of_window_back(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                     const Scalar* unbounded, Scalar* carried, Scalar* direct,
                                     Scalar* error) {
  const GapNumbers<Scalar> given = gap_numbers(bounds, g, stride, unbounded);
  Scalar by[kPoseSize];
  for (int i = 0; i < kPoseSize; ++i) {
    const int at = (kPoseSize * g + i) * stride;
    by[i] = (carried[at] + direct[at] + error[at]) / bounds.scale[kPoseSize * g + i];
  }
  const Scalar before[kPoseSize] = {by[0], by[1], by[2]};
  bound_gap_back(bounds.gaps[g], bounds.lead_back, given.x, given.y, given.turn, by[0], by[1],
                 by[2]);
  for (int i = 0; i < kPoseSize; ++i) {
    if (by[i] != before[i]) {
      const int at = (kPoseSize * g + i) * stride;
      carried[at] = by[i] * bounds.scale[kPoseSize * g + i];
      direct[at] = 0;
      error[at] = 0;
    }
  }
}

template <class Scalar>
inline SpaceGap<Scalar> space_gap_of(const StateBoundsView<Scalar>& bounds, int g, int stride,
                                     const Scalar* state) {
  SpaceGap<Scalar> gap;
  for (int i = 0; i < kSpaceGapSize; ++i) {
    const int r = kSpaceGapSize * g + i;
    (i < 3 ? gap.d[i] : gap.omega[i - 3]) = in_metres(bounds, r, state[r * stride]);
  }
  return gap;
}

template <class Scalar>
inline void bound_any_gap(const StateBoundsView<Scalar>& bounds, int g, int stride,
                          const Scalar* unbounded, Scalar* state) {
  if (bounds.gap_size != kSpaceGapSize) {
    bound_gap_of_window(bounds, g, stride, unbounded, state);
    return;
  }
  const SpaceGap<Scalar> given = space_gap_of(bounds, g, stride, unbounded);
  if (is_within(bounds.gaps[g], given)) {
    return;
  }
  SpaceGap<Scalar> kept = given;
  bound_gap(bounds.gaps[g], kept);
  for (int i = 0; i < kSpaceGapSize; ++i) {
    const int r = kSpaceGapSize * g + i;
    const Scalar number = i < 3 ? kept.d[i] : kept.omega[i - 3];
    state[r * stride] = (number - bounds.offset[r]) / bounds.scale[r];
  }
}

template <class Scalar>
inline void bound_any_gap_back(const StateBoundsView<Scalar>& bounds, int g, int stride,
                               const Scalar* unbounded, Scalar* carried, Scalar* direct,
                               Scalar* error) {
  if (bounds.gap_size != kSpaceGapSize) {
    bound_gap_of_window_back(bounds, g, stride, unbounded, carried, direct, error);
    return;
  }
  const SpaceGap<Scalar> given = space_gap_of(bounds, g, stride, unbounded);
  if (is_within(bounds.gaps[g], given)) {
    return;
  }
  SpaceGap<Scalar> by;
  for (int i = 0; i < kSpaceGapSize; ++i) {
    const int r = kSpaceGapSize * g + i;
    const int at = r * stride;
    (i < 3 ? by.d[i] : by.omega[i - 3]) = (carried[at] + direct[at] + error[at]) / bounds.scale[r];
  }
  bound_gap_back(bounds.gaps[g], bounds.lead_back, given, by);
  for (int i = 0; i < kSpaceGapSize; ++i) {
    const int r = kSpaceGapSize * g + i;
    const int at = r * stride;
    carried[at] = (i < 3 ? by.d[i] : by.omega[i - 3]) * bounds.scale[r];
    direct[at] = 0;
    error[at] = 0;
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
