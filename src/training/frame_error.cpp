#include "limber/training/frame_error.hpp"

#include <cassert>
#include <cmath>

#include "layer_kernels.hpp"

namespace limber {

template <class Scalar>
FrameError<Scalar>::FrameError(Vector weight) : weight_(std::move(weight)) {}

template <class Scalar>
FrameError<Scalar>::FrameError(Vector weight, Vector scale, Vector offset)
    : weight_(std::move(weight)), scale_(std::move(scale)), offset_(std::move(offset)) {
  const Eigen::Index size = scale_.size();
  assert(size > 0 && size % 3 == 0 && weight_.size() == size && offset_.size() == size);
  gap_.resize(size);
  sign_.resize(size);
  heading_.resize(size / 3);
  sine_.resize(size / 3);
  cosine_.resize(size / 3);
}

template <class Scalar>
Scalar FrameError<Scalar>::compute(int columns, const Scalar* state, const Scalar* target,
                                   Scalar* gradient) {
  const Eigen::Index size = weight_.size();
  Scalar sum = 0;
  if (is_chained()) {
    for (int c = 0; c < columns; ++c) {
      sum += compute_chained(state + c * size, target + c * size, gradient + c * size);
    }
    return sum;
  }
  for (int c = 0; c < columns; ++c) {
    const Eigen::Map<const Vector> predicted(state + c * size, size);
    const Eigen::Map<const Vector> recorded(target + c * size, size);
    const auto error = (predicted - recorded).array();
    sum += (error.abs() * weight_.array()).sum();
    Eigen::Map<Vector>(gradient + c * size, size) = error.sign() * weight_.array();
  }
  return sum;
}

// Forward along the arm: p_{i+1} = p_i + R(θ_i) d_i, θ_{i+1} = θ_i + a_i. Back from its tip, with G
// the derivative by a plate's pose and all that follows from it: ∂/∂d_i = R(θ_i)ᵀ G_p, ∂/∂a_i =
// G_θ, and θ_i also turns the gap's step w about p_i: (−w_y, w_x)·G_p.
template <class Scalar>
Scalar FrameError<Scalar>::compute_chained(const Scalar* state, const Scalar* target,
                                           Scalar* gradient) {
  const Eigen::Index gaps = heading_.size();
  gap_ = Eigen::Map<const Vector>(state, 3 * gaps).cwiseProduct(scale_) + offset_;
  Scalar theta = 0;
  for (Eigen::Index i = 0; i < gaps; ++i) {
    heading_[i] = theta;
    theta += gap_[3 * i + 2];
  }
  LayerKernels<Scalar>::sincos(static_cast<int>(gaps), heading_.data(), sine_.data(),
                               cosine_.data());
  Scalar x = 0;
  Scalar y = 0;
  Scalar sum = 0;
  const auto compare = [&](Eigen::Index j, Scalar predicted) {
    const Scalar error = predicted - target[j];
    sum += weight_[j] * std::abs(error);
    sign_[j] = error == 0 ? Scalar(0) : std::copysign(weight_[j], error);
  };
  for (Eigen::Index i = 0; i < gaps; ++i) {
    x += cosine_[i] * gap_[3 * i] - sine_[i] * gap_[3 * i + 1];
    y += sine_[i] * gap_[3 * i] + cosine_[i] * gap_[3 * i + 1];
    compare(3 * i, x);
    compare(3 * i + 1, y);
    compare(3 * i + 2, heading_[i] + gap_[3 * i + 2]);
  }
  Scalar by_x = 0;
  Scalar by_y = 0;
  Scalar by_theta = 0;
  for (Eigen::Index i = gaps - 1; i >= 0; --i) {
    by_x += sign_[3 * i];
    by_y += sign_[3 * i + 1];
    by_theta += sign_[3 * i + 2];
    // In the frame of the gap's first plate.
    const Scalar along = cosine_[i] * by_x + sine_[i] * by_y;
    const Scalar across = cosine_[i] * by_y - sine_[i] * by_x;
    gradient[3 * i] = along * scale_[3 * i];
    gradient[3 * i + 1] = across * scale_[3 * i + 1];
    gradient[3 * i + 2] = by_theta * scale_[3 * i + 2];
    by_theta += gap_[3 * i] * across - gap_[3 * i + 1] * along;
  }
  return sum;
}

template class FrameError<float>;
template class FrameError<double>;

}  // namespace limber
