#pragma once

#include <Eigen/Core>

#include "limber/arm/pose_size.hpp"

namespace limber {

/// Error of a predicted backbone, Σ_j weight_j |predicted_j − recorded_j| (the paper's IV-C), and
/// its gradient with respect to the network's normalised state.
///
/// Entrywise, the state's own D numbers are compared. Chained, for states of gap poses, they are
/// first decoded and chained to poses about the arm's base. An error at the base then counts for
/// everything that it moves, as it does when the model is used.
///
/// In space gaps have 6 numbers and base poses 7. With p a plate's position and q its quaternion,
/// both from the base: p_{i+1} = p_i + R(q_i) d_i and q_{i+1} = q_i exp(ω_i). Signs of quaternions
/// follow from the chain, in what is compared with too.
template <class Scalar>
class FrameError {
 public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  FrameError() = default;
  /// Entrywise. @param weight  D numbers.
  explicit FrameError(Vector weight);
  /// Chained: gap poses are state ∘ scale + offset (D = 3(m − 1) numbers each), `weight` counts the
  /// 3(m − 1) base poses behind the base plate.
  FrameError(Vector weight, Vector scale, Vector offset, Dimension dimension = Dimension::plane);

  bool is_chained() const { return scale_.size() > 0; }
  const Vector& weight() const { return weight_; }
  const Vector& scale() const { return scale_; }
  const Vector& offset() const { return offset_; }

  /// The same in another precision.
  template <class Other>
  FrameError<Other> cast() const {
    return is_chained()
               ? FrameError<Other>(weight_.template cast<Other>(), scale_.template cast<Other>(),
                                   offset_.template cast<Other>(), dimension_)
               : FrameError<Other>(weight_.template cast<Other>());
  }

  /// Sum of the errors of `stride` windows, each times its `window_weight` (stride numbers), and
  /// its gradient. Number r of window j stands at [r·stride + j]: states (D rows), `target` what
  /// they are compared with, recorded states or recorded base poses without the base plate (3(m −
  /// 1) rows), gradient (D rows). `stride` is a multiple of the CPU's vector width in float.
  Scalar compute(int stride, const Scalar* state, const Scalar* target, const Scalar* window_weight,
                 Scalar* gradient);

 private:
  Dimension dimension_ = Dimension::plane;
  Vector weight_;
  Vector scale_;
  Vector offset_;
  Vector scratch_;
};

extern template class FrameError<float>;
extern template class FrameError<double>;

}  // namespace limber
