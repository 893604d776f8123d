#pragma once

#include <Eigen/Core>

namespace limber {

/// Error of a predicted backbone, Σ_j weight_j |predicted_j − recorded_j| (the paper's IV-C), and
/// its gradient with respect to the network's normalised state.
///
/// Entrywise, the state's own D numbers are compared. Chained, for states of gap poses, they are
/// first decoded and chained to poses about the arm's base: there an error at the base counts by
/// all that it moves, as it does for whoever uses the model.
template <class Scalar>
class FrameError {
 public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  FrameError() = default;
  /// Entrywise. @param weight  D numbers.
  explicit FrameError(Vector weight);
  /// Chained: gap poses are state ∘ scale + offset (D = 3(m − 1) numbers each), `weight` counts the
  /// 3(m − 1) base poses behind the base plate.
  FrameError(Vector weight, Vector scale, Vector offset);

  bool is_chained() const { return scale_.size() > 0; }

  /// The same in another precision.
  template <class Other>
  FrameError<Other> cast() const {
    return is_chained()
               ? FrameError<Other>(weight_.template cast<Other>(), scale_.template cast<Other>(),
                                   offset_.template cast<Other>())
               : FrameError<Other>(weight_.template cast<Other>());
  }

  /// Errors of `columns` states (D each, one after another) against what `target` holds: recorded
  /// states, or recorded base poses without the base plate (3(m − 1) each). Writes the gradient
  /// (D each).
  Scalar compute(int columns, const Scalar* state, const Scalar* target, Scalar* gradient);

 private:
  Scalar compute_chained(const Scalar* state, const Scalar* target, Scalar* gradient);

  Vector weight_;
  Vector scale_;
  Vector offset_;
  Vector gap_;      ///< D: decoded gap poses of one column
  Vector heading_;  ///< m − 1: of the plate that a gap begins at
  Vector sine_;     ///< m − 1
  Vector cosine_;   ///< m − 1
  Vector sign_;     ///< D: weight ∘ sign(error) of the base poses
};

extern template class FrameError<float>;
extern template class FrameError<double>;

}  // namespace limber
