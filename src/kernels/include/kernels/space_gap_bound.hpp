#pragma once

// (20) of docs/model.md for one gap in space, (d, ω), and its derivative: the length of d, the size
// of the bend (ω_y, ω_z) and the twist ω_x each stay within what was recorded.

#include "gap_bound.hpp"

namespace limber {
namespace {

/// A gap's numbers, in the order that states have them.
template <class Scalar>
struct SpaceGap {
  Scalar d[3];
  Scalar omega[3];
};

template <class Scalar>
inline Scalar square_of_length(const SpaceGap<Scalar>& gap) {
  return gap.d[0] * gap.d[0] + gap.d[1] * gap.d[1] + gap.d[2] * gap.d[2];
}
template <class Scalar>
inline Scalar square_of_bend(const SpaceGap<Scalar>& gap) {
  return gap.omega[1] * gap.omega[1] + gap.omega[2] * gap.omega[2];
}

template <class Scalar>
inline bool is_within(const GapBound<Scalar>& bound, const SpaceGap<Scalar>& gap) {
  const Scalar square = square_of_length(gap);
  return square >= bound.min_square && square <= bound.max_square &&
         square_of_bend(gap) <= bound.max_bend * bound.max_bend && gap.omega[0] >= bound.min_turn &&
         gap.omega[0] <= bound.max_turn;
}

template <class Scalar>
inline void bound_gap(const GapBound<Scalar>& bound, SpaceGap<Scalar>& gap) {
  const Scalar far = static_cast<Scalar>(kFarthestStep_m);
  for (int i = 0; i < 3; ++i) {
    gap.d[i] = clamped(gap.d[i], -far, far);
    gap.omega[i] = clamped(gap.omega[i], -far, far);
  }
  gap.omega[0] = clamped(gap.omega[0], bound.min_turn, bound.max_turn);
  const Scalar bend = square_of_bend(gap);
  if (bend > bound.max_bend * bound.max_bend) {
    const Scalar ratio = bound.max_bend / root_of(bend);
    gap.omega[1] *= ratio;
    gap.omega[2] *= ratio;
  }
  const Scalar square = square_of_length(gap);
  if (square >= bound.min_square && square <= bound.max_square) {
    return;
  }
  if (square < static_cast<Scalar>(kShortestSquare)) {
    gap.d[0] = bound.min_length;
    gap.d[1] = gap.d[2] = 0;
    return;
  }
  const Scalar ratio =
      (square < bound.min_square ? bound.min_length : bound.max_length) / root_of(square);
  for (Scalar& number : gap.d) {
    number *= ratio;
  }
}

/// The gradient `by` of what was held at `ratio` times its size: the part across is scaled, that
/// along is left out, but for what a descent would lead back.
template <class Scalar>
inline void held_back(const Scalar* x, int count, Scalar square, Scalar ratio, bool lead_back,
                      bool too_small, Scalar* by) {
  Scalar along = 0;
  for (int i = 0; i < count; ++i) {
    along += x[i] * by[i] / square;
  }
  const bool is_led_back = lead_back && (too_small ? along < 0 : along > 0);
  const Scalar kept = is_led_back ? along : Scalar(0);
  for (int i = 0; i < count; ++i) {
    by[i] = ratio * (by[i] - along * x[i]) + kept * x[i];
  }
}

/// As bound_gap_back of gap_bound.hpp. @param gap  before bounding
template <class Scalar>
inline void bound_gap_back(const GapBound<Scalar>& bound, bool lead_back,
                           const SpaceGap<Scalar>& gap, SpaceGap<Scalar>& by) {
  const Scalar twist = gap.omega[0];
  const bool is_turned_back = twist < bound.min_turn ? by.omega[0] < 0 : by.omega[0] > 0;
  if ((twist < bound.min_turn || twist > bound.max_turn) && !(lead_back && is_turned_back)) {
    by.omega[0] = 0;
  }
  const Scalar bend = square_of_bend(gap);
  if (bend > bound.max_bend * bound.max_bend) {
    held_back(gap.omega + 1, 2, bend, bound.max_bend / root_of(bend), lead_back, false,
              by.omega + 1);
  }
  const Scalar square = square_of_length(gap);
  if (square >= bound.min_square && square <= bound.max_square) {
    return;
  }
  if (square < static_cast<Scalar>(kShortestSquare)) {
    by.d[0] = by.d[1] = by.d[2] = 0;
    return;
  }
  const bool too_small = square < bound.min_square;
  held_back(gap.d, 3, square, (too_small ? bound.min_length : bound.max_length) / root_of(square),
            lead_back, too_small, by.d);
}

}  // namespace
}  // namespace limber
