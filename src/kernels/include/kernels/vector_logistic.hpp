#pragma once

// The logistic function of a whole vector at once (Cephes' expf).

#include "kernels/vector_sincos.hpp"

namespace limber {
namespace {

// eˣ within 2e-7 of itself, for |x| ≤ 87.
inline Vector exponential(Vector x) {
  // x = n·ln 2 + r, |r| ≤ ln 2 / 2; ln 2 in two parts so that the subtraction loses nothing.
  const Vector n = round_to_integer(x * broadcast(1.44269504F));
  Vector r = multiply_add(n, broadcast(-0.693359375F), x);
  r = multiply_add(n, broadcast(2.12194440e-4F), r);
  Vector p = multiply_add(r, broadcast(1.9875691500e-4F), broadcast(1.3981999507e-3F));
  p = multiply_add(p, r, broadcast(8.3334519073e-3F));
  p = multiply_add(p, r, broadcast(4.1665795894e-2F));
  p = multiply_add(p, r, broadcast(1.6666665459e-1F));
  p = multiply_add(p, r, broadcast(5.0000001201e-1F));
  p = multiply_add(p, r * r, r + broadcast(1.0F));
  const IntVector power = (whole_number(n) + 127) << 23;
  return p * reinterpret_cast<Vector>(power);
}

// 1 / (1 + e⁻ˣ); NaN stays NaN.
inline Vector logistic(Vector x) {
  constexpr float kFlat = 80.0F;  // beyond, it is 0 or 1 to the last bit that counts
  const Vector low = select(x < broadcast(-kFlat), broadcast(-kFlat), x);
  const Vector clamped = select(low > broadcast(kFlat), broadcast(kFlat), low);
  return broadcast(1.0F) / (broadcast(1.0F) + exponential(-clamped));
}

}  // namespace
}  // namespace limber
