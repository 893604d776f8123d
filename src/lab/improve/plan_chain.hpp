#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "limber/run/plan_controller.hpp"
#include "plan_runs.hpp"

namespace limber {

/// An environment, and the plan made in it.
struct PlannedRun {
  PlanRun run;              ///< its number and status
  Environment environment;  ///< with where the arm starts
  std::optional<Plan> plan;
};

/// Plans that follow one another without venting: each in the next environment, which is sampled
/// about where the arm rests after the plan before. An environment without a plan is passed over.
///
/// Threads: the executor's. `observe` may come while `next` searches.
class PlanChain final : public PlanController {
 public:
  /// Samples environment `number` for an arm at rest at `start` (none: vented), and plans in it.
  using PlanIn = std::function<PlannedRun(int number, const std::optional<ArmStart>& start)>;

  /// Environments [first, first + count). No plan begins after `max_s` of arm time.
  PlanChain(const ArmDescription& arm, int first, int count, double max_s, PlanIn plan_in);

  /// The first environment that has a plan for the vented arm; null if none has. It stays where it
  /// is as long as the chain.
  const PlannedRun* first_plan();

  /// What became of the environments, after `run`. A chain of one plan is judged as the executor
  /// judged it; the plans of a longer one each in its own environment, on the frames recorded. The
  /// plans are the motions of one episode.
  PlanRuns ended(const ExecutionResult& run) const;

 private:
  /// Where a plan lies in the run, in frames since the start; the last is that of its hold.
  struct Executed {
    std::size_t planned = 0;  ///< which of `tried_`
    int first_frame = 0;
    int last_frame = 0;
  };

  void observe(const ArmEstimate& arm) override { seen_ = arm.frames() + 1; }
  FrameSetpoint setpoint(const PlanProgress& at, std::size_t next, const ArmEstimate& arm) override;
  NextPlan next(const PlanProgress& at, const ArmEstimate& arm) override;

  bool has_held_for_long() const;
  const PlannedRun* plan_from(const std::optional<ArmStart>& start);
  void judge(const Episode& episode, const Executed& frames, const Environment& environment,
             PlanRun& run) const;

  const ArmDescription& arm_;
  int next_;  // environment
  int end_;
  double max_s_;
  PlanIn plan_in_;
  std::vector<PlannedRun> tried_;
  std::vector<Executed> executed_;
  std::atomic<int> seen_ = 0;  // states, the start's among them
};

}  // namespace limber
