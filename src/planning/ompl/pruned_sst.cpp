#include "pruned_sst.hpp"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

#include <cmath>
#include <limits>

namespace limber {

namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

}  // namespace

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

oc::PathControl CountedSst::kept_path() const {
  oc::PathControl path(si_);
  for (std::size_t i = prevSolution_.size(); i-- > 1;) {
    path.append(prevSolution_[i], prevSolutionControls_[i - 1],
                prevSolutionSteps_[i - 1] * siC_->getPropagationStepSize());
  }
  path.append(prevSolution_.front());
  return path;
}

void PrunedSst::add_starts() {
  while (const ob::State* start = pis_.nextStart()) {
    auto* root = new Motion(siC_);
    si_->copyState(root->state_, start);
    siC_->nullControl(root->control_);
    root->accCost_ = opt_->identityCost();
    nn_->add(root);
    findClosestWitness(root);
  }
}

oc::SST::Motion* PrunedSst::accept(Motion* reached, Motion* from, unsigned int frames) {
  const ob::Cost cost =
      opt_->combineCosts(from->accCost_, opt_->motionCost(from->state_, reached->state_));
  Witness* witness = findClosestWitness(reached);
  Motion* before = witness->rep_ == reached ? nullptr : witness->rep_;
  if (before != nullptr && !opt_->isCostBetterThan(cost, before->accCost_)) {
    return nullptr;
  }
  auto* node = new Motion(siC_);
  si_->copyState(node->state_, reached->state_);
  siC_->copyControl(node->control_, reached->control_);
  node->accCost_ = cost;
  node->steps_ = frames;
  node->parent_ = from;
  ++from->numChildren_;
  witness->linkRep(node);
  nn_->add(node);
  if (before != nullptr) {
    before->inactive_ = true;
    prune(before);
  }
  return node;
}

/// Frees a dominated leaf, and its parent if that was dominated and is now a leaf too.
void PrunedSst::prune(Motion* dominated) {
  while (dominated != nullptr && dominated->inactive_ && dominated->numChildren_ == 0 &&
         dominated->parent_ != nullptr) {
    Motion* parent = dominated->parent_;
    nn_->remove(dominated);
    si_->freeState(dominated->state_);
    siC_->freeControl(dominated->control_);
    delete dominated;
    --parent->numChildren_;
    dominated = parent;
  }
}

void PrunedSst::keep_solution(const Motion* end) {
  for (ob::State* state : prevSolution_) {
    si_->freeState(state);
  }
  for (oc::Control* control : prevSolutionControls_) {
    siC_->freeControl(control);
  }
  prevSolution_.clear();
  prevSolutionControls_.clear();
  prevSolutionSteps_.clear();
  for (const Motion* node = end; node != nullptr; node = node->parent_) {
    prevSolution_.push_back(si_->cloneState(node->state_));
    if (node->parent_ != nullptr) {
      prevSolutionControls_.push_back(siC_->cloneControl(node->control_));
      prevSolutionSteps_.push_back(node->steps_);
    }
  }
}

void PrunedSst::sample_state(Motion& sample) {
  auto* region = dynamic_cast<ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (region != nullptr && rng_.uniform01() < goalBias_ && region->canSample()) {
    region->sampleGoal(sample.state_);
  } else {
    sampler_->sampleUniform(sample.state_);
  }
}

oc::SST::Motion* PrunedSst::extend(Motion& sample) {
  Motion* from = selectNode(&sample);
  controlSampler_->sample(sample.control_);
  const auto frames =
      static_cast<unsigned int>(rng_.uniformInt(static_cast<int>(siC_->getMinControlDuration()),
                                                static_cast<int>(siC_->getMaxControlDuration())));
  if (siC_->propagateWhileValid(from->state_, sample.control_, static_cast<int>(frames),
                                sample.state_) != frames) {
    return nullptr;
  }
  return accept(&sample, from, frames);
}

ob::PlannerStatus PrunedSst::hand_over(bool exact, double nearest) {
  if (prevSolution_.empty()) {
    return ob::PlannerStatus::TIMEOUT;
  }
  const auto path = std::make_shared<oc::PathControl>(kept_path());
  pdef_->addSolutionPath(path, !exact, exact ? 0.0 : nearest, getName());
  return {true, !exact};
}

ob::PlannerStatus PrunedSst::solve(const ob::PlannerTerminationCondition& stop) {
  checkValidity();
  add_starts();
  if (nn_->size() == 0) {
    return ob::PlannerStatus::INVALID_START;
  }
  if (!sampler_) {
    sampler_ = si_->allocStateSampler();
  }
  if (!controlSampler_) {
    controlSampler_ = siC_->allocControlSampler();
  }
  const ob::Goal* goal = pdef_->getGoal().get();
  Motion sample(siC_);
  double nearest = std::numeric_limits<double>::infinity();
  bool exact = false;
  while (!stop) {
    sample_state(sample);
    const Motion* node = extend(sample);
    if (node == nullptr) {
      continue;
    }
    double distance = 0.0;
    const bool satisfied = goal->isSatisfied(node->state_, &distance);
    if (satisfied && opt_->isCostBetterThan(node->accCost_, prevSolutionCost_)) {
      exact = true;
      prevSolutionCost_ = node->accCost_;
      keep_solution(node);
      if (opt_->isSatisfied(node->accCost_)) {
        break;
      }
    } else if (!exact && distance < nearest) {
      nearest = distance;
      keep_solution(node);
    }
  }
  si_->freeState(sample.state_);
  siC_->freeControl(sample.control_);
  return hand_over(exact, nearest);
}

}  // namespace limber
