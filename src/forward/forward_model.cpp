#include "limber/forward/forward_model.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "forward_pipeline.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/forward/checked_query.hpp"
#include "limber/network/past_commands.hpp"

namespace limber {

namespace {

constexpr float kNoUnit = 1e-2F;  // more than rounding makes of a rotation

CompensationModel checked(CompensationModel compensation, const ArmDescription& arm) {
  validate(compensation, "compensation model");
  require_model_of(compensation, arm, "compensation model");
  return compensation;
}

template <class Derived>
ConstColumns columns_of(const Eigen::MatrixBase<Derived>& m) {
  return {m.derived().data(), int(m.derived().outerStride())};
}

/// Of every channel.
std::vector<PressureLimits> limits_of(const NoLoadModel& arm) {
  std::vector<PressureLimits> limits;
  for (int i = 0; i < arm.segment_count(); ++i) {
    for (const Chamber& chamber : arm.segment(i).chambers) {
      limits.push_back(chamber.limit_kpa);
    }
    if (arm.dimension() == Dimension::plane) {
      limits.push_back(arm.segment(i).pressure_limit_kpa);
    }
  }
  return limits;
}

void require_pressures(const char* name, const Pressures& pressures, const ForwardModel& model) {
  const NoLoadModel& arm = model.no_load();
  const char* part = arm.dimension() == Dimension::space ? "chamber" : "segment";
  if (pressures.size() != model.command_size()) {
    throw InputError(fmt::format(
        "{}: {} {}s; the arm has {} {}s{}", name, pressures.size(), followed_name(arm.command()),
        arm.channel_count(), part,
        model.command_size() == arm.channel_count()
            ? ""
            : fmt::format(", and the network reads {} with past ones", model.command_size())));
  }
  const std::vector<PressureLimits> all = limits_of(arm);
  for (int i = 0; i < model.command_size(); ++i) {
    const PressureLimits& limits = all[std::size_t(i) % all.size()];
    const PressureLimits allowed = measured_limits(limits);
    if (!allowed.contains(double(pressures[i]))) {
      throw InputError(fmt::format(
          "{}[{}] = {} {unit}; expected {:.6g} to {:.6g} {unit}, the {}'s "
          "limits of {} {unit} and {:g} % of their range for overshoot",
          name, i, pressures[i], allowed.lower_kpa, allowed.upper_kpa, part, to_string(limits),
          100.0 * kOvershootOfRange, fmt::arg("unit", arm.command().unit)));
    }
  }
}

template <class Rows>
void require_backbone(const char* name, const Rows& backbone, int points) {
  refuse_if(backbone.rows() != points, "{}: {} points; the arm has {}", name, backbone.rows(),
            points);
  for (int p = 0; p < points; ++p) {
    if (!backbone.row(p).allFinite()) {
      throw InputError(fmt::format(
          "{}[{}] = ({}); expected finite {}", name, p, fmt::join(backbone.row(p), ", "),
          Rows::ColsAtCompileTime == kPoseSize ? "metres and radians"
                                               : "metres and a unit quaternion"));
    }
    if constexpr (Rows::ColsAtCompileTime == kSpacePoseSize) {
      const float norm = backbone.row(p).template tail<4>().norm();
      refuse_if(std::abs(norm - 1.0F) > kNoUnit,
                "{}[{}] has a quaternion of norm {:.4g}; expected 1, as rotations have it", name, p,
                norm);
    }
  }
}

/// @tparam Rows  Backbone or SpaceBackbone
template <class Rows>
Rows checked_rows(const ForwardModel& model, const Pressures& previous_kpa,
                  const Pressures& current_kpa, const Rows& before, const Rows& previous) {
  constexpr int kSize = Rows::ColsAtCompileTime;
  refuse_if(kSize != pose_size(model.dimension()),
            "checked_step: poses of {} numbers; the arm's have {}", kSize,
            pose_size(model.dimension()));
  require_pressures("previous_kpa", previous_kpa, model);
  require_pressures("current_kpa", current_kpa, model);
  require_backbone("previous", previous, model.point_count());
  require_backbone("before", before, model.point_count());
  using Column = Eigen::Map<const Eigen::VectorXf>;
  Rows next(model.point_count(), kSize);
  ForwardModel::Workspace workspace;
  model.step_batch(previous_kpa, current_kpa, Column(before.data(), before.size()),
                   Column(previous.data(), previous.size()),
                   Eigen::Map<Eigen::VectorXf>(next.data(), next.size()), workspace);
  return next;
}

}  // namespace

ForwardModel::ForwardModel(const ArmDescription& arm, CpuLevel level)
    : no_load_(arm), pipeline_(std::make_unique<ForwardPipeline>(arm, nullptr, level)) {}

ForwardModel::ForwardModel(const ArmDescription& arm, CompensationModel compensation,
                           CpuLevel level)
    : no_load_(arm),
      compensation_(checked(std::move(compensation), arm)),
      pipeline_(std::make_unique<ForwardPipeline>(arm, &*compensation_, level)) {}

ForwardModel::ForwardModel(ForwardModel&&) noexcept = default;
ForwardModel& ForwardModel::operator=(ForwardModel&&) noexcept = default;
ForwardModel::~ForwardModel() = default;

float* ForwardModel::scratch_of(Workspace& workspace) const {
  const std::size_t size = pipeline_->scratch_size();
  if (workspace.scratch_.size() < size) {
    workspace.scratch_.resize(size);
  }
  return workspace.scratch_.data();
}

void ForwardModel::step(const Eigen::Ref<const Pressures>& previous_kpa,
                        const Eigen::Ref<const Pressures>& current_kpa,
                        const Eigen::Ref<const Backbone>& previous, Eigen::Ref<Backbone> next,
                        Workspace& workspace) const {
  step(previous_kpa, current_kpa, previous, previous, next, workspace);
}

void ForwardModel::step(const Eigen::Ref<const Pressures>& previous_kpa,
                        const Eigen::Ref<const Pressures>& current_kpa,
                        const Eigen::Ref<const Backbone>& before,
                        const Eigen::Ref<const Backbone>& previous, Eigen::Ref<Backbone> next,
                        Workspace& workspace) const {
  assert(previous_kpa.size() == channel_count() && current_kpa.size() == channel_count());
  assert(previous.rows() == point_count() && next.rows() == point_count());
  assert(previous_kpa.allFinite() && current_kpa.allFinite() && previous.allFinite());
  // A contiguous backbone is a column of 3m numbers; a row of a wider matrix is not.
  assert(previous.outerStride() == kPoseSize && next.outerStride() == kPoseSize &&
         before.outerStride() == kPoseSize);
  const int size = kPoseSize * point_count();
  pipeline_->run(1,
                 {{previous_kpa.data(), channel_count()},
                  {current_kpa.data(), channel_count()},
                  {previous.data(), size},
                  {next.data(), size},
                  {before.data(), size}},
                 scratch_of(workspace));
}

void ForwardModel::step_batch(const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                              const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                              const Eigen::Ref<const Eigen::MatrixXf>& previous,
                              Eigen::Ref<Eigen::MatrixXf> next, Workspace& workspace) const {
  step_batch(previous_kpa, current_kpa, previous, previous, next, workspace);
}

void ForwardModel::step_batch(const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                              const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                              const Eigen::Ref<const Eigen::MatrixXf>& before,
                              const Eigen::Ref<const Eigen::MatrixXf>& previous,
                              Eigen::Ref<Eigen::MatrixXf> next, Workspace& workspace) const {
  assert(previous_kpa.rows() == command_size() && current_kpa.rows() == command_size());
  assert(previous.rows() == pose_size(dimension()) * point_count() &&
         next.rows() == previous.rows());
  assert(previous_kpa.cols() == next.cols() && current_kpa.cols() == next.cols() &&
         previous.cols() == next.cols());
  assert(previous_kpa.allFinite() && current_kpa.allFinite() && previous.allFinite());
  pipeline_->run(int(next.cols()),
                 {columns_of(previous_kpa),
                  columns_of(current_kpa),
                  columns_of(previous),
                  {next.data(), int(next.outerStride())},
                  columns_of(before)},
                 scratch_of(workspace));
}

Backbone ForwardModel::checked_step(const Pressures& previous_kpa, const Pressures& current_kpa,
                                    const Backbone& previous) const {
  return checked_step(previous_kpa, current_kpa, previous, previous);
}

Backbone ForwardModel::checked_step(const Pressures& previous_kpa, const Pressures& current_kpa,
                                    const Backbone& before, const Backbone& previous) const {
  return checked_rows(*this, previous_kpa, current_kpa, before, previous);
}

SpaceBackbone checked_query(const ForwardModel& model, const Pressures& previous_kpa,
                            const Pressures& current_kpa, const SpaceBackbone& before,
                            const SpaceBackbone& previous) {
  return checked_rows(model, previous_kpa, current_kpa, before, previous);
}

Eigen::MatrixXf ForwardModel::told_commands(
    const Eigen::Ref<const Eigen::MatrixXf>& commands) const {
  return with_past_commands(commands,
                            has_network() ? compensation_->past_commands : std::vector<int>());
}

void ForwardModel::rollout(const Eigen::Ref<const Eigen::MatrixXf>& pressures_kpa,
                           Eigen::Ref<Eigen::MatrixXf> backbones, Workspace& workspace) const {
  assert(pressures_kpa.cols() == backbones.cols());
  if (command_size() != channel_count()) {
    roll_out_told(told_commands(pressures_kpa), backbones, workspace);
  } else {
    roll_out_told(pressures_kpa, backbones, workspace);
  }
}

void ForwardModel::roll_out_told(const Eigen::Ref<const Eigen::MatrixXf>& pressures_kpa,
                                 Eigen::Ref<Eigen::MatrixXf> backbones,
                                 Workspace& workspace) const {
  for (Eigen::Index t = 1; t < pressures_kpa.cols(); ++t) {
    step_batch(pressures_kpa.col(t - 1), pressures_kpa.col(t),
               backbones.col(std::max(t - 2, Eigen::Index{0})), backbones.col(t - 1),
               backbones.col(t), workspace);
  }
}

}  // namespace limber
