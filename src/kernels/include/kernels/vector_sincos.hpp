#pragma once

// Sine and cosine of a whole vector at once (Cody and Waite's reduction, Cephes' sinf and cosf).

#include "kernels/vector_float.hpp"

namespace limber {
namespace {

inline Vector select(IntVector mask, Vector yes, Vector no) {
  return reinterpret_cast<Vector>((mask & reinterpret_cast<IntVector>(yes)) |
                                  (~mask & reinterpret_cast<IntVector>(no)));
}

// The integer that the vector of whole numbers v holds, for |v| < 2²².
inline IntVector whole_number(Vector v) {
  return __builtin_convertvector(v, IntVector);
}

// Within 2e-7 for |angle| ≤ 100 rad.
inline void sincos(Vector angle, Vector& sine, Vector& cosine) {
  // angle = quarter·π/2 + r, |r| ≤ π/4; π/2 in three parts so that the subtraction loses nothing.
  const Vector quarter = round_to_integer(angle * broadcast(0.636619772F));
  Vector r = multiply_add(quarter, broadcast(-1.5703125F), angle);
  r = multiply_add(quarter, broadcast(-4.837512969970703125e-4F), r);
  r = multiply_add(quarter, broadcast(-7.54978995489188216e-8F), r);
  const Vector square = r * r;

  Vector s = multiply_add(broadcast(-1.9515295891e-4F), square, broadcast(8.3321608736e-3F));
  s = multiply_add(s, square, broadcast(-1.6666654611e-1F));
  s = multiply_add(s * square, r, r);

  Vector c =
      multiply_add(broadcast(2.443315711809948e-5F), square, broadcast(-1.388731625493765e-3F));
  c = multiply_add(c, square, broadcast(4.166664568298827e-2F));
  c = multiply_add(c, square * square, multiply_add(broadcast(-0.5F), square, broadcast(1.0F)));

  // Quadrants 1 and 3 swap the two, 2 and 3 turn the sine's sign, 1 and 2 the cosine's.
  const IntVector quadrant = whole_number(quarter);
  const IntVector swap = -(quadrant & 1);
  const IntVector sine_sign = (quadrant & 2) << 30;
  const IntVector cosine_sign = ((quadrant + 1) & 2) << 30;
  sine = reinterpret_cast<Vector>(reinterpret_cast<IntVector>(select(swap, c, s)) ^ sine_sign);
  cosine = reinterpret_cast<Vector>(reinterpret_cast<IntVector>(select(swap, s, c)) ^ cosine_sign);
}

}  // namespace
}  // namespace limber
