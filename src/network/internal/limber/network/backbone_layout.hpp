#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Which numbers a network reads and writes, and where they sit (docs/model.md, (5)). Of an arm in
/// space read 7 for the 3 of base poses, and 6 for that of gaps; it has gap poses alone.
///
/// Input, one column per query: q_{t−1} and q_t (command_size each), B_{t−1} (backbone_size), B̃_t
/// (no_load_size); where the network reads velocities, B_{t−1} − B_{t−2} (backbone_size).
/// Output: B_t − B̃_t (backbone_size), or the change and the gates of (16) (backbone_size each).
/// base_poses: B and B̃ are 3m numbers, poses about the arm's base: 102 → 48 for n = 3, m = 16.
/// gap_poses:  B is 3(m − 1) numbers, each plate's pose about the plate before it; the base plate
///             is the origin by definition and left out. B̃ is 3 numbers per segment, since all
///             gaps of an unloaded segment are alike; the output is taken from it gap by gap:
///             60 → 45.
/// Sizes: n channels, m points, k columns. Threads: constant after construction.
class NetworkLayout {
 public:
  /// @param past_commands  how many earlier commands it reads beside each
  NetworkLayout(BackboneLayout layout, OutputForm form, const ArmDescription& arm,
                bool reads_velocity = false, std::size_t past_commands = 0);

  BackboneLayout backbone_layout() const { return layout_; }
  OutputForm output_form() const { return form_; }
  int segment_count() const { return int(first_gap_.size()); }
  int point_count() const { return point_count_; }
  Dimension dimension() const { return dimension_; }
  int command_size() const { return command_size_; }  ///< n, and n for each earlier one
  int backbone_size() const;
  int no_load_size() const;
  bool reads_velocity() const { return reads_velocity_; }
  int input_size() const { return change_row() + (reads_velocity_ ? backbone_size() : 0); }
  int output_size() const {
    return form_ == OutputForm::gated_change ? 2 * backbone_size() : backbone_size();
  }

  /// Rows at which the parts of an input begin.
  int previous_pressure_row() const { return 0; }
  int pressure_row() const { return command_size_; }
  int backbone_row() const { return 2 * command_size_; }
  int no_load_row() const { return backbone_row() + backbone_size(); }
  int change_row() const { return no_load_row() + no_load_size(); }

  /// First gap of a segment; its shape stands for all of the unloaded segment.
  int first_gap(int segment) const { return first_gap_[segment]; }

  /// Backbones 3m×k (base poses) in this layout, backbone_size×k; and back.
  Eigen::MatrixXf encode(const Eigen::Ref<const Eigen::MatrixXf>& base_poses) const;
  Eigen::MatrixXf decode(const Eigen::Ref<const Eigen::MatrixXf>& encoded) const;
  /// The input rows no_load_size×k of unloaded backbones encoded by `encode`.
  Eigen::MatrixXf no_load_input(const Eigen::Ref<const Eigen::MatrixXf>& encoded) const;

 private:
  BackboneLayout layout_;
  OutputForm form_;
  bool reads_velocity_;
  Dimension dimension_;
  int command_size_;
  int point_count_;
  std::vector<int> first_gap_;
};

/// Each plate's pose about the plate before it: columns of 3m base poses to columns of 3(m − 1).
/// Computed in double; θ is a plain difference, never wrapped.
Eigen::MatrixXd gap_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& base_poses,
                             Dimension dimension = Dimension::plane);

/// The inverse, with the base plate at the origin: 3(m − 1) rows to 3m.
Eigen::MatrixXd base_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& gap_poses,
                              Dimension dimension = Dimension::plane);

}  // namespace limber
