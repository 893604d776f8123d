#pragma once

#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "batch_search.hpp"
#include "limber/planning/forest.hpp"
#include "path_simulator.hpp"

namespace limber {

/// Looks through a forest for motions that an environment leaves free, and grafts them into a
/// search: first those that end in the goal, in turns the cheapest and any; where none of them is
/// free, those that end near it. A motion in collision rules out all that go on from it. Everything
/// given is borrowed.
class ForestSearch {
 public:
  /// @pre the forest was grown for the problem's arm, model and start
  ForestSearch(const Forest& forest, const PlanningProblem& problem, PathSimulator& simulator,
               BatchSearch& search, std::uint64_t seed);

  /// Tries a batch of motions. False where there is nothing more worth trying.
  bool round(const std::function<bool()>& give_up);

 private:
  void find_candidates(std::uint64_t seed);
  /// What is behind the last state known on the way to `node`, itself included; none where that is
  /// ruled out.
  std::optional<std::vector<int>> way_to(int node) const;
  void settle(const std::vector<int>& way, const PathOutcome& outcome);
  /// Hands the whole motion to the search. @return the search's node
  int graft(int node);

  const Forest& forest_;
  const PlanningProblem& problem_;
  PathSimulator& simulator_;
  BatchSearch& search_;
  std::vector<int> candidates_;  // of the forest's nodes, in the order to try
  std::size_t in_goal_ = 0;      // so many of them end in the goal
  std::size_t next_ = 0;
  int rounds_ = 0;
  int rounds_since_plan_ = 0;
  std::unordered_map<int, Backbone> known_;  // backbones at nodes that are free; empty: ruled out
  std::unordered_set<int> tried_;            // candidates
  std::unordered_map<int, int> grafted_;     // node of the forest → node of the search
  std::vector<Path> paths_;
  std::vector<std::vector<int>> ways_;
  std::vector<PathOutcome> outcomes_;
};

}  // namespace limber
