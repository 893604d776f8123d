#pragma once

#include <span>
#include <vector>

#include "limber/common/aligned_floats.hpp"
#include "limber/training/parameter_layout.hpp"

namespace limber {

template <class Scalar>
struct WindowKernels;

/// What the arms of a family do to the hidden layers of their windows: gains and shifts of the
/// units, the same in all frames of a window (docs/families.md). Rows of `stride` windows, group by
/// group.
template <class Scalar>
class ArmModulation {
 public:
  /// @param layout  its arms may be none: then the modulation is off, and only that may be asked
  ArmModulation(const ParameterLayout& layout, const WindowKernels<Scalar>& kernels, int groups,
                int stride);

  bool is_on() const { return layout_.arms().size > 0; }

  /// @param arm    of each frame of the training data
  /// @param starts the first frames of all windows, group by group
  void load(const std::vector<int>& arm, std::span<const int> starts);
  /// Before a group's first frame forward.
  void begin(const Scalar* parameters, int group);
  /// To the units of a hidden layer: y was W x + b, and is the layer's output.
  void apply(int group, int layer, Scalar* y);

  /// Before a group's first frame backward.
  void begin_back();
  /// @param y   output of a hidden layer
  /// @param dy  its gradient, which becomes that of W x + b
  void apply_back(int group, int layer, const Scalar* y, Scalar* dy);
  /// Behind a group's last frame backward: adds what it has told of parameters and arms.
  void end_back(const Scalar* parameters, int group, Scalar* gradient);

 private:
  using Storage = std::vector<Scalar, CacheLineAllocator<Scalar>>;

  int hidden_layers() const { return int(first_row_.size()) - 1; }
  int rows() const { return first_row_.back(); }
  Scalar* gains(int group, int layer) {
    return share_.data() + (std::ptrdiff_t{group} * rows() + first_row(layer)) * stride_;
  }
  int first_row(int layer) const { return first_row_[layer]; }
  void gather_vectors(const Scalar* parameters, int group);

  ParameterLayout layout_;
  const WindowKernels<Scalar>& kernels_;
  int stride_;
  std::vector<int> first_row_;  ///< of each hidden layer: two for each unit, gains before shifts
  std::vector<int> arm_;        ///< of all windows
  Storage vector_;              ///< e of a group's arms
  Storage vector_back_;         ///< … and its gradient
  Storage no_bias_;             ///< zero
  Storage share_;               ///< of all groups
  Storage share_back_;  ///< of a group: gradients of log gains and shifts, of its frames so far
};

extern template class ArmModulation<float>;
extern template class ArmModulation<double>;

}  // namespace limber
