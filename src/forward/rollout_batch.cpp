#include "limber/forward/rollout_batch.hpp"

#include <algorithm>
#include <cassert>

#include <tbb/enumerable_thread_specific.h>

#include "kernels/job_arena.hpp"

namespace limber {

namespace {

constexpr Eigen::Index kFirstCapacity = 64;

constexpr Eigen::Index kPart = 512;  // queries; about 0.1 ms, far above what handing over costs

}  // namespace

RolloutBatch::RolloutBatch(const MotionModel& model)
    : model_(model), setpoint_kpa_(model.channel_count()) {
  for (Eigen::MatrixXf* m : {&from_kpa_, &to_kpa_, &before_kpa_, &now_kpa_}) {
    m->resize(model.channel_count(), 0);
  }
  valves_.resize(model.valves().state_size(), 0);
  earlier_.resize(model.reads_velocity() ? kPoseSize * model.point_count() : 0, 0);
  before_.resize(kPoseSize * model.point_count(), 0);
  now_.resize(kPoseSize * model.point_count(), 0);
}

void RolloutBatch::grow() {
  const Eigen::Index capacity = std::max(kFirstCapacity, 2 * now_.cols());
  for (Eigen::MatrixXf* m :
       {&from_kpa_, &to_kpa_, &before_kpa_, &now_kpa_, &valves_, &earlier_, &before_, &now_}) {
    m->conservativeResize(Eigen::NoChange, capacity);
  }
}

void RolloutBatch::add(int label, const MotionState& from,
                       const Eigen::Ref<const Pressures>& to_kpa, int frames) {
  assert(frames >= 1);
  const Eigen::Index column = size();
  if (column == now_.cols()) {
    grow();
  }
  motions_.push_back({label, 0, frames});
  from_kpa_.col(column) = from.setpoint_kpa();
  to_kpa_.col(column) = to_kpa;
  now_kpa_.col(column) = from.pressure_kpa();
  valves_.col(column) = from.valves;
  Eigen::Map<Backbone>(now_.col(column).data(), model_.point_count(), kPoseSize) = from.backbone;
  if (model_.reads_velocity()) {
    Eigen::Map<Backbone>(before_.col(column).data(), model_.point_count(), kPoseSize) = from.before;
  }
}

void RolloutBatch::step() {
  now_kpa_.swap(before_kpa_);
  if (model_.reads_velocity()) {
    before_.swap(earlier_);
  }
  now_.swap(before_);
  for (int c = 0; c < size(); ++c) {
    Motion& motion = motions_[c];
    assert(motion.frame < motion.frames);
    ++motion.frame;
    motion_setpoint(from_kpa_.col(c), to_kpa_.col(c), motion.frame, motion.frames, setpoint_kpa_);
    model_.valves().step(setpoint_kpa_, valves_.col(c));
    now_kpa_.col(c) = valves_.col(c).head(setpoint_kpa_.size());
  }
  const Eigen::MatrixXf& earlier = model_.reads_velocity() ? earlier_ : before_;
  model_.forward().step_batch(before_kpa_.leftCols(size()), now_kpa_.leftCols(size()),
                              earlier.leftCols(size()), before_.leftCols(size()),
                              now_.leftCols(size()), workspace_);
}

Eigen::Map<const Backbone> RolloutBatch::before(int column) const {
  assert(frame(column) >= 1);
  return {before_.col(column).data(), model_.point_count(), kPoseSize};
}

Eigen::Map<const Backbone> RolloutBatch::now(int column) const {
  return {now_.col(column).data(), model_.point_count(), kPoseSize};
}

Eigen::Map<const Eigen::VectorXf> RolloutBatch::valves(int column) const {
  return {valves_.col(column).data(), valves_.rows()};
}

MotionState RolloutBatch::state(int column) const {
  const Eigen::Map<const Backbone> before(before_.col(column).data(), model_.point_count(),
                                          kPoseSize);
  return model_.moving_state(valves(column), now(column), before);
}

void RolloutBatch::go_on(int column, const Eigen::Ref<const Pressures>& to_kpa, int frames) {
  assert(frames >= 1 && has_ended(column));
  from_kpa_.col(column) = to_kpa_.col(column);
  to_kpa_.col(column) = to_kpa;
  motions_[column] = {label(column), 0, frames};
}

void RolloutBatch::remove(int column) {
  const int last = size() - 1;
  if (column != last) {
    motions_[column] = motions_.back();
    for (Eigen::MatrixXf* m : {&from_kpa_, &to_kpa_, &now_kpa_, &valves_, &before_, &now_}) {
      m->col(column) = m->col(last);
    }
  }
  motions_.pop_back();
}

struct ParallelForward::Threads {
  explicit Threads(int jobs) : arena(jobs) {}
  JobArena arena;
  tbb::enumerable_thread_specific<ForwardModel::Workspace> workspaces;
};

ParallelForward::ParallelForward(int jobs) : threads_(std::make_unique<Threads>(jobs)) {}
ParallelForward::~ParallelForward() = default;
ParallelForward::ParallelForward(ParallelForward&&) noexcept = default;
ParallelForward& ParallelForward::operator=(ParallelForward&&) noexcept = default;

int ParallelForward::jobs() const {
  return threads_->arena.jobs();
}

void ParallelForward::step_batch(const ForwardModel& model,
                                 const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                                 const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                                 const Eigen::Ref<const Eigen::MatrixXf>& previous,
                                 Eigen::Ref<Eigen::MatrixXf> next) {
  step_batch(model, previous_kpa, current_kpa, previous, previous, next);
}

void ParallelForward::step_batch(const ForwardModel& model,
                                 const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                                 const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                                 const Eigen::Ref<const Eigen::MatrixXf>& before,
                                 const Eigen::Ref<const Eigen::MatrixXf>& previous,
                                 Eigen::Ref<Eigen::MatrixXf> next) {
  const Eigen::Index parts = (next.cols() + kPart - 1) / kPart;
  threads_->arena.for_each(std::size_t(parts), [&](std::size_t part) {
    const Eigen::Index from = Eigen::Index(part) * kPart;
    const Eigen::Index count = std::min(kPart, next.cols() - from);
    model.step_batch(previous_kpa.middleCols(from, count), current_kpa.middleCols(from, count),
                     before.middleCols(from, count), previous.middleCols(from, count),
                     next.middleCols(from, count), threads_->workspaces.local());
  });
}

}  // namespace limber
