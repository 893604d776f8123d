#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limber/arm/pose_size.hpp"

namespace limber {

/// A pose in space: x along the straight arm, y left, z up. The planar arm is z = 0 with rotations
/// about z.
template <class Scalar>
struct SpacePoseOf {
  Eigen::Matrix<Scalar, 3, 1> position_m = Eigen::Matrix<Scalar, 3, 1>::Zero();
  Eigen::Quaternion<Scalar> rotation = Eigen::Quaternion<Scalar>::Identity();
};
using SpacePose = SpacePoseOf<double>;

// All of limber's arithmetic on single poses in space; the same stands over many queries in
// forward/space_row_kernels.hpp and over windows in training/space_frame_error.hpp.

/// The pose of kSpacePoseSize numbers.
template <class Derived>
SpacePoseOf<typename Derived::Scalar> space_pose_of(const Eigen::MatrixBase<Derived>& numbers) {
  using Scalar = typename Derived::Scalar;
  return {{numbers[0], numbers[1], numbers[2]},
          Eigen::Quaternion<Scalar>(numbers[6], numbers[3], numbers[4], numbers[5])};
}

template <class Scalar>
Eigen::Matrix<Scalar, kSpacePoseSize, 1> numbers_of(const SpacePoseOf<Scalar>& pose) {
  Eigen::Matrix<Scalar, kSpacePoseSize, 1> numbers;
  numbers << pose.position_m, pose.rotation.coeffs();
  return numbers;
}

/// Makes the rotations of poses, whose kSpacePoseSize numbers lie one after the other, unit
/// quaternions again: a mean of them is none.
template <class Matrix>
void normalise_rotations(Matrix& poses) {
  using Quaternion = Eigen::Matrix<typename Matrix::Scalar, 4, 1>;
  for (Eigen::Index i = position_size(Dimension::space); i < poses.size(); i += kSpacePoseSize) {
    Eigen::Map<Quaternion>(poses.data() + i).normalize();
  }
}

/// Makes the signs of quaternions continuous, since q and −q are one rotation: in the first row
/// from plate to plate, as if chained from the base, and of every plate from row to row.
/// @param frames  a row of poses for each frame
template <class Matrix>
void make_signs_continuous(Matrix& frames) {
  constexpr int kFirst = position_size(Dimension::space);
  using Quaternion = Eigen::Matrix<typename Matrix::Scalar, 1, 4>;
  for (Eigen::Index t = 0; t < frames.rows(); ++t) {
    for (Eigen::Index i = kFirst; i < frames.cols(); i += kSpacePoseSize) {
      const Quaternion near =
          t > 0        ? Quaternion(frames.row(t - 1).template segment<4>(i))
          : i > kFirst ? Quaternion(frames.row(t).template segment<4>(i - kSpacePoseSize))
                       : Quaternion(Quaternion::Unit(3));
      auto rotation = frames.row(t).template segment<4>(i);
      if (near.dot(rotation) < 0) {
        rotation = -rotation;
      }
    }
  }
}

/// Where `step`, a pose about `from`, lies in the frame of `from`.
template <class Scalar>
SpacePoseOf<Scalar> compose(const SpacePoseOf<Scalar>& from, const SpacePoseOf<Scalar>& step) {
  return {from.position_m + from.rotation * step.position_m, from.rotation * step.rotation};
}

/// The pose of `to` about `from`: compose(from, between(from, to)) is `to`.
template <class Scalar>
SpacePoseOf<Scalar> between(const SpacePoseOf<Scalar>& from, const SpacePoseOf<Scalar>& to) {
  const Eigen::Quaternion<Scalar> back = from.rotation.conjugate();
  return {back * (to.position_m - from.position_m), back * to.rotation};
}

/// The rotation vector (axis times angle, at most π) of a unit quaternion of either sign.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> rotation_vector(const Eigen::Quaternion<Scalar>& rotation) {
  const Scalar sign = rotation.w() < Scalar(0) ? Scalar(-1) : Scalar(1);
  const Scalar sine = rotation.vec().norm();
  const Scalar half = std::atan2(sine, sign * rotation.w());
  // sin(h)/h of a small angle is 1 to rounding.
  return rotation.vec() * (sign * (sine > Scalar(1e-12) ? Scalar(2) * half / sine : Scalar(2)));
}

/// sin(x)/x.
template <class Scalar>
Scalar sine_over(Scalar x) {
  const Scalar square = x * x;
  return square < Scalar(1e-6) ? Scalar(1) - square / 6 : std::sin(x) / x;
}

template <class Scalar>
Eigen::Quaternion<Scalar> rotation_of_vector(const Eigen::Matrix<Scalar, 3, 1>& vector) {
  const Scalar half = vector.norm() / 2;
  Eigen::Quaternion<Scalar> rotation;
  rotation.w() = std::cos(half);
  rotation.vec() = vector * (sine_over(half) / 2);
  return rotation;
}

/// The end of an element of constant strain of this length that turns by the rotation vector ω, in
/// the frame of its beginning: docs/model.md, (24).
template <class Scalar>
SpacePoseOf<Scalar> element(Scalar length_m, const Eigen::Matrix<Scalar, 3, 1>& omega) {
  const Scalar angle = omega.norm();
  const Scalar half = sine_over(angle / 2);
  const Scalar a = half * half / 2;  // (1 − cos t)/t²
  const Scalar square = angle * angle;
  const Scalar b = square < Scalar(1e-4) ? Scalar(1) / 6 - square / 120
                                         : (angle - std::sin(angle)) / (square * angle);
  const Eigen::Matrix<Scalar, 3, 1> along = Eigen::Matrix<Scalar, 3, 1>::UnitX();
  const Eigen::Matrix<Scalar, 3, 1> turned = omega.cross(along);
  return {length_m * (along + a * turned + b * omega.cross(turned)), rotation_of_vector(omega)};
}

/// The kSpaceGapSize numbers of a pose about the plate before, and back.
template <class Scalar>
Eigen::Matrix<Scalar, kSpaceGapSize, 1> gap_numbers_of(const SpacePoseOf<Scalar>& step) {
  Eigen::Matrix<Scalar, kSpaceGapSize, 1> numbers;
  numbers << step.position_m, rotation_vector(step.rotation);
  return numbers;
}
template <class Derived>
SpacePoseOf<typename Derived::Scalar> step_of_gap(const Eigen::MatrixBase<Derived>& numbers) {
  using Vector = Eigen::Matrix<typename Derived::Scalar, 3, 1>;
  const Vector omega(numbers[3], numbers[4], numbers[5]);
  return {{numbers[0], numbers[1], numbers[2]}, rotation_of_vector(omega)};
}

}  // namespace limber
