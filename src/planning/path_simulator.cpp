#include "path_simulator.hpp"

#include <algorithm>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include "common/job_arena.hpp"

namespace limber {

namespace {

constexpr std::size_t kPart = 32;  // paths that run side by side on one thread

}  // namespace

/// Some paths side by side on one thread.
class PathSimulator::Worker {
 public:
  Worker(const PlanningProblem& problem, const CollisionChecker& checker, HoldRange range)
      : problem_(problem),
        checker_(checker),
        range_(range),
        hold_frames_(hold_frame_count(problem.arm)),
        rollouts_(problem.model) {}

  void run(const Path* paths, PathOutcome* outcomes, int count,
           const std::function<bool()>& give_up) {
    rollouts_.clear();
    for (int i = 0; i < count; ++i) {
      outcomes[i].free = false;
      outcomes[i].in_goal = false;
      outcomes[i].held_tip.reset();
      outcomes[i].at.clear();
      outcomes[i].queries = 0;
      start_motion(i, paths[i], paths[i].from_kpa, paths[i].from, 0);
    }
    while (rollouts_.size() > 0 && !give_up()) {
      rollouts_.step();
      for (int column = rollouts_.size() - 1; column >= 0; --column) {
        const int i = rollouts_.label(column);
        judge(column, paths[i], outcomes[i]);
      }
    }
  }

 private:
  void start_motion(int i, const Path& path, const PressuresRef& from_kpa, const BackboneRef& from,
                    std::size_t motion) {
    const Pressures& to = path.to_kpa[motion];
    rollouts_.add(i, from_kpa, from, to,
                  motion_frame_count(from_kpa, to, problem_.arm.pressure_step_limit_kpa()));
  }

  // A frame later: on, or out.
  void judge(int column, const Path& path, PathOutcome& outcome) {
    ++outcome.queries;
    if (!checker_.is_motion_free(rollouts_.before(column), rollouts_.now(column))) {
      rollouts_.remove(column);  // a path that is free up to its hold stays so
      return;
    }
    if (!rollouts_.has_ended(column)) {
      return;
    }
    const int i = rollouts_.label(column);
    const Backbone now = rollouts_.now(column);
    rollouts_.remove(column);
    const bool held = outcome.at.size() == path.to_kpa.size();
    if (held) {
      outcome.held_tip = tip_pose<float>(now);
      outcome.in_goal = is_within(problem_.environment.goal,
                                  pose_error(problem_.environment.goal, *outcome.held_tip));
      return;
    }
    outcome.at.push_back(now);
    if (outcome.at.size() < path.to_kpa.size()) {
      start_motion(i, path, path.to_kpa[outcome.at.size() - 1], now, outcome.at.size());
      return;
    }
    outcome.free = true;
    if (is_near_goal(now)) {
      rollouts_.add(i, path.to_kpa.back(), now, path.to_kpa.back(), hold_frames_);
    }
  }

  bool is_near_goal(const BackboneRef& backbone) const {
    const PoseGoal& goal = problem_.environment.goal;
    const PoseError error = pose_error(goal, tip_pose(backbone));
    return error.position_m <= goal.position_tolerance_m + range_.position_m &&
           error.orientation_rad <= goal.orientation_tolerance_rad + range_.orientation_rad;
  }

  const PlanningProblem& problem_;
  const CollisionChecker& checker_;
  HoldRange range_;
  int hold_frames_;
  RolloutBatch rollouts_;
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

void PathSimulator::run(const std::vector<Path>& paths, std::vector<PathOutcome>& outcomes,
                        const std::function<bool()>& give_up) {
  outcomes.resize(paths.size());
  const std::size_t parts = (paths.size() + kPart - 1) / kPart;
  const auto run_part = [&](std::size_t part) {
    std::unique_ptr<Worker>& worker = threads_->workers.local();
    if (!worker) {
      worker = std::make_unique<Worker>(problem_, checker_, range_);
    }
    const std::size_t from = part * kPart;
    worker->run(&paths[from], &outcomes[from],
                static_cast<int>(std::min(kPart, paths.size() - from)), give_up);
  };
  if (parts == 1) {
    run_part(0);
  } else {
    threads_->arena.execute([&] { tbb::parallel_for(std::size_t{0}, parts, run_part); });
  }
  for (const PathOutcome& outcome : outcomes) {
    queries_ += outcome.queries;
  }
}

}  // namespace limber
