#pragma once

#include <optional>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// The forward model B_t = F(q_{t−1}, q_t, B_{t−1}) (docs/model.md, (1) and (5)): the no-load
/// model, or the no-load model compensated by a network. A pure function: the whole state is in its
/// arguments.
///
/// Sizes:   n segments, m backbone points; batches of k queries, one a column, a backbone's 3m
/// numbers in row order. Threads: constant after construction; each thread brings its own
/// Workspace.
class ForwardModel {
 public:
  /// Scratch of one thread; grows to the largest batch seen, then allocates nothing.
  class Workspace;

  explicit ForwardModel(const ArmDescription& arm);
  /// @throws InputError where the network was trained for another arm (name and hashes in the
  /// message).
  ForwardModel(const ArmDescription& arm, CompensationModel compensation);

  int segment_count() const;
  int point_count() const;
  bool has_network() const;
  const NoLoadModel& no_load() const;

  /// One query, unchecked: sizes are right and numbers finite (asserted in the dev preset).
  void step(const Eigen::Ref<const Pressures>& previous_kpa,
            const Eigen::Ref<const Pressures>& current_kpa,
            const Eigen::Ref<const Backbone>& previous, Eigen::Ref<Backbone> next,
            Workspace& workspace) const;

  /// k queries: pressures n×k, backbones 3m×k. Column j of `next` is the answer to column j of the
  /// inputs and does not depend on the other columns. `next` may be `previous`.
  void step_batch(const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& previous,
                  Eigen::Ref<Eigen::MatrixXf> next, Workspace& workspace) const;

  /// One query, checked. @throws InputError where a size is wrong, a number not finite or a
  /// pressure beyond its limit (by more than 5 %: a measured pressure overshoots).
  Backbone checked_step(const Pressures& previous_kpa, const Pressures& current_kpa,
                        const Backbone& previous) const;

 private:
  NoLoadModel no_load_;
  std::optional<CompensationModel> compensation_;
};

}  // namespace limber
