#pragma once
// For those who ask a model where the arm goes.

#include <memory>
#include <optional>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/aligned_floats.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/packed_network.hpp"

namespace limber {

class ForwardPipeline;

/// The forward model B_t = F(q_{t−1}, q_t, B_{t−1}) (docs/model.md, (1) and (5)): the no-load
/// model, or the no-load model compensated by a network. It is a pure function: the whole state is
/// in its arguments. Of an ensemble, the first network answers.
///
/// Sizes:   n channels, m backbone points; batches of k queries, one per column, a backbone's 3m
///          numbers in row order. Of an arm in space they are 7m, and it has batches alone.
///          Where a network reads past commands, they stand below those of each query: c numbers,
///          CompensationModel::command_size().
/// Threads: constant after construction; it moves but is not copied; each thread brings its own
/// Workspace.
class ForwardModel {
 public:
  /// Scratch of one thread. It grows when a model first uses it; after that, batches of any size
  /// allocate nothing. Its content never affects a result.
  class Workspace {
   private:
    friend class ForwardModel;
    AlignedFloats scratch_;
  };

  /// The no-load model alone.
  explicit ForwardModel(const ArmDescription& arm, CpuLevel level = cpu_level());
  /// @throws InputError if the network is not valid or was trained for another arm (both names
  /// and hashes in the message).
  ForwardModel(const ArmDescription& arm, CompensationModel compensation,
               CpuLevel level = cpu_level());
  ForwardModel(ForwardModel&&) noexcept;
  ForwardModel& operator=(ForwardModel&&) noexcept;
  ~ForwardModel();

  int segment_count() const { return no_load_.segment_count(); }
  int channel_count() const { return no_load_.channel_count(); }
  Dimension dimension() const { return no_load_.dimension(); }
  int point_count() const { return no_load_.point_count(); }
  bool has_network() const { return compensation_.has_value(); }
  const NoLoadModel& no_load() const { return no_load_; }
  /// @pre has_network()
  const CompensationModel& compensation() const { return *compensation_; }

  /// Whether it has to be told B_{t−2} as well: how a moving arm moved in the frame before. Where
  /// nobody says, the arm stood still.
  bool reads_velocity() const { return has_network() && compensation_->reads_velocity; }

  /// One query, unchecked: sizes n, n, m×3, m×3 and finite numbers (asserted in the dev preset).
  /// `next` may be `previous` or `before`. Without `before` (B_{t−2}) the arm stood still.
  void step(const Eigen::Ref<const Pressures>& previous_kpa,
            const Eigen::Ref<const Pressures>& current_kpa,
            const Eigen::Ref<const Backbone>& before, const Eigen::Ref<const Backbone>& previous,
            Eigen::Ref<Backbone> next, Workspace& workspace) const;
  void step(const Eigen::Ref<const Pressures>& previous_kpa,
            const Eigen::Ref<const Pressures>& current_kpa,
            const Eigen::Ref<const Backbone>& previous, Eigen::Ref<Backbone> next,
            Workspace& workspace) const;

  /// Numbers that tell a query's commands: n, or c where the network reads past ones.
  int command_size() const {
    return has_network() ? compensation_->command_size() : channel_count();
  }
  /// Commands n × T of frames one after the other as `step_batch` is told them, c × T. Before the
  /// first frame they were what they are there.
  Eigen::MatrixXf told_commands(const Eigen::Ref<const Eigen::MatrixXf>& commands) const;

  /// k queries: pressures c×k, backbones 3m×k; unchecked like `step`. Column j of `next` equals, to
  /// the bit, what `step` gives for column j of the inputs. `next` may be `previous` or `before`.
  void step_batch(const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& before,
                  const Eigen::Ref<const Eigen::MatrixXf>& previous,
                  Eigen::Ref<Eigen::MatrixXf> next, Workspace& workspace) const;
  void step_batch(const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& previous,
                  Eigen::Ref<Eigen::MatrixXf> next, Workspace& workspace) const;

  /// One query, checked. @throws InputError if a size is wrong, a number not finite or a
  /// pressure beyond its limits (by more than 5 % of their range: measured ones overshoot).
  Backbone checked_step(const Pressures& previous_kpa, const Pressures& current_kpa,
                        const Backbone& before, const Backbone& previous) const;
  Backbone checked_step(const Pressures& previous_kpa, const Pressures& current_kpa,
                        const Backbone& previous) const;

  /// Feeds its own output back along a motion: pressures n×(T + 1); column 0 of `backbones`,
  /// 3m×(T + 1), is given, columns 1 … T are written. The arm stood still before.
  void rollout(const Eigen::Ref<const Eigen::MatrixXf>& pressures_kpa,
               Eigen::Ref<Eigen::MatrixXf> backbones, Workspace& workspace) const;

 private:
  float* scratch_of(Workspace& workspace) const;
  /// `rollout` of commands with the past ones below them.
  void roll_out_told(const Eigen::Ref<const Eigen::MatrixXf>& pressures_kpa,
                     Eigen::Ref<Eigen::MatrixXf> backbones, Workspace& workspace) const;

  NoLoadModel no_load_;
  std::optional<CompensationModel> compensation_;
  std::unique_ptr<const ForwardPipeline> pipeline_;
};

}  // namespace limber
