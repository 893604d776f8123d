#include "limber/training/arm_modulation.hpp"

#include <algorithm>
#include <cmath>

#include "limber/network/arm_gain.hpp"
#include "training_kernels.hpp"

namespace limber {

template <class Scalar>
ArmModulation<Scalar>::ArmModulation(const ParameterLayout& layout,
                                     const WindowKernels<Scalar>& kernels, int groups, int stride)
    : layout_(layout), kernels_(kernels), stride_(stride), first_row_(1, 0) {
  if (!is_on()) {
    return;
  }
  for (int layer = 0; layer + 1 < layout.layer_count(); ++layer) {
    first_row_.push_back(rows() + 2 * layout.outputs(layer));
  }
  const auto numbers = [&](int count) { return std::size_t(count) * std::size_t(stride); };
  arm_.resize(numbers(groups));
  vector_.resize(numbers(layout.arms().size));
  vector_back_.resize(vector_.size());
  no_bias_.resize(rows());
  share_.resize(std::size_t(groups) * numbers(rows()));
  share_back_.resize(numbers(rows()));
}

template <class Scalar>
void ArmModulation<Scalar>::load(const std::vector<int>& arm, std::span<const int> starts) {
  std::ranges::transform(starts, arm_.begin(), [&](int frame) { return arm[frame]; });
}

template <class Scalar>
void ArmModulation<Scalar>::gather_vectors(const Scalar* parameters, int group) {
  for (int i = 0; i < stride_; ++i) {
    const int arm = arm_[group * stride_ + i];
    const Scalar* vector = parameters + layout_.arm_offset(arm);
    for (int r = 0; r < layout_.arms().size; ++r) {
      vector_[r * stride_ + i] = Scalar(kArmVectorScale) * vector[r];
    }
  }
}

template <class Scalar>
void ArmModulation<Scalar>::begin(const Scalar* parameters, int group) {
  gather_vectors(parameters, group);
  for (int layer = 0; layer < hidden_layers(); ++layer) {
    const int units = layout_.outputs(layer);
    Scalar* own = gains(group, layer);
    kernels_.layer(stride_, 2 * units, layout_.arms().size, vector_.data(),
                   parameters + layout_.modulation_offset(layer), no_bias_.data(), false, own);
    std::transform(own, own + units * stride_, own,
                   [](Scalar x) { return std::exp(log_arm_gain(x)); });
  }
}

template <class Scalar>
void ArmModulation<Scalar>::apply(int group, int layer, Scalar* y) {
  const int count = layout_.outputs(layer) * stride_;
  const Scalar* own = gains(group, layer);
  kernels_.modulate(count, own, own + count, y);
}

template <class Scalar>
void ArmModulation<Scalar>::begin_back() {
  std::ranges::fill(share_back_, Scalar(0));
}

template <class Scalar>
void ArmModulation<Scalar>::apply_back(int group, int layer, const Scalar* y, Scalar* dy) {
  const int count = layout_.outputs(layer) * stride_;
  Scalar* back = share_back_.data() + first_row(layer) * stride_;
  kernels_.modulate_back(count, gains(group, layer), y, dy, back, back + count);
}

template <class Scalar>
void ArmModulation<Scalar>::end_back(const Scalar* parameters, int group, Scalar* gradient) {
  const int size = layout_.arms().size;
  gather_vectors(parameters, group);
  for (int layer = 0; layer < hidden_layers(); ++layer) {
    const int rows = 2 * layout_.outputs(layer);
    Scalar* back = share_back_.data() + first_row(layer) * stride_;
    std::transform(back, back + rows / 2 * stride_, gains(group, layer), back,
                   [](Scalar by_log_gain, Scalar gain) {
                     return by_log_gain * log_arm_gain_slope(std::log(gain));
                   });
    const Eigen::Index at = layout_.modulation_offset(layer);
    kernels_.weight_gradient(1, stride_, rows, size, back, vector_.data(), 0, gradient + at);
    kernels_.layer_back(stride_, rows, size, back, parameters + at, vector_back_.data());
    for (int i = 0; i < stride_; ++i) {
      const int arm = arm_[group * stride_ + i];
      Scalar* vector = gradient + layout_.arm_offset(arm);
      for (int r = 0; r < size; ++r) {
        vector[r] += Scalar(kArmVectorScale) * vector_back_[r * stride_ + i];
      }
    }
  }
}

template class ArmModulation<float>;
template class ArmModulation<double>;

}  // namespace limber
