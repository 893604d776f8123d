#include "counted_sst.hpp"

#include <cmath>
#include <vector>

namespace limber {

SstCounts CountedSst::counts() const {
  SstCounts counts;
  std::vector<Motion*> motions;
  if (nn_) {
    nn_->list(motions);
  }
  for (const Motion* motion : motions) {
    ++(motion->inactive_ ? counts.inactive : counts.active);
  }
  counts.witnesses = witnesses_ ? witnesses_->size() : 0;
  return counts;
}

std::optional<double> CountedSst::solution_cost() const {
  const double cost = prevSolutionCost_.value();
  return prevSolution_.empty() || std::isinf(cost) ? std::nullopt : std::optional(cost);
}

ompl::control::PathControl CountedSst::kept_path() const {
  ompl::control::PathControl path(si_);
  for (std::size_t i = prevSolution_.size(); i-- > 1;) {
    path.append(prevSolution_[i], prevSolutionControls_[i - 1],
                prevSolutionSteps_[i - 1] * siC_->getPropagationStepSize());
  }
  path.append(prevSolution_.front());
  return path;
}

}  // namespace limber
