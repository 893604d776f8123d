#include "limber/forward/parallel_forward.hpp"

#include <algorithm>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include "kernels/job_arena.hpp"

namespace limber {

namespace {

constexpr Eigen::Index kPart = 512;  // queries; about 0.1 ms, far above what handing over costs

}  // namespace

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
  threads_->arena.execute([&] {
    tbb::parallel_for(Eigen::Index{0}, parts, [&](Eigen::Index part) {
      const Eigen::Index from = part * kPart;
      const Eigen::Index count = std::min(kPart, next.cols() - from);
      model.step_batch(previous_kpa.middleCols(from, count), current_kpa.middleCols(from, count),
                       before.middleCols(from, count), previous.middleCols(from, count),
                       next.middleCols(from, count), threads_->workspaces.local());
    });
  });
}

}  // namespace limber
