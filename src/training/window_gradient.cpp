#include "limber/training/window_gradient.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "limber/common/mapped.hpp"
#include "training_kernels.hpp"

namespace limber {

namespace {

constexpr int kGroupWindows = 32;  // two vectors of the widest kind: fast, and a small batch still
                                   // makes enough groups for all cores
constexpr int kGradientQueries = 512;  // whose deltas and inputs fit the second cache together

int group_stride(int window_limit, int lanes) {
  return std::min((window_limit + lanes - 1) / lanes * lanes, kGroupWindows);
}

template <class Scalar>
StateBoundsView<Scalar> view_of(const StateBounds<Scalar>& bounds) {
  return {int(bounds.gaps.size()),
          gap_size(bounds.dimension),
          bounds.layout == BackboneLayout::base_poses,
          bounds.lead_back,
          bounds.gaps.data(),
          bounds.scale.data(),
          bounds.offset.data()};
}

}  // namespace

template <class Scalar>
WindowGradient<Scalar>::WindowGradient(const ParameterLayout& layout, const StateMap<Scalar>& map,
                                       int segment_count, int window_frames, int window_limit)
    : kernels_(window_kernels<Scalar>()),
      layout_(layout),
      map_(map),
      segments_(segment_count),
      size_(int(map.output_scale.size())),
      frames_(window_frames),
      window_limit_(window_limit),
      stride_(group_stride(window_limit, kernels_.lanes)),
      slots_(std::max(kGradientQueries / stride_, 1)),
      growth_(map.growth_limit, stride_),
      modulation_(layout, kernels_, (window_limit + stride_ - 1) / stride_, stride_) {
  assert(layout.inputs(0) >= 2 * segment_count + size_ * (map.reads_velocity() ? 2 : 1));
  assert(layout.outputs(layout.layer_count() - 1) == map.output_count());
  const int groups = (window_limit + stride_ - 1) / stride_;
  const auto numbers = [&](int blocks, int rows) {
    return std::size_t(blocks) * std::size_t(rows * stride_);
  };
  const int blocks = groups * window_frames;
  for (int k = 0; k < window_frames; ++k) {
    frame_counts_.push_back(std::pow(k + 1.0, -map.first_frames_power));
  }
  index_.resize(groups * stride_);
  input_.resize(numbers(blocks, layout.inputs(0)));
  for (int layer = 0; layer < layout.layer_count(); ++layer) {
    delta_.emplace_back(numbers(slots_, layout.outputs(layer)));
    if (layer + 1 < layout.layer_count()) {
      hidden_.emplace_back(numbers(blocks, layout.outputs(layer)));
    }
  }
  target_size_ = int(map.error.weight().size());
  target_.resize(numbers(blocks, target_size_));
  uncompensated_.resize(numbers(blocks, size_));
  error_gradient_.resize(numbers(blocks, size_));
  weight_.resize(numbers(blocks, 1));
  output_.resize(numbers(1, map.output_count()));
  last_state_.resize(numbers(1, size_));
  carried_.resize(numbers(1, size_));
  direct_.resize(numbers(1, size_));
  changed_.resize(map.reads_velocity() ? numbers(1, size_) : 0);
  change_back_.resize(changed_.size());
  unbounded_.resize(map.is_bounded() ? numbers(blocks, size_) : 0);
  gate_.resize(map.is_gated() ? numbers(blocks, size_) : 0);
}

template <class Scalar>
void WindowGradient<Scalar>::load(const FrameTable<Scalar>& frames, std::span<const int> starts) {
  assert(!starts.empty() && int(starts.size()) <= window_limit_);
  windows_ = int(starts.size());
  groups_ = (windows_ + stride_ - 1) / stride_;
  std::copy(starts.begin(), starts.end(), index_.begin());
  std::fill(index_.begin() + windows_, index_.begin() + groups_ * stride_, starts.back());
  if (modulation_.is_on()) {
    modulation_.load(frames.arm, std::span(index_).first(groups_ * stride_));
  }
  for (int group = 0; group < groups_; ++group) {
    for (int k = 0; k < frames_; ++k) {
      load_block(frames, group, k);
    }
  }
  weigh(frames, starts);
}

// Leaves the group's index at the frame behind `frame`.
template <class Scalar>
void WindowGradient<Scalar>::load_block(const FrameTable<Scalar>& frames, int group, int frame) {
  const int block = block_of(group, frame);
  int* index = index_.data() + group * stride_;
  const auto gather = [&](const Matrix& table, Scalar* rows) {
    const int count = int(table.rows());
    kernels_.gather(count, stride_, table.data(), count, index, rows);
  };
  Scalar* input = at(input_, layout_.inputs(0), block);
  gather(frames.pressure, input);
  if (frame == 0) {
    gather(frames.state, input + 2 * segments_ * stride_);
    if (map_.reads_velocity()) {
      gather(frames.change, change(block));
    }
  }
  std::for_each(index, index + stride_, [](int& column) { ++column; });
  gather(frames.pressure, input + segments_ * stride_);
  gather(frames.no_load, input + (2 * segments_ + size_) * stride_);
  gather(frames.uncompensated, at(uncompensated_, size_, block));
  gather(frames.targets(), at(target_, target_size_, block));
}

template <class Scalar>
void WindowGradient<Scalar>::weigh(const FrameTable<Scalar>& frames, std::span<const int> starts) {
  std::fill(weight_.begin(), weight_.end(), Scalar(0));
  for (int j = 0; j < windows_; ++j) {
    const int first = starts[j] + 1;
    const auto is_tracked = [&](int k) {
      return frames.tracked.empty() || frames.tracked[first + k] != 0;
    };
    const auto sum =
        sum_of<double>(frames_, [&](int k) { return is_tracked(k) ? frame_counts_[k] : 0.0; });
    for (int k = 0; k < frames_; ++k) {
      at(weight_, 1, block_of(j / stride_, k))[j % stride_] =
          is_tracked(k) ? static_cast<Scalar>(frame_counts_[k] / sum) : Scalar(0);
    }
  }
}

template <class Scalar>
Scalar* WindowGradient<Scalar>::layer_input(int layer, int block) {
  return layer == 0 ? at(input_, layout_.inputs(0), block)
                    : at(hidden_[std::size_t(layer) - 1], layout_.inputs(layer), block);
}

template <class Scalar>
double WindowGradient<Scalar>::forward(const Scalar* parameters) {
  const int last = layout_.layer_count() - 1;
  double loss = 0.0;
  for (int group = 0; group < groups_; ++group) {
    if (modulation_.is_on()) {
      modulation_.begin(parameters, group);
    }
    for (int k = 0; k < frames_; ++k) {
      const int block = block_of(group, k);
      for (int layer = 0; layer <= last; ++layer) {
        const bool is_hidden = layer < last;
        const bool is_modulated = is_hidden && modulation_.is_on();
        Scalar* output = is_hidden ? layer_input(layer + 1, block) : output_.data();
        kernels_.layer(stride_, layout_.outputs(layer), layout_.inputs(layer),
                       layer_input(layer, block), parameters + layout_.weight_offset(layer),
                       parameters + layout_.bias_offset(layer), is_hidden && !is_modulated, output);
        if (is_modulated) {
          modulation_.apply(group, layer, output);
        }
      }
      // The next frame's input, at once.
      Scalar* state =
          k + 1 == frames_ ? last_state_.data() : previous_state(block_of(group, k + 1));
      apply_output(block, state);
      if (map_.reads_velocity() && k + 1 < frames_) {
        note_change(block, state, change(block_of(group, k + 1)));
      }
      loss += double(map_.error.compute(stride_, state, at(target_, target_size_, block),
                                        at(weight_, 1, block), at(error_gradient_, size_, block)));
    }
  }
  return loss;
}

/// From a block's state before to that after it.
template <class Scalar>
void WindowGradient<Scalar>::note_change(int block, const Scalar* state, Scalar* change) const {
  const Scalar* before = const_cast<WindowGradient*>(this)->previous_state(block);
  for (int r = 0; r < size_; ++r) {
    const Scalar scale = map_.change_scale[r];
    for (int i = r * stride_; i < (r + 1) * stride_; ++i) {
      change[i] = scale * (state[i] - before[i]);
    }
  }
}

template <class Scalar>
void WindowGradient<Scalar>::apply_output(int block, Scalar* state) {
  if (!map_.is_bounded()) {
    compose(block, state);
    return;
  }
  Scalar* unbounded = at(unbounded_, size_, block);
  compose(block, unbounded);
  kernels_.bound(view_of(map_.bounds), stride_, unbounded, state);
}

template <class Scalar>
void WindowGradient<Scalar>::compose(int block, Scalar* state) {
  const Scalar* uncompensated = at(uncompensated_, size_, block);
  if (map_.is_gated()) {
    kernels_.gated_change(size_, stride_, map_.output_scale.data(), output_.data(), uncompensated,
                          previous_state(block), at(gate_, size_, block), state);
  } else {
    kernels_.add_scaled(size_, stride_, map_.output_scale.data(), output_.data(), uncompensated,
                        state);
  }
}

// From the gradients of later frames and of this frame's own error to that of the network's output.
template <class Scalar>
void WindowGradient<Scalar>::carry_back(int block, Scalar* delta) {
  Scalar* error = at(error_gradient_, size_, block);
  if (map_.is_bounded()) {
    kernels_.bound_back(view_of(map_.bounds), stride_, at(unbounded_, size_, block),
                        carried_.data(), direct_.data(), error);
  }
  if (map_.is_gated()) {
    kernels_.gated_carry(size_, stride_, map_.output_scale.data(), error,
                         at(uncompensated_, size_, block), previous_state(block),
                         at(gate_, size_, block), carried_.data(), direct_.data(), delta);
  } else {
    kernels_.carry(size_, stride_, map_.output_scale.data(), error, carried_.data(), delta);
  }
}

template <class Scalar>
void WindowGradient<Scalar>::backward_block(const Scalar* parameters, int block, int slot) {
  const auto delta = [&](int layer) { return at(delta_[layer], layout_.outputs(layer), slot); };
  const int last = layout_.layer_count() - 1;
  if (growth_.is_on()) {
    growth_.put_in(at(error_gradient_, size_, block), size_);
  }
  carry_back(block, delta(last));
  for (int layer = last; layer > 0; --layer) {
    const int inputs = layout_.inputs(layer);
    kernels_.layer_back(stride_, layout_.outputs(layer), inputs, delta(layer),
                        parameters + layout_.weight_offset(layer), delta(layer - 1));
    if (modulation_.is_on()) {
      modulation_.apply_back(block / frames_, layer - 1, layer_input(layer, block),
                             delta(layer - 1));
    } else {
      kernels_.relu_gradient(stride_ * inputs, layer_input(layer, block), delta(layer - 1));
    }
  }
  // Only the columns of the first weight that read B_{t−1} lead back in time, and from a window's
  // first frame nothing does.
  if (block % frames_ + 1 == frames_) {
    return;
  }
  input_back(parameters, delta(0), 2 * segments_, size_, carried_.data());
  if (map_.reads_velocity()) {
    carry_change_back(parameters, delta(0));
  }
  if (growth_.is_on()) {
    growth_.shorten(carried_, direct_, changed_);
  }
}

template <class Scalar>
void WindowGradient<Scalar>::input_back(const Scalar* parameters, const Scalar* delta,
                                        int first_row, int rows, Scalar* out) {
  const int outputs = layout_.outputs(0);
  kernels_.layer_back(stride_, outputs, rows, delta,
                      parameters + layout_.weight_offset(0) + std::ptrdiff_t{first_row} * outputs,
                      out);
}

// B_{t−1} − B_{t−2} is read in frame t: B_{t−1} counts in it, and counts less in that of t + 1.
template <class Scalar>
void WindowGradient<Scalar>::carry_change_back(const Scalar* parameters, const Scalar* delta) {
  input_back(parameters, delta, change_row(), size_, change_back_.data());
  for (int r = 0; r < size_; ++r) {
    const Scalar scale = map_.change_scale[r];
    for (int i = r * stride_; i < (r + 1) * stride_; ++i) {
      change_back_[i] *= scale;
      carried_[i] += change_back_[i] - changed_[i];
    }
  }
  std::swap(change_back_, changed_);
}

template <class Scalar>
void WindowGradient<Scalar>::add_weight_gradients(int first_block, int count, Scalar* gradient) {
  for (int layer = 0; layer < layout_.layer_count(); ++layer) {
    const int outputs = layout_.outputs(layer);
    const int inputs = layout_.inputs(layer);
    const Scalar* delta = delta_[layer].data();
    kernels_.weight_gradient(count, stride_, outputs, inputs, delta,
                             layer_input(layer, first_block), inputs * stride_,
                             gradient + layout_.weight_offset(layer));
    kernels_.bias_gradient(count, stride_, outputs, delta, gradient + layout_.bias_offset(layer));
  }
}

template <class Scalar>
void WindowGradient<Scalar>::backward(const Scalar* parameters, Scalar* gradient) {
  std::fill(gradient, gradient + layout_.size(), Scalar(0));
  const int blocks = groups_ * frames_;
  int pending = 0;
  for (int block = 0; block < blocks; ++block) {
    if (block % frames_ == 0) {
      std::fill(carried_.begin(), carried_.end(), Scalar(0));
      std::fill(direct_.begin(), direct_.end(), Scalar(0));
      std::fill(changed_.begin(), changed_.end(), Scalar(0));
      growth_.begin();
      modulation_.begin_back();
    }
    backward_block(parameters, block, pending);
    if (modulation_.is_on() && block % frames_ + 1 == frames_) {
      modulation_.end_back(parameters, block / frames_, gradient);
    }
    ++pending;
    if (pending == slots_ || block + 1 == blocks) {
      add_weight_gradients(block + 1 - pending, pending, gradient);
      pending = 0;
    }
  }
}

template class WindowGradient<float>;
template class WindowGradient<double>;

}  // namespace limber
