#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "batch_search.hpp"
#include "limber/common/random_stream.hpp"
#include "path_simulator.hpp"
#include "plan_improver.hpp"
#include "plan_ladder.hpp"

namespace limber {

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
