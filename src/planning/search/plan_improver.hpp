#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "batch_search.hpp"
#include "goal_seeker.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/pressure_box.hpp"
#include "path_simulator.hpp"
#include "plan_ladder.hpp"
#include "second_opinions.hpp"

namespace limber {

/// A plan's set points, start first: at least two.
using Waypoints = std::vector<Pressures>;

/// Where changes of waypoints lead, and how far.
struct ChangeSpace {
  Pressures scale_kpa;  ///< size n, what shifts are a fraction of
  PressureBox box;      ///< changed set points stay in there
};

/// Changes of a plan's waypoints. Each takes the waypoints and returns them changed; the start
/// stays as it is. What is random depends on the stream alone.

/// Without one to four waypoints in a row; start and end stay. @pre at least three waypoints
Waypoints without_some(Waypoints waypoints_kpa, RandomStream& random);

/// One segment's pressure runs evenly between two waypoints: the cost counts reversals only.
/// @pre at least three waypoints
Waypoints straightened(Waypoints waypoints_kpa, RandomStream& random);

/// The end is moved by `shift_kpa`, and the waypoints before it in proportion to how far along
/// they are.
Waypoints with_end_shifted(Waypoints waypoints_kpa, const ChangeSpace& space,
                           const Pressures& shift_kpa);

/// One more waypoint on the straight line between two, for later changes to move; none where there
/// are kMaxWaypoints.
Waypoints split(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random);
inline constexpr std::size_t kMaxWaypoints = 40;

/// A shift, normal, of a scale that is even in its logarithm, along all segments or one of them.
Pressures random_shift(const ChangeSpace& space, RandomStream& random);

/// Any one of those, and sometimes a split before it.
Waypoints changed(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random);

/// Makes a plan cheaper: leaves out, straightens, splits and shifts waypoints at random, some ways
/// at once; what is cheaper and ends beside the goal, or beyond its aim, is shifted back into it. A
/// change counts only after everything behind it has been simulated again, found free, and ends in
/// the goal after the hold: elsewhere friction would make the plan another one. Several improvers
/// share a batch of the simulator: each proposes its changes, then all settle. Everything given is
/// borrowed. What it does depends on the seed, the stream and the number of rounds alone.
class PlanImprover {
 public:
  /// A plan that would cost less, not yet simulated.
  struct Change {
    Waypoints waypoints_kpa;
    std::size_t same;  ///< waypoints, from the start, that are as they are now; at least one
    double cost_kpa;
  };

  /// @param stream  tells several improvers of one seed apart
  PlanImprover(const PlanningProblem& problem, SecondOpinions& opinions, std::uint64_t seed,
               std::uint64_t stream);

  /// Takes over a plan that is a solution.
  /// @param waypoints_kpa  start first
  /// @param states         at the waypoints
  /// @param held_tip       where it ends
  void adopt(Waypoints waypoints_kpa, std::vector<MotionState> states, const Pose& held_tip);

  /// Drops its plan.
  void drop() { waypoints_kpa_.clear(); }

  bool has_plan() const { return !waypoints_kpa_.empty(); }
  const Waypoints& waypoints_kpa() const { return waypoints_kpa_; }
  /// At the waypoints.
  const std::vector<MotionState>& states() const { return states_; }
  /// GoalAim::merit_kpa of it.
  double merit_kpa() const { return merit_kpa_; }
  /// Rounds since the merit last fell by more than a thousandth.
  int fruitless_rounds() const { return fruitless_rounds_; }

  /// A round's changes, a few, all cheaper than the plan. @pre has_plan
  std::vector<Change> propose();
  /// What has to be simulated of a change: all behind the waypoints that are the same.
  Path path_of(const Change& change) const;
  /// Accepts the best of those changes that holds, by all opinions.
  /// @param changes   that were proposed last
  /// @param outcomes  of their paths, one per change
  void settle(std::vector<Change> changes, std::span<const PathOutcome> outcomes);

 private:
  /// A change that is free, and ends beside the goal or beyond the aim.
  struct Miss {
    Waypoints waypoints_kpa;
    Pose held_tip;
  };

  /// As a change of the plan, where it is cheaper.
  std::optional<Change> cheaper(Waypoints waypoints_kpa) const;
  Waypoints repaired(const Miss& miss) const;
  Waypoints gone_on(float factor) const;
  std::vector<Miss> misses_of(const std::vector<Change>& changes,
                              std::span<const PathOutcome> outcomes) const;
  void accept(Change change, const PathOutcome& outcome);

  const PlanningProblem& problem_;
  SecondOpinions& opinions_;
  GoalAim aim_;
  double min_gain_kpa_;
  std::uint64_t seed_;
  std::uint64_t stream_;
  ChangeSpace space_;
  Waypoints waypoints_kpa_;
  std::vector<MotionState> states_;  // at the waypoints
  double merit_kpa_ = 0.0;
  double milestone_kpa_ = 0.0;  // merit when it last fell by enough
  int fruitless_rounds_ = 0;
  std::uint64_t changes_ = 0;  // thought of, over all rounds
  Waypoints before_kpa_;       // where the last round has changed the plan; else empty
  std::vector<Miss> misses_;   // of the last round
};

/// Some of the plans that a search has found, improved side by side. One that gets no cheaper, and
/// is not the best, gives its place to another that waits; each has its turn once. Everything given
/// is borrowed. What it does depends on the seed, the plans that wait and the number of rounds
/// alone.
class ImproverTeam {
 public:
  /// Tells of a plan that is better than all before; false where it may not be built upon.
  using Offer = std::function<bool(const Waypoints& waypoints_kpa, double merit_kpa)>;

  /// Rounds without success until a plan that is not the best goes.
  static constexpr int kPatience = 15;

  /// @param size  plans in work at once, ≥ 0
  ImproverTeam(const PlanningProblem& problem, SecondOpinions& opinions, int size,
               std::uint64_t seed);

  /// A plan that waits for its turn from now on.
  void add(const BatchSearch::Solution& solution) { waiting_.push_back(solution); }
  std::size_t waiting_count() const { return waiting_.size(); }
  /// Another search begins: nodes of the last one's tree mean nothing any more.
  void forget_waiting() { waiting_.clear(); }

  /// A batch of changes of all plans in work. @pre there is a plan on the ladder
  /// @param search  whose tree the plans are in
  /// @param ladder  of the plans that were offered
  /// @return whether there was anything to try
  bool round(const BatchSearch& search, PathSimulator& simulator, const PlanLadder& ladder,
             const Offer& offer, const std::function<bool()>& give_up);

 private:
  /// The changes of one improver, and where their paths begin in the batch.
  struct Proposal {
    std::vector<PlanImprover::Change> changes;
    std::size_t first = 0;
  };

  /// Any that waits: the cheapest are mostly akin.
  std::optional<BatchSearch::Solution> take_waiting();
  void call_plan(const BatchSearch& search, PlanImprover& improver);

  std::vector<PlanImprover> improvers_;
  std::vector<BatchSearch::Solution> waiting_;  // that no improver has had
  RandomStream choice_;
};

}  // namespace limber
