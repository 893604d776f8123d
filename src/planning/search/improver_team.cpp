#include "improver_team.hpp"

#include <span>
#include <utility>

namespace limber {

namespace {

constexpr std::uint64_t kChoiceStream = std::uint64_t{1} << 60;

}  // namespace

ImproverTeam::ImproverTeam(const PlanningProblem& problem, SecondOpinions& opinions, int size,
                           std::uint64_t seed)
    : choice_(seed, kChoiceStream) {
  for (int i = 0; i < size; ++i) {
    improvers_.emplace_back(problem, opinions, seed, static_cast<std::uint64_t>(i));
  }
}

std::optional<BatchSearch::Solution> ImproverTeam::take_waiting() {
  if (waiting_.empty()) {
    return std::nullopt;
  }
  const std::size_t index = choice_.index(static_cast<std::uint32_t>(waiting_.size()));
  const BatchSearch::Solution solution = waiting_[index];
  waiting_[index] = waiting_.back();
  waiting_.pop_back();
  return solution;
}

void ImproverTeam::call_plan(const BatchSearch& search, PlanImprover& improver) {
  const std::optional<BatchSearch::Solution> solution = take_waiting();
  if (!solution) {
    return;
  }
  std::vector<MotionState> states;
  for (const int node : search.tree().nodes_to(solution->node)) {
    states.push_back(search.tree().state(node));
  }
  improver.adopt(search.waypoints_to(solution->node), std::move(states), solution->held_tip);
}

bool ImproverTeam::round(const BatchSearch& search, PathSimulator& simulator,
                         const PlanLadder& ladder, const Offer& offer,
                         const std::function<bool()>& give_up) {
  std::vector<Proposal> proposals;
  std::vector<Path> batch;
  for (PlanImprover& improver : improvers_) {
    const bool is_best = improver.has_plan() && improver.merit_kpa() <= *ladder.best_merit_kpa();
    if (!improver.has_plan() || (improver.fruitless_rounds() > kPatience && !is_best)) {
      call_plan(search, improver);
    }
    proposals.push_back({{}, batch.size()});
    if (improver.has_plan()) {
      proposals.back().changes = improver.propose();
    }
    for (const PlanImprover::Change& change : proposals.back().changes) {
      batch.push_back(improver.path_of(change));
    }
  }
  if (batch.empty()) {
    return false;
  }
  const std::vector<PathOutcome> outcomes = simulator.run(batch, give_up);
  for (std::size_t i = 0; i < improvers_.size(); ++i) {
    PlanImprover& improver = improvers_[i];
    if (!improver.has_plan()) {
      continue;
    }
    const std::size_t count = proposals[i].changes.size();
    improver.settle(std::move(proposals[i].changes),
                    std::span(outcomes).subspan(proposals[i].first, count));
    if (improver.merit_kpa() < *ladder.best_merit_kpa() &&
        !offer(improver.waypoints_kpa(), improver.merit_kpa())) {
      improver.drop();
    }
  }
  return true;
}

}  // namespace limber
