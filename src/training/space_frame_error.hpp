#pragma once

// Frame errors of arms in space (FrameError in limber/training/frame_error.hpp has the equations):
// N is a vector of floats, one lane a window, or double.

#include "kernels/space_chain.hpp"
#include "limber/arm/pose_size.hpp"

namespace limber {
namespace {

/// Numbers of scratch per gap and lane: its rotation before, and what its pose's error leads to.
constexpr int kSpaceScratch = 4 + kSpacePoseSize;

/// How N is read and written, and compared: `load(p)`, `store(p, n)`, `all(float)` and
/// `signed_weight(difference, weight)`; `kLanesOfN` numbers lie side by side.
template <class N, class Access, class Scalar>
struct SpaceChainedError {
  int gaps, stride;
  const Scalar* weight;  ///< kSpacePoseSize a gap
  const Scalar* scale;   ///< kSpaceGapSize a gap
  const Scalar* offset;
  const Scalar* state;
  const Scalar* target;
  N window_weight;
  Scalar* gradient;
  Scalar* scratch;

  N number(int row) const {
    return Access::load(state + row * stride) * Access::all(scale[row]) + Access::all(offset[row]);
  }
  Vector3<N> three(int row) const { return {number(row), number(row + 1), number(row + 2)}; }
  Scalar* kept(int gap, int i) const {
    return scratch + (kSpaceScratch * gap + i) * Access::kLanesOfN;
  }

  N compare(int gap, int i, const N& predicted) const {
    const int row = kSpacePoseSize * gap + i;
    const N factor = Access::all(weight[row]);
    const N difference = predicted - Access::load(target + row * stride);
    const N by = Access::signed_weight(difference, factor);
    Access::store(kept(gap, 4 + i), by * window_weight);
    return by * difference;
  }

  N forward() const {
    Vector3<N> p{};
    Quaternion<N> q{Access::all(1), {}};
    N error{};
    for (int g = 0; g < gaps; ++g) {
      Access::store(kept(g, 0), q.w);
      Access::store(kept(g, 1), q.v.x);
      Access::store(kept(g, 2), q.v.y);
      Access::store(kept(g, 3), q.v.z);
      p = p + rotated(q, three(kSpaceGapSize * g));
      q = product(q, rotation_of(three(kSpaceGapSize * g + 3)));
      error = error + compare(g, 0, p.x) + compare(g, 1, p.y) + compare(g, 2, p.z) +
              compare(g, 3, q.v.x) + compare(g, 4, q.v.y) + compare(g, 5, q.v.z) +
              compare(g, 6, q.w);
    }
    return error;
  }

  void put(int row, const Vector3<N>& by) const {
    Access::store(gradient + row * stride, by.x * Access::all(scale[row]));
    Access::store(gradient + (row + 1) * stride, by.y * Access::all(scale[row + 1]));
    Access::store(gradient + (row + 2) * stride, by.z * Access::all(scale[row + 2]));
  }

  /// ∂/∂ω, from that by the rotation of ω.
  static Vector3<N> by_vector(const Vector3<N>& omega, const Quaternion<N>& by) {
    const N u = dot(omega, omega);
    const N half_sine = polynomial(kSineOfHalf, u);
    const N slope = polynomial_slope(kSineOfHalf, u);
    const N along = dot(by.v, omega) * (slope + slope) - by.w * half_sine * Access::all(0.5F);
    return half_sine * by.v + along * omega;
  }

  /// ∂/∂q of R(q)d · by.
  static Quaternion<N> by_rotation(const Quaternion<N>& q, const Vector3<N>& d,
                                   const Vector3<N>& by) {
    const N two = Access::all(2);
    const Vector3<N> of_w = cross(q.v, d);
    const Vector3<N> of_v =
        q.w * cross(d, by) + dot(q.v, by) * d + dot(q.v, d) * by - (two * dot(d, by)) * q.v;
    return {two * dot(of_w, by), two * of_v};
  }

  void backward() const {
    Vector3<N> by_p{};
    Quaternion<N> by_q{};
    const auto at = [&](int g, int i) { return Access::load(kept(g, i)); };
    for (int g = gaps - 1; g >= 0; --g) {
      const Quaternion<N> q = {at(g, 0), {at(g, 1), at(g, 2), at(g, 3)}};
      by_p = by_p + Vector3<N>{at(g, 4), at(g, 5), at(g, 6)};
      by_q = by_q + Quaternion<N>{at(g, 10), {at(g, 7), at(g, 8), at(g, 9)}};
      const Vector3<N> d = three(kSpaceGapSize * g);
      const Vector3<N> omega = three(kSpaceGapSize * g + 3);
      put(kSpaceGapSize * g, rotated(conjugate(q), by_p));
      put(kSpaceGapSize * g + 3, by_vector(omega, product(conjugate(q), by_q)));
      by_q = product(by_q, conjugate(rotation_of(omega))) + by_rotation(q, d, by_p);
    }
  }
};

}  // namespace
}  // namespace limber
