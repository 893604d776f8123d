#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "kernels/gap_bound.hpp"
#include "limber/common/aligned_floats.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/arm_modulation.hpp"
#include "limber/training/frame_error.hpp"
#include "limber/training/growth_limit.hpp"
#include "limber/training/parameter_layout.hpp"

namespace limber {

/// Training data as the network sees them, one column per frame, normalised. n segments, D numbers
/// a backbone, N numbers of the unloaded backbone among the inputs (network/backbone_layout.hpp).
template <class Scalar>
struct FrameTable {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix pressure;       ///< n×F
  Matrix no_load;        ///< N×F, B̃ as the network reads it
  Matrix uncompensated;  ///< D×F, the state that a network output of zero would give
  Matrix state;          ///< D×F, recorded backbones
  Matrix target;  ///< what the frame error compares with, a pose of each plate; empty: `state`
  std::vector<std::uint8_t> tracked;  ///< F, 0 if the backbone was not tracked; empty: always
  Matrix change = {};  ///< D×F, B_t − B_{t−1} as the network reads it; empty: it does not
  std::vector<int> arm = {};  ///< F, which of a family's arms; empty: they are one

  const Matrix& targets() const { return target.size() > 0 ? target : state; }
};

/// (20) for normalised states: a state's number r is state_r · scale_r + offset_r in m or rad.
template <class Scalar>
struct StateBounds {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  std::vector<GapBound<Scalar>> gaps;  ///< empty: no bounds
  Vector scale;                        ///< D
  Vector offset;                       ///< D
  BackboneLayout layout = BackboneLayout::gap_poses;
  Dimension dimension = Dimension::plane;
  /// Whether gradients lead what is held back within its bound; false: the derivative as it is.
  bool lead_back = true;

  /// The same in another precision.
  template <class Other>
  StateBounds<Other> cast() const {
    StateBounds<Other> result{
        {},       scale.template cast<Other>(), offset.template cast<Other>(), layout, dimension,
        lead_back};
    for (const GapBound<Scalar>& gap : gaps) {
      result.gaps.push_back(
          gap_bound(static_cast<Other>(gap.min_length), static_cast<Other>(gap.max_length),
                    static_cast<Other>(gap.min_turn), static_cast<Other>(gap.max_turn),
                    static_cast<Other>(gap.max_bend)));
    }
    return result;
  }
};

/// (5) and (16) in normalised numbers, with y_t the network's output.
/// compensation: state_t = uncompensated_t + output_scale ∘ y_t.
/// gated_change: state_t = state_{t−1} + g ∘ (uncompensated_t − state_{t−1}) + output_scale ∘ y_t,
///               with y_t its first D numbers and g the logistic function of the D behind them.
template <class Scalar>
struct StateMap {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  Vector output_scale;  ///< D
  FrameError<Scalar> error;
  OutputForm form = OutputForm::compensation;
  StateBounds<Scalar> bounds = {};  ///< applied last
  /// D: the network reads change_scale ∘ (state_{t−1} − state_{t−2}); empty: it does not.
  Vector change_scale = {};
  /// > 0: the gradient that a window carries back to a frame is shortened to this many times the
  /// sum of what the frames behind it put in. What grows more has run away: no arm amplifies so.
  Scalar growth_limit = 0;
  double first_frames_power = 0;  ///< a window's frame k counts (k + 1)^-power

  bool is_bounded() const { return !bounds.gaps.empty(); }
  bool reads_velocity() const { return change_scale.size() > 0; }
  bool is_gated() const { return form == OutputForm::gated_change; }
  /// Number of the network's outputs.
  int output_count() const { return int(output_scale.size()) * (is_gated() ? 2 : 1); }
};

/// Loss and gradient over a chunk of windows: the network is rolled over each window with its own
/// output fed back, and the error of every frame is propagated back through all frames before it
/// (the paper's IV-C). A window's error is the mean over those of its frames in which the arm was
/// tracked, weighted by StateMap::first_frames_power.
///
/// Sizes: windows of T frames, at most C of them at a time, computed in groups of a few dozen.
/// Threads: one thread, one object; it allocates nothing after construction.
template <class Scalar>
class WindowGradient {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// @param layout  2n + D + N inputs (q_{t−1}, q_t, B_{t−1}, B̃_t), D more where the map has a
  ///                change_scale; map.output_count() outputs.
  WindowGradient(const ParameterLayout& layout, const StateMap<Scalar>& map, int segment_count,
                 int window_frames, int window_limit);

  /// Takes windows that start from the recorded backbone of frames `starts` and predict the T
  /// frames after it. @pre 1 ≤ starts.size() ≤ window_limit; start + T < F.
  void load(const FrameTable<Scalar>& frames, std::span<const int> starts);

  /// Sum over the windows of their errors.
  /// @param parameters  layout.size() numbers.
  double forward(const Scalar* parameters);

  /// Gradient of `forward`'s last result, written to `gradient` (layout.size()).
  void backward(const Scalar* parameters, Scalar* gradient);

 private:
  using Storage = std::vector<Scalar, CacheLineAllocator<Scalar>>;

  // A block is one frame of one group of `stride_` windows. The last group is filled up with copies
  // of its last window, with weight 0. Blocks are numbered in the order of back-propagation.
  int block_of(int group, int frame) const { return group * frames_ + frames_ - 1 - frame; }
  Scalar* at(Storage& storage, int rows, int block) const {
    return storage.data() + std::ptrdiff_t{block} * rows * stride_;
  }
  Scalar* layer_input(int layer, int block);
  Scalar* previous_state(int block) { return layer_input(0, block) + 2 * segments_ * stride_; }
  Scalar* change(int block) { return layer_input(0, block) + change_row() * stride_; }
  int change_row() const { return layout_.inputs(0) - size_; }
  void note_change(int block, const Scalar* state, Scalar* change) const;
  /// What `rows` of the network's inputs, from `first_row` on, lead back of its first layer's
  /// delta.
  void input_back(const Scalar* parameters, const Scalar* delta, int first_row, int rows,
                  Scalar* out);
  void carry_change_back(const Scalar* parameters, const Scalar* delta);
  void apply_output(int block, Scalar* state);
  void compose(int block, Scalar* state);
  void carry_back(int block, Scalar* delta);
  void load_block(const FrameTable<Scalar>& frames, int group, int frame);
  void weigh(const FrameTable<Scalar>& frames, std::span<const int> starts);
  void backward_block(const Scalar* parameters, int block, int slot);
  void add_weight_gradients(int first_block, int count, Scalar* gradient);

  const WindowKernels<Scalar>& kernels_;
  ParameterLayout layout_;
  StateMap<Scalar> map_;
  int segments_;  ///< n
  int size_;      ///< D
  int frames_;
  int window_limit_;
  int stride_;
  int slots_;  ///< blocks whose deltas are kept until their products are taken together
  GrowthLimit<Scalar, Storage> growth_;
  ArmModulation<Scalar> modulation_;
  int groups_ = 0;
  int windows_ = 0;
  std::vector<int> index_;       ///< table columns of a group's windows
  Storage input_;                ///< the layout's inputs, a row each, per block
  std::vector<Storage> hidden_;  ///< outputs of the hidden layers
  std::vector<Storage>
      delta_;  ///< a layer each: ∂loss/∂(its output before ReLU), of `slots_` blocks
  int target_size_ = 0;
  Storage target_;
  Storage uncompensated_;
  std::vector<double> frame_counts_;  ///< T, how much a window's frames count, before their sum
  Storage weight_;                    ///< of a block's windows: its share of that sum, or 0
  Storage output_;                    ///< one block
  Storage last_state_;                ///< one block: what no frame reads
  Storage carried_;                   ///< one block: ∂loss/∂state, carried from frame to frame
  Storage direct_;                    ///< one block: the part of it that the network had no part in
  Storage changed_;  ///< one block: ∂loss/∂(state's change) of the frame behind, in state's units
  Storage change_back_;     ///< one block: the same of this frame
  Storage unbounded_;       ///< states before (20), where there are bounds
  Storage gate_;            ///< g, where there are gates
  Storage error_gradient_;  ///< ∂(frame error)/∂state
};

extern template class WindowGradient<float>;
extern template class WindowGradient<double>;

}  // namespace limber
