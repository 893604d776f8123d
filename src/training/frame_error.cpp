#include "limber/training/frame_error.hpp"

#include <cassert>

#include "limber/arm/pose_size.hpp"
#include "space_frame_error.hpp"
#include "training_kernels.hpp"

namespace limber {

template <class Scalar>
FrameError<Scalar>::FrameError(Vector weight) : weight_(std::move(weight)) {}

template <class Scalar>
FrameError<Scalar>::FrameError(Vector weight, Vector scale, Vector offset, Dimension dimension)
    : dimension_(dimension),
      weight_(std::move(weight)),
      scale_(std::move(scale)),
      offset_(std::move(offset)) {
  const Eigen::Index gaps = scale_.size() / gap_size(dimension);
  assert(gaps > 0 && scale_.size() == gaps * gap_size(dimension) &&
         offset_.size() == scale_.size() && weight_.size() == gaps * pose_size(dimension));
  const int kept = dimension == Dimension::space ? kSpaceScratch : 2;
  scratch_.resize(kept * gaps * window_kernels<Scalar>().lanes);
}

// Chained, forward along the arm: p_{i+1} = p_i + R(θ_i) d_i, θ_{i+1} = θ_i + a_i. Back from its
// tip, with G the derivative by a plate's pose and all that follows from it: ∂/∂d_i = R(θ_i)ᵀ G_p,
// ∂/∂a_i = G_θ, and θ_i also turns the gap's step w about p_i: (−w_y, w_x)·G_p.
template <class Scalar>
Scalar FrameError<Scalar>::compute(int stride, const Scalar* state, const Scalar* target,
                                   const Scalar* window_weight, Scalar* gradient) {
  const WindowKernels<Scalar>& kernels = window_kernels<Scalar>();
  assert(stride % kernels.lanes == 0);
  const int size = int(weight_.size());
  if (is_chained()) {
    const auto chained_error =
        dimension_ == Dimension::space ? kernels.space_chained_error : kernels.chained_error;
    return chained_error(size / pose_size(dimension_), stride, weight_.data(), scale_.data(),
                         offset_.data(), state, target, window_weight, gradient, scratch_.data());
  }
  return kernels.entry_error(size, stride, weight_.data(), state, target, window_weight, gradient);
}

template class FrameError<float>;
template class FrameError<double>;

}  // namespace limber
