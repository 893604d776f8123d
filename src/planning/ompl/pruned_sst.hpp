#pragma once

#include <ompl/control/PathControl.h>
#include <ompl/control/planners/sst/SST.h>

#include <optional>

namespace limber {

struct SstCounts {
  std::size_t active = 0;     ///< nodes that may still be extended
  std::size_t inactive = 0;   ///< dominated, kept because they have children
  std::size_t witnesses = 0;  ///< in a sparse tree at least as many as active nodes
};

/// OMPL's SST with its nodes counted, and with its best motion for whoever looks while it searches.
class CountedSst : public ompl::control::SST {
 public:
  using SST::SST;
  SstCounts counts() const;

  /// Cost of the best motion to the goal so far, if there is one.
  std::optional<double> solution_cost() const;
  /// That motion; before there is one, the motion that ended nearest. @pre a motion was kept
  ompl::control::PathControl kept_path() const;
};

/// Stable sparse RRT (Li, Littlefield, Bekris 2016) on OMPL's data structures, with the pruning
/// that OMPL 1.5's version lacks: its loop that deactivates and frees dominated nodes only takes
/// inactive ones, and nothing ever makes a node inactive.
class PrunedSst final : public CountedSst {
 public:
  using CountedSst::CountedSst;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override;

 private:
  void add_starts();
  /// Takes the new node into the tree where no cheaper one is near. @return null if one is.
  Motion* accept(Motion* reached, Motion* from, unsigned int frames);
  void prune(Motion* dominated);
  void keep_solution(const Motion* end);
  /// A random state, biased towards the goal, into `sample`.
  void sample_state(Motion& sample);
  /// Extends the tree towards the state of `sample`, which is overwritten. @return the new node, or
  /// null where the motion collides or a cheaper node is near.
  Motion* extend(Motion& sample);
  /// The kept solution as OMPL's path; `nearest` is how far a partial one stays from the goal.
  ompl::base::PlannerStatus hand_over(bool exact, double nearest);
};

}  // namespace limber
