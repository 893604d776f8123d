#pragma once

// (20) of docs/model.md for one gap, and its derivative, in one place for the forward model and for
// training. Like all kernels it calls nothing of the standard library.

namespace limber {

/// What one gap's shape stays within. In space a turn is its twist, and its bend has a bound too.
template <class Scalar>
struct GapBound {
  Scalar min_length;  ///< [m], > 0
  Scalar max_length;
  Scalar min_square;  ///< of the lengths
  Scalar max_square;
  Scalar min_turn;  ///< [rad]
  Scalar max_turn;
  Scalar max_bend;  ///< [rad], in space
};

template <class Scalar>
inline GapBound<Scalar> gap_bound(Scalar min_length, Scalar max_length, Scalar min_turn,
                                  Scalar max_turn, Scalar max_bend = 0) {
  return {min_length, max_length, min_length * min_length, max_length * max_length, min_turn,
          max_turn,   max_bend};
}

namespace {

inline float root_of(float x) {
  return __builtin_sqrtf(x);
}
inline double root_of(double x) {
  return __builtin_sqrt(x);
}

template <class Scalar>
inline Scalar clamped(Scalar x, Scalar low, Scalar high) {
  return x < low ? low : x > high ? high : x;  // a NaN stays one
}

constexpr float kFarthestStep_m = 1e6F;    // so that squares stay finite
constexpr float kShortestSquare = 1e-12F;  // a gap shorter than 1 µm has no direction

/// Keeps a gap's step (x, y) at its length's bound along its direction, and its turn at its own.
template <class Scalar>
inline void bound_gap(const GapBound<Scalar>& bound, Scalar& x, Scalar& y, Scalar& turn) {
  turn = clamped(turn, bound.min_turn, bound.max_turn);
  const Scalar far = static_cast<Scalar>(kFarthestStep_m);
  x = clamped(x, -far, far);
  y = clamped(y, -far, far);
  const Scalar square = x * x + y * y;
  if (square >= bound.min_square && square <= bound.max_square) {
    return;
  }
  if (square < static_cast<Scalar>(kShortestSquare)) {
    x = bound.min_length;
    y = 0;
    return;
  }
  const Scalar length = square < bound.min_square ? bound.min_length : bound.max_length;
  const Scalar ratio = length / root_of(square);
  x *= ratio;
  y *= ratio;
}

/// From a loss's gradient by the bounded gap to that by the gap (x, y, turn) before bounding. What
/// is held has no derivative: of a step only the part across its direction is left. With
/// `lead_back` the part that a descent would follow back within the bound is kept as it is. Without
/// it, a network that runs into a bound early in its training never leaves it again.
template <class Scalar>
inline void bound_gap_back(const GapBound<Scalar>& bound, bool lead_back, Scalar x, Scalar y,
                           Scalar turn, Scalar& by_x, Scalar& by_y, Scalar& by_turn) {
  const bool is_turned_back = turn < bound.min_turn ? by_turn < 0 : by_turn > 0;
  if ((turn < bound.min_turn || turn > bound.max_turn) && !(lead_back && is_turned_back)) {
    by_turn = 0;
  }
  const Scalar square = x * x + y * y;
  if (square >= bound.min_square && square <= bound.max_square) {
    return;
  }
  if (square < static_cast<Scalar>(kShortestSquare)) {
    by_x = 0;
    by_y = 0;
    return;
  }
  const Scalar length = square < bound.min_square ? bound.min_length : bound.max_length;
  const Scalar ratio = length / root_of(square);
  const Scalar along = (x * by_x + y * by_y) / square;
  const bool is_led_back = lead_back && (square < bound.min_square ? along < 0 : along > 0);
  const Scalar kept = is_led_back ? along : Scalar(0);
  by_x = ratio * (by_x - along * x) + kept * x;
  by_y = ratio * (by_y - along * y) + kept * y;
}

}  // namespace
}  // namespace limber
