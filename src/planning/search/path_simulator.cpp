#include "path_simulator.hpp"

#include <algorithm>
#include <atomic>

#include <tbb/enumerable_thread_specific.h>

#include "kernels/job_arena.hpp"

namespace limber {

namespace {

constexpr std::size_t kWidth = 64;    // most paths that run side by side on one thread
constexpr std::size_t kMinWidth = 8;  // fewer are not worth another thread

}  // namespace

/// Paths of one call, taken by whoever has room: which thread simulates a path, and beside which
/// others, changes nothing about it.
class PathSimulator::Queue {
 public:
  Queue(const std::vector<Path>& paths, std::vector<PathOutcome>& outcomes)
      : paths_(paths), outcomes_(outcomes) {}

  /// The next path's number; none when all are taken.
  std::optional<int> take() {
    const std::size_t i = next_.fetch_add(1, std::memory_order_relaxed);
    return i < paths_.size() ? std::optional(int(i)) : std::nullopt;
  }
  const Path& path(int i) const { return paths_[i]; }
  PathOutcome& outcome(int i) { return outcomes_[i]; }

 private:
  const std::vector<Path>& paths_;
  std::vector<PathOutcome>& outcomes_;
  std::atomic<std::size_t> next_{0};
};

/// Some paths side by side on one thread; when one has ended, the next begins.
class PathSimulator::Worker {
 public:
  Worker(const PlanningProblem& problem, const CollisionChecker& checker, HoldRange range)
      : problem_(problem), checker_(checker), range_(range), rollouts_(problem.model) {
    if (problem.stay_within != nullptr) {
      novelty_ = problem.stay_within->make_workspace();
    }
  }

  /// @param width  paths side by side, at most
  void run(Queue& queue, std::size_t width, const std::function<bool()>& give_up) {
    rollouts_.clear();
    while (true) {
      fill(queue, int(width));
      if (rollouts_.size() == 0 || give_up()) {
        return;
      }
      note_pressures();
      rollouts_.step();
      for (int column = rollouts_.size() - 1; column >= 0; --column) {
        const int i = rollouts_.label(column);
        judge(column, queue.path(i), queue.outcome(i));
      }
    }
  }

 private:
  void fill(Queue& queue, int width) {
    while (rollouts_.size() < width) {
      const std::optional<int> i = queue.take();
      if (!i) {
        return;
      }
      const Path& path = queue.path(*i);
      start_motion(*i, path, path.from, 0);
    }
  }

  void start_motion(int i, const Path& path, const MotionState& from, std::size_t motion) {
    const Pressures& to = path.to_kpa[motion];
    rollouts_.add(
        i, from, to,
        motion_frame_count(from.setpoint_kpa(), to, problem_.arm.pressure_step_limit_kpa()));
  }

  // A frame later: on, or out.
  void judge(int column, const Path& path, PathOutcome& outcome) {
    ++outcome.queries;
    if (!is_allowed(column)) {
      rollouts_.remove(column);  // a path that is free up to its hold stays so
      return;
    }
    if (!rollouts_.has_ended(column)) {
      return;
    }
    const int i = rollouts_.label(column);
    MotionState now = rollouts_.state(column);
    rollouts_.remove(column);
    const bool held = outcome.at.size() == path.to_kpa.size();
    if (held) {
      outcome.held_tip = tip_pose(now.backbone);
      outcome.in_goal = is_within(problem_.environment.goal,
                                  pose_error(problem_.environment.goal, *outcome.held_tip));
      return;
    }
    outcome.at.push_back(std::move(now));
    const MotionState& end = outcome.at.back();
    if (outcome.at.size() < path.to_kpa.size()) {
      start_motion(i, path, end, outcome.at.size());
      return;
    }
    outcome.free = true;
    if (path.hold || is_near_goal(end)) {
      rollouts_.add(i, end, path.to_kpa.back(),
                    hold_frame_count(problem_.arm, problem_.model.valves(), end.valves));
    }
  }

  bool is_allowed(int column) {
    const auto now = rollouts_.now(column);
    return checker_.is_motion_free(rollouts_.before(column), now) &&
           (problem_.stay_within == nullptr ||
            problem_.stay_within->holds(before_kpa_.col(column),
                                        rollouts_.valves(column).head(before_kpa_.rows()),
                                        rollouts_.before(column), now, novelty_));
  }

  /// Of every motion, before its next frame: what rates are taken from.
  void note_pressures() {
    if (problem_.stay_within == nullptr) {
      return;
    }
    const Eigen::Index n = problem_.arm.segment_count();
    before_kpa_.resize(n, rollouts_.size());
    for (int column = 0; column < rollouts_.size(); ++column) {
      before_kpa_.col(column) = rollouts_.valves(column).head(n);
    }
  }

  bool is_near_goal(const MotionState& state) const {
    return range_.reaches(problem_.environment.goal,
                          problem_.model.settled_tip(state.valves, state.backbone));
  }

  const PlanningProblem& problem_;
  const CollisionChecker& checker_;
  HoldRange range_;
  RolloutBatch rollouts_;
  RecordedRegion::Workspace novelty_;
  Eigen::MatrixXf before_kpa_;  // n × motions, a frame ago
};

struct PathSimulator::Threads {
  explicit Threads(int jobs) : arena(jobs) {}
  JobArena arena;
  tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers;
};

PathSimulator::PathSimulator(const PlanningProblem& problem, const CollisionChecker& checker,
                             HoldRange range, int jobs)
    : problem_(problem),
      checker_(checker),
      range_(range),
      threads_(std::make_unique<Threads>(jobs)) {}

PathSimulator::~PathSimulator() = default;

std::vector<PathOutcome> PathSimulator::run(const std::vector<Path>& paths,
                                            const std::function<bool()>& give_up) {
  std::vector<PathOutcome> outcomes(paths.size());
  Queue queue(paths, outcomes);
  const std::size_t threads =
      std::clamp(paths.size() / kMinWidth, std::size_t{1}, std::size_t(threads_->arena.jobs()));
  const std::size_t width = std::min(kWidth, (paths.size() + threads - 1) / threads);
  const auto run_thread = [&](std::size_t) {
    std::unique_ptr<Worker>& worker = threads_->workers.local();
    if (!worker) {
      worker = std::make_unique<Worker>(problem_, checker_, range_);
    }
    worker->run(queue, width, give_up);
  };
  if (threads == 1) {
    run_thread(0);
  } else {
    threads_->arena.for_each(threads, run_thread);
  }
  for (const PathOutcome& outcome : outcomes) {
    queries_ += outcome.queries;
  }
  return outcomes;
}

}  // namespace limber
