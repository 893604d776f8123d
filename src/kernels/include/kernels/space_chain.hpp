#pragma once

// Poses in space for kernels: N is a vector of floats, one lane a query or a window, or double. All
// functions are entire: nothing branches, and a straight gap is like any other. As in all kernels
// nothing of the standard library is called.

namespace limber {
namespace {

template <class N>
struct Vector3 {
  N x, y, z;
};

template <class N>
inline Vector3<N> operator+(const Vector3<N>& a, const Vector3<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
inline Vector3<N> operator-(const Vector3<N>& a, const Vector3<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
inline Vector3<N> operator*(const N& s, const Vector3<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class N>
inline N dot(const Vector3<N>& a, const Vector3<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
inline Vector3<N> cross(const Vector3<N>& a, const Vector3<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class N>
struct Quaternion {
  N w;
  Vector3<N> v;
};

template <class N>
inline Quaternion<N> operator+(const Quaternion<N>& a, const Quaternion<N>& b) {
  return {a.w + b.w, a.v + b.v};
}
template <class N>
inline Quaternion<N> product(const Quaternion<N>& a, const Quaternion<N>& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
template <class N>
inline Quaternion<N> conjugate(const Quaternion<N>& q) {
  return {q.w, {-q.v.x, -q.v.y, -q.v.z}};
}
/// From the frame that q turns to into the frame that it is about.
template <class N>
inline Vector3<N> rotated(const Quaternion<N>& q, const Vector3<N>& d) {
  const Vector3<N> turned = cross(q.v, d);
  const Vector3<N> twice = turned + turned;
  return d + q.w * twice + cross(q.v, twice);
}

template <class N>
struct NumberIn {
  static inline N all(double x) { return N{} + float(x); }
};
template <>
struct NumberIn<double> {
  static inline double all(double x) { return x; }
};

/// Σ c_k u^k, and its derivative.
template <class N, int kCount>
inline N polynomial(const double (&c)[kCount], const N& u) {
  N sum = NumberIn<N>::all(c[kCount - 1]);
#pragma GCC unroll 16
  for (int k = kCount - 2; k >= 0; --k) {
    sum = sum * u + NumberIn<N>::all(c[k]);
  }
  return sum;
}
template <class N, int kCount>
inline N polynomial_slope(const double (&c)[kCount], const N& u) {
  N sum = NumberIn<N>::all((kCount - 1) * c[kCount - 1]);
#pragma GCC unroll 16
  for (int k = kCount - 2; k >= 1; --k) {
    sum = sum * u + NumberIn<N>::all(k * c[k]);
  }
  return sum;
}

// Over u = t², for |t| ≤ 4: ten terms of each series.
// cos(t/2)
constexpr double kCosineOfHalf[] = {1.0,
                                    -0.125,
                                    0.0026041666666666665,
                                    -2.170138888888889e-05,
                                    9.68812003968254e-08,
                                    -2.691144455467372e-10,
                                    5.096864498991235e-13,
                                    -7.001187498614334e-16,
                                    7.292903644389931e-19,
                                    -5.958254611429682e-22};
// sin(t/2)/t
constexpr double kSineOfHalf[] = {0.5,
                                  -0.020833333333333332,
                                  0.00026041666666666666,
                                  -1.5500992063492063e-06,
                                  5.382288910934745e-09,
                                  -1.2232474797578965e-11,
                                  1.9603324996120133e-14,
                                  -2.333729166204778e-17,
                                  2.1449716601146855e-20,
                                  -1.5679617398499164e-23};
// (1 − cos t)/t²
constexpr double kVersine[] = {0.5,
                               -0.041666666666666664,
                               0.001388888888888889,
                               -2.48015873015873e-05,
                               2.755731922398589e-07,
                               -2.08767569878681e-09,
                               1.1470745597729725e-11,
                               -4.779477332387385e-14,
                               1.5619206968586225e-16,
                               -4.110317623312165e-19};
// (t − sin t)/t³
constexpr double kSineRest[] = {
    0.16666666666666666,   -0.008333333333333333,   0.0001984126984126984, -2.7557319223985893e-06,
    2.505210838544172e-08, -1.6059043836821613e-10, 7.647163731819816e-13, -2.8114572543455206e-15,
    8.22063524662433e-18,  -1.9572941063391263e-20};
// t/sin(t/2) over 1 − cos(t/2), 0 ≤ t ≤ π: a Chebyshev fit, 5e-12 off at most.
constexpr double kAngleOverSine[] = {
    2.0000000000024656,   0.6666666655519524,    0.26666674966038045,  0.11428328945824828,
    0.050830543030608986, 0.022752082190072576,  0.01263841910152522,  -0.002979431089382435,
    0.02463341041050929,  -0.043114197052394373, 0.062491090343489014, -0.0599443946654598,
    0.038911732286214834, -0.014996304114659631, 0.002752998471260071};

/// The rotation by the rotation vector ω.
template <class N>
inline Quaternion<N> rotation_of(const Vector3<N>& omega) {
  const N u = dot(omega, omega);
  return {polynomial(kCosineOfHalf, u), polynomial(kSineOfHalf, u) * omega};
}

/// ω of a unit quaternion with w ≥ 0.
template <class N>
inline Vector3<N> rotation_vector_of(const Quaternion<N>& q) {
  return polynomial(kAngleOverSine, NumberIn<N>::all(1.0) - q.w) * q.v;
}

/// The end of an element of constant strain of this length that turns by ω = (0, y, z).
template <class N>
inline Vector3<N> element_end(const N& length, const N& omega_y, const N& omega_z) {
  const N u = omega_y * omega_y + omega_z * omega_z;
  const N versine = length * polynomial(kVersine, u);
  return {length - length * (u * polynomial(kSineRest, u)), versine * omega_z,
          -(versine * omega_y)};
}

}  // namespace
}  // namespace limber
