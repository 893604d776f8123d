#pragma once

#include <span>

#include <Eigen/Core>

#include "limber/training/frame_error.hpp"
#include "limber/training/parameter_layout.hpp"

namespace limber {

/// Training data as the network sees them, one column a frame, normalised. n segments, D numbers a
/// backbone, N numbers of the unloaded backbone among the inputs (network/backbone_layout.hpp).
template <class Scalar>
struct FrameTable {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix pressure;       ///< n×F
  Matrix no_load;        ///< N×F, B̃ as the network reads it
  Matrix uncompensated;  ///< D×F, the state that a network output of zero would give
  Matrix state;          ///< D×F, recorded backbones
  Matrix target;         ///< D×F, what the frame error compares with; empty: `state`

  const Matrix& targets() const { return target.size() > 0 ? target : state; }
};

/// (5) in normalised numbers: state_t = uncompensated_t + output_scale ∘ y_t, with y_t the
/// network's output.
template <class Scalar>
struct StateMap {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  Vector output_scale;  ///< D
  FrameError<Scalar> error;
};

/// Loss and gradient over a chunk of windows: the network is rolled over each window with its own
/// output fed back, and the error of every frame is propagated back through all frames before it
/// (the paper's IV-C).
///
/// Sizes: windows of T frames, at most C of them at a time. Column k·c + j of the buffers is frame
/// k of window j, c the windows loaded. Threads: one thread, one object; it allocates nothing after
/// construction beyond what the matrix product itself may.
template <class Scalar>
class WindowGradient {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// @param layout  2n + D + N inputs (q_{t−1}, q_t, B_{t−1}, B̃_t), D outputs.
  WindowGradient(const ParameterLayout& layout, const StateMap<Scalar>& map, int segment_count,
                 int window_frames, int window_limit);

  /// Takes windows that start from the recorded backbone of frames `starts` and predict the T
  /// frames after it. @pre starts.size() ≤ window_limit; start + T < F.
  void load(const FrameTable<Scalar>& frames, std::span<const int> starts);

  /// Adds to the first backbones of the windows loaded (D × window_limit; the first columns are
  /// used).
  void disturb(const Matrix& noise);

  /// Sum over the windows of the mean over their frames of the frame error.
  double forward(const Vector& parameters);

  /// Gradient of `forward`'s last result, written to `gradient` (layout.size()).
  void backward(const Vector& parameters, Vector& gradient);

  /// Predicted states of frame k after `forward`, D × windows.
  Eigen::Ref<const Matrix> predicted(int frame) const;

 private:
  Eigen::Index column(int frame) const { return Eigen::Index(frame) * windows_; }
  void forward_layers(const Vector& parameters, int frame);
  void backward_frame(const Vector& parameters, int frame);
  void weight_gradients(Vector& gradient) const;
  const Matrix& layer_input(int layer) const;

  ParameterLayout layout_;
  StateMap<Scalar> map_;
  int segments_;
  int frames_;
  int window_limit_;
  int windows_ = 0;
  Matrix input_;                ///< (2n+D+N) × TC
  std::vector<Matrix> hidden_;  ///< outputs of the hidden layers, units × TC
  std::vector<Matrix> delta_;   ///< ∂loss/∂(layer's output before ReLU), a layer each
  Matrix target_;               ///< D × TC
  Matrix uncompensated_;        ///< D × TC
  Matrix state_;                ///< D × TC, predicted
  Matrix state_gradient_;       ///< D × C, ∂loss/∂state, carried from frame to frame
  Matrix error_gradient_;       ///< D × TC, ∂(frame error)/∂state
};

extern template class WindowGradient<float>;
extern template class WindowGradient<double>;

}  // namespace limber
