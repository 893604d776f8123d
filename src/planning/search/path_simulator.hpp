#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "goal_seeker.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/collision.hpp"

namespace limber {

/// Motions along straight lines of set points one after another from a known state.
struct Path {
  MotionState from;
  std::vector<Pressures> to_kpa;  ///< at least one
  bool hold = false;              ///< at its end in any case, not only near the goal
};

struct PathOutcome {
  bool free = false;             ///< every frame, and between frames
  bool in_goal = false;          ///< free, and after the hold at its end in the goal's region
  std::optional<Pose> held_tip;  ///< after that hold, where it was simulated and free
  std::vector<MotionState> at;   ///< after each motion; those not reached are absent
  std::uint64_t queries = 0;
};

/// Simulates many paths at once, in batches of the forward model, spread over threads. Every frame
/// is checked for collision; a path ends at its first collision, and the next path takes its
/// column. A path's outcome depends on the path alone: not on the others or on the number of
/// threads. Threads: one caller at a time. All arguments are borrowed.
class PathSimulator {
 public:
  /// @param jobs  threads to use, 0 for one per core
  PathSimulator(const PlanningProblem& problem, const CollisionChecker& checker, HoldRange range,
                int jobs);
  ~PathSimulator();

  /// @param give_up  asked now and then, on any thread; once it says so, paths not yet finished
  /// count as not free
  /// @return one outcome per path
  [[nodiscard]] std::vector<PathOutcome> run(const std::vector<Path>& paths,
                                             const std::function<bool()>& give_up);

  /// Of the forward model, by all runs.
  std::uint64_t queries() const { return queries_; }

 private:
  struct Threads;
  class Queue;
  class Worker;

  const PlanningProblem& problem_;
  const CollisionChecker& checker_;
  HoldRange range_;
  std::unique_ptr<Threads> threads_;
  std::uint64_t queries_ = 0;
};

}  // namespace limber
