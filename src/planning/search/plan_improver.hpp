#pragma once

#include <vector>

#include "goal_seeker.hpp"
#include "limber/common/random_stream.hpp"
#include "path_simulator.hpp"
#include "second_opinions.hpp"

namespace limber {

/// Makes a plan cheaper: leaves out, straightens, splits and shifts waypoints at random, several
/// changes at once. A change that is cheaper but ends beside the goal, or beyond its aim, is
/// shifted back into it. A change counts only after everything after it has been simulated again,
/// is free, and ends in the goal after the hold; otherwise friction would make it another plan.
/// Several improvers share a batch of the simulator: each proposes its paths, then all settle. All
/// arguments are borrowed. The result depends only on the seed, the stream and the number of
/// rounds.
class PlanImprover {
 public:
  /// @param stream  tells several improvers of one seed apart
  PlanImprover(const PlanningProblem& problem, SecondOpinions& opinions, std::uint64_t seed,
               std::uint64_t stream);

  /// Takes over a plan that is a solution.
  /// @param waypoints_kpa  start first
  /// @param states         at the waypoints
  /// @param held_tip       where it ends
  void adopt(std::vector<Pressures> waypoints_kpa, std::vector<MotionState> states,
             const Pose& held_tip);

  /// Drops its plan.
  void drop() { waypoints_kpa_.clear(); }

  bool has_plan() const { return !waypoints_kpa_.empty(); }
  const std::vector<Pressures>& waypoints_kpa() const { return waypoints_kpa_; }
  /// GoalAim::merit_kpa of it.
  double merit_kpa() const { return merit_kpa_; }
  /// Rounds since the merit last fell by more than a thousandth.
  int fruitless_rounds() const { return fruitless_rounds_; }

  /// Appends the paths of a few random changes. @pre has_plan
  void propose(std::vector<Path>& paths);
  /// Accepts the cheapest of those changes that holds, by all opinions. @param outcomes  of the
  /// paths proposed
  void settle(const PathOutcome* outcomes);

 private:
  struct Candidate {
    std::vector<Pressures> waypoints_kpa;
    std::size_t same;  // waypoints, from the start, that are as before
    double cost_kpa;
  };
  /// A change that is free, and ends beside the goal or beyond the aim.
  struct Miss {
    std::vector<Pressures> waypoints_kpa;
    Pose held_tip;
  };

  /// Changes candidate_kpa_; false if this plan cannot be changed so.
  bool leave_out(RandomStream& random);
  bool straighten(RandomStream& random);
  void shift_one(RandomStream& random);
  void shift_end(RandomStream& random);
  void shift_in_proportion(const Pressures& shift_kpa);
  bool split(RandomStream& random);
  void change(RandomStream& random);
  /// Makes candidate_kpa_ of a miss.
  void repair(const Miss& miss);
  Pressures random_shift(RandomStream& random) const;
  Pressures limited(const Pressures& pressures_kpa) const;
  void accept(std::size_t candidate, const PathOutcome& outcome);

  /// Proposes candidate_kpa_ where it is cheaper than the plan.
  void add_candidate(std::vector<Path>& paths);
  void go_on(std::vector<Path>& paths);
  void note_misses(const PathOutcome* outcomes);

  const PlanningProblem& problem_;
  SecondOpinions& opinions_;
  GoalAim aim_;
  std::uint64_t seed_;
  std::uint64_t stream_;
  Pressures limit_kpa_;
  PressureBox box_;
  std::vector<Pressures> waypoints_kpa_;
  std::vector<MotionState> states_;  // at the waypoints
  double merit_kpa_ = 0.0;
  double milestone_kpa_ = 0.0;  // merit when it last fell by enough
  int fruitless_rounds_ = 0;

  std::uint64_t changes_ = 0;
  std::vector<Pressures> candidate_kpa_;
  std::vector<Candidate> candidates_;
  std::vector<Pressures> before_kpa_;  // where the last round has changed it; else empty
  std::vector<Miss> misses_;           // of the last round
};

}  // namespace limber
