#pragma once

// The strain of (3) and (25) for a vector of pressures, for the instruction set that the including
// file is compiled for (see kernels/vector_float.hpp).

#include "kernels/vector_float.hpp"
#include "row_kernels.hpp"

namespace limber {
namespace {

// e = P(|p|), along the end slope above the limit.
inline Vector strain_of(const StrainCurve& curve, Vector pressure) {
  const Vector limit = broadcast(curve.limit_kpa);
  const Vector p = absolute(pressure);
  Vector e = multiply_add(p, broadcast(curve.coefficient[3]), broadcast(curve.coefficient[2]));
  e = multiply_add(p, e, broadcast(curve.coefficient[1]));
  e = multiply_add(p, e, broadcast(curve.coefficient[0]));
  const Vector above =
      multiply_add(p - limit, broadcast(curve.slope_per_kpa), broadcast(curve.at_limit));
  return select(p > limit, above, p * e);
}

}  // namespace
}  // namespace limber
