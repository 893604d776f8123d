#include "limber/training/window_gradient.hpp"

#include <cassert>

#include "layer_kernels.hpp"

namespace limber {

template <class Scalar>
WindowGradient<Scalar>::WindowGradient(const ParameterLayout& layout, const StateMap<Scalar>& map,
                                       int segment_count, int window_frames, int window_limit)
    : layout_(layout),
      map_(map),
      segments_(segment_count),
      frames_(window_frames),
      window_limit_(window_limit) {
  const Eigen::Index size = map.output_scale.size();
  const Eigen::Index columns = Eigen::Index(window_frames) * window_limit;
  assert(layout.inputs(0) >= 2 * segment_count + size);
  assert(layout.outputs(layout.layer_count() - 1) == size);
  input_.resize(layout.inputs(0), columns);
  for (int layer = 0; layer < layout.layer_count(); ++layer) {
    delta_.emplace_back(layout.outputs(layer), columns);
    if (layer + 1 < layout.layer_count()) {
      hidden_.emplace_back(layout.outputs(layer), columns);
    }
  }
  target_.resize(size, columns);
  uncompensated_.resize(size, columns);
  state_.resize(size, columns);
  error_gradient_.resize(size, columns);
  state_gradient_.resize(size, window_limit);
}

template <class Scalar>
void WindowGradient<Scalar>::load(const FrameTable<Scalar>& frames, std::span<const int> starts) {
  assert(static_cast<int>(starts.size()) <= window_limit_);
  windows_ = static_cast<int>(starts.size());
  const Eigen::Index n = segments_;
  const Eigen::Index size = target_.rows();
  for (int k = 0; k < frames_; ++k) {
    for (int j = 0; j < windows_; ++j) {
      const Eigen::Index frame = starts[static_cast<std::size_t>(j)] + k;
      const Eigen::Index c = column(k) + j;
      input_.col(c).segment(0, n) = frames.pressure.col(frame);
      input_.col(c).segment(n, n) = frames.pressure.col(frame + 1);
      input_.col(c).tail(frames.no_load.rows()) = frames.no_load.col(frame + 1);
      uncompensated_.col(c) = frames.uncompensated.col(frame + 1);
      target_.col(c) = frames.targets().col(frame + 1);
      if (k == 0) {
        input_.col(c).segment(2 * n, size) = frames.state.col(frame);
      }
    }
  }
}

template <class Scalar>
void WindowGradient<Scalar>::disturb(const Matrix& noise) {
  input_.block(2 * segments_, 0, target_.rows(), windows_) += noise.leftCols(windows_);
}

template <class Scalar>
const typename WindowGradient<Scalar>::Matrix& WindowGradient<Scalar>::layer_input(
    int layer) const {
  return layer == 0 ? input_ : hidden_[static_cast<std::size_t>(layer) - 1];
}

template <class Scalar>
void WindowGradient<Scalar>::forward_layers(const Vector& parameters, int frame) {
  const Eigen::Index first = column(frame);
  const int last = layout_.layer_count() - 1;
  for (int layer = 0; layer <= last; ++layer) {
    Matrix& output = layer == last ? state_ : hidden_[static_cast<std::size_t>(layer)];
    const int m = layout_.outputs(layer);
    const int k = layout_.inputs(layer);
    LayerKernels<Scalar>::layer(m, windows_, k, parameters.data() + layout_.weight_offset(layer), m,
                                layer_input(layer).col(first).data(), k,
                                parameters.data() + layout_.bias_offset(layer), layer < last,
                                output.col(first).data(), m);
  }
}

template <class Scalar>
double WindowGradient<Scalar>::forward(const Vector& parameters) {
  const Eigen::Index size = target_.rows();
  const Eigen::Index state_row = 2 * segments_;
  double loss = 0.0;
  for (int k = 0; k < frames_; ++k) {
    if (k > 0) {
      input_.block(state_row, column(k), size, windows_) =
          state_.middleCols(column(k - 1), windows_);
    }
    forward_layers(parameters, k);
    auto state = state_.middleCols(column(k), windows_);
    state.array().colwise() *= map_.output_scale.array();
    state += uncompensated_.middleCols(column(k), windows_);
    loss += static_cast<double>(map_.error.compute(windows_, state.data(),
                                                   target_.col(column(k)).data(),
                                                   error_gradient_.col(column(k)).data()));
  }
  return loss / frames_;
}

template <class Scalar>
void WindowGradient<Scalar>::backward_frame(const Vector& parameters, int frame) {
  using Kernels = LayerKernels<Scalar>;
  const Eigen::Index first = column(frame);
  auto carried = state_gradient_.leftCols(windows_);
  carried += error_gradient_.middleCols(first, windows_) / Scalar(frames_);
  delta_.back().middleCols(first, windows_) =
      (carried.array().colwise() * map_.output_scale.array()).matrix();
  for (int layer = layout_.layer_count() - 1; layer > 0; --layer) {
    const auto below = static_cast<std::size_t>(layer) - 1;
    const int m = layout_.inputs(layer);
    const int k = layout_.outputs(layer);
    Scalar* gradient = delta_[below].col(first).data();
    Kernels::tn(m, windows_, k, parameters.data() + layout_.weight_offset(layer), k,
                delta_[below + 1].col(first).data(), k, gradient, m);
    Kernels::relu_gradient(m, windows_, hidden_[below].col(first).data(), m, gradient, m);
  }
  if (frame > 0) {
    // Only the columns of the first weight that read B_{t−1} lead back in time.
    const int k = layout_.outputs(0);
    const Eigen::Index skipped = Eigen::Index(2 * segments_) * k;
    const int size = static_cast<int>(target_.rows());
    Kernels::tn(size, windows_, k, parameters.data() + layout_.weight_offset(0) + skipped, k,
                delta_.front().col(first).data(), k, state_gradient_.data(), size);
  }
}

template <class Scalar>
void WindowGradient<Scalar>::weight_gradients(Vector& gradient) const {
  const int count = frames_ * windows_;
  for (int layer = 0; layer < layout_.layer_count(); ++layer) {
    const Matrix& delta = delta_[static_cast<std::size_t>(layer)];
    const int m = layout_.outputs(layer);
    const int n = layout_.inputs(layer);
    LayerKernels<Scalar>::nt(m, n, count, delta.data(), m, layer_input(layer).data(), n,
                             gradient.data() + layout_.weight_offset(layer), m);
    LayerKernels<Scalar>::row_sums(m, count, delta.data(), m,
                                   gradient.data() + layout_.bias_offset(layer));
  }
}

template <class Scalar>
void WindowGradient<Scalar>::backward(const Vector& parameters, Vector& gradient) {
  assert(gradient.size() == layout_.size());
  state_gradient_.setZero();
  for (int k = frames_ - 1; k >= 0; --k) {
    backward_frame(parameters, k);
  }
  weight_gradients(gradient);
}

template <class Scalar>
Eigen::Ref<const typename WindowGradient<Scalar>::Matrix> WindowGradient<Scalar>::predicted(
    int frame) const {
  return state_.middleCols(column(frame), windows_);
}

template class WindowGradient<float>;
template class WindowGradient<double>;

}  // namespace limber
