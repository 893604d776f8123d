#include "plan_improver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kFirstStream = std::uint64_t{1} << 40;  // one stream a change from here
constexpr double kMinGainKpa = 1e-4;
constexpr double kNotableGain = 1e-3;  // of the cost
constexpr std::size_t kCandidates = 8;
constexpr int kTries = 128;          // random changes, to find as many that are cheaper
constexpr std::size_t kRepairs = 4;  // of a round's changes, those that would be the cheapest
constexpr double kInsideRim = 0.98;  // of the goal's tolerance, where a repair leads
constexpr double kMaxShift = 0.3;    // standard deviation, of the limit
constexpr double kMinShift = 0.002;
constexpr std::uint32_t kMaxLeftOut = 4;
constexpr double kSplitShare = 0.1;  // of the changes

/// The pose nearest to `tip` well inside the goal's region.
PoseGoal nearest_inside(const PoseGoal& goal, const Pose& tip) {
  PoseGoal inside = goal;
  const double distance = std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m);
  const double max_m = kInsideRim * goal.position_tolerance_m;
  const double share = distance > max_m ? max_m / distance : 1.0;
  inside.x_m += share * (tip.x_m - goal.x_m);
  inside.y_m += share * (tip.y_m - goal.y_m);
  if (goal.theta_rad) {
    const double max_rad = kInsideRim * goal.orientation_tolerance_rad;
    const double turn = std::remainder(tip.theta_rad - *goal.theta_rad, 2.0 * std::numbers::pi);
    inside.theta_rad = *goal.theta_rad + std::clamp(turn, -max_rad, max_rad);
  }
  return inside;
}

constexpr std::uint64_t kChoiceStream = std::uint64_t{1} << 60;

}  // namespace

Waypoints without_some(Waypoints waypoints_kpa, RandomStream& random) {
  const auto inner = std::uint32_t(waypoints_kpa.size()) - 2;
  const std::uint32_t first = 1 + random.index(inner);
  const std::uint32_t max_count = inner + 1 - first;
  const std::uint32_t count = 1 + random.index(std::min(max_count, kMaxLeftOut));
  waypoints_kpa.erase(waypoints_kpa.begin() + first, waypoints_kpa.begin() + first + count);
  return waypoints_kpa;
}

Waypoints straightened(Waypoints waypoints_kpa, RandomStream& random) {
  const auto count = std::uint32_t(waypoints_kpa.size());
  const std::uint32_t first = random.index(count - 2);
  const std::uint32_t last = first + 2 + random.index(count - first - 2);
  const auto segment = Eigen::Index(random.index(std::uint32_t(waypoints_kpa.front().size())));
  const float from = waypoints_kpa[first][segment];
  const float to = waypoints_kpa[last][segment];
  for (std::uint32_t i = first + 1; i < last; ++i) {
    waypoints_kpa[i][segment] = from + (to - from) * float(i - first) / float(last - first);
  }
  return waypoints_kpa;
}

Pressures random_shift(const ChangeSpace& space, RandomStream& random) {
  const double scale = kMinShift * std::pow(kMaxShift / kMinShift, random.uniform());
  const auto n = std::uint32_t(space.scale_kpa.size());
  const std::uint32_t only = random.index(2 * n);  // ≥ n: all of them
  Pressures shift = Pressures::Zero(space.scale_kpa.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (only >= n || only == i) {
      shift[i] = float(random.normal() * scale) * space.scale_kpa[i];
    }
  }
  return shift;
}

Waypoints with_end_shifted(Waypoints waypoints_kpa, const ChangeSpace& space,
                           const Pressures& shift_kpa) {
  const auto last = float(waypoints_kpa.size() - 1);
  for (std::size_t i = 1; i < waypoints_kpa.size(); ++i) {
    waypoints_kpa[i] = space.box.limited(waypoints_kpa[i] + shift_kpa * (float(i) / last));
  }
  return waypoints_kpa;
}

Waypoints split(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random) {
  if (waypoints_kpa.size() >= kMaxWaypoints) {
    return waypoints_kpa;
  }
  const std::uint32_t i = random.index(std::uint32_t(waypoints_kpa.size()) - 1);
  const auto share = float(random.uniform(0.2, 0.8));
  const Pressures between = waypoints_kpa[i] + share * (waypoints_kpa[i + 1] - waypoints_kpa[i]);
  waypoints_kpa.insert(waypoints_kpa.begin() + i + 1, space.box.limited(between));
  return waypoints_kpa;
}

Waypoints changed(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random) {
  // An added waypoint alone changes no cost: it comes with a change of the rest.
  if (random.uniform() < kSplitShare) {
    waypoints_kpa = split(std::move(waypoints_kpa), space, random);
  }
  const bool has_inner = waypoints_kpa.size() > 2;
  switch (const std::uint32_t kind = random.index(4)) {
    case 0:
    case 1:
      if (has_inner) {
        return kind == 0 ? without_some(std::move(waypoints_kpa), random)
                         : straightened(std::move(waypoints_kpa), random);
      }
      [[fallthrough]];
    case 2:
      return with_end_shifted(std::move(waypoints_kpa), space, random_shift(space, random));
    default: {  // one waypoint is moved, the end perhaps
      const std::size_t i = 1 + random.index(std::uint32_t(waypoints_kpa.size()) - 1);
      waypoints_kpa[i] = space.box.limited(waypoints_kpa[i] + random_shift(space, random));
      return waypoints_kpa;
    }
  }
}

PlanImprover::PlanImprover(const PlanningProblem& problem, SecondOpinions& opinions,
                           std::uint64_t seed, std::uint64_t stream)
    : problem_(problem),
      opinions_(opinions),
      aim_(problem),
      min_gain_kpa_(kMinGainKpa * command_per_kpa(problem.arm)),
      seed_(seed),
      stream_(kFirstStream * (1 + stream)),
      space_{pressure_scales_kpa(problem.arm), setpoints_of(problem)} {}

void PlanImprover::adopt(Waypoints waypoints_kpa, std::vector<MotionState> states,
                         const Pose& held_tip) {
  before_kpa_.clear();
  misses_.clear();
  waypoints_kpa_ = std::move(waypoints_kpa);
  states_ = std::move(states);
  merit_kpa_ = aim_.merit_kpa(path_cost_kpa(waypoints_kpa_), held_tip);
  if (aim_.beyond(held_tip) > 0.0) {
    misses_.push_back({waypoints_kpa_, held_tip});
  }
  milestone_kpa_ = merit_kpa_;
  fruitless_rounds_ = 0;
}

std::vector<PlanImprover::Change> PlanImprover::propose() {
  ++fruitless_rounds_;
  std::vector<Change> changes;
  if (waypoints_kpa_.size() < 2) {
    return changes;  // the start is in the goal
  }
  const auto add = [&](Waypoints waypoints_kpa) {
    if (std::optional<Change> change = cheaper(std::move(waypoints_kpa))) {
      changes.push_back(std::move(*change));
    }
  };
  for (const Miss& miss : misses_) {
    add(repaired(miss));
  }
  if (before_kpa_.size() == waypoints_kpa_.size()) {
    // What the last round changed may be worth changing farther.
    add(gone_on(1.0F));
    add(gone_on(3.0F));
  }
  for (int k = 0; k < kTries && changes.size() < kCandidates; ++k) {
    RandomStream random(seed_, stream_ + changes_++);
    add(changed(waypoints_kpa_, space_, random));
  }
  return changes;
}

/// By `factor` of what the last round has changed.
Waypoints PlanImprover::gone_on(float factor) const {
  Waypoints result = waypoints_kpa_;
  for (std::size_t i = 1; i < result.size(); ++i) {
    const Pressures step = waypoints_kpa_[i] - before_kpa_[i];
    result[i] = space_.box.limited(result[i] + factor * step);
  }
  return result;
}

/// Shifts it by the no-load model's Newton step from its end to the rim of the aim: cheap plans end
/// there, so that most changes that save something end just beyond.
Waypoints PlanImprover::repaired(const Miss& miss) const {
  const Pressures end = miss.waypoints_kpa.back();
  const PoseGoal target = nearest_inside(aim_.inner(), miss.held_tip);
  const Pressures to = step_toward_goal(problem_.model.no_load(), target, problem_.arm.length_m(),
                                        end, miss.held_tip);
  return with_end_shifted(miss.waypoints_kpa, space_, to - end);
}

std::optional<PlanImprover::Change> PlanImprover::cheaper(Waypoints waypoints_kpa) const {
  const double cost = path_cost_kpa(waypoints_kpa);
  if (cost >= merit_kpa_ - min_gain_kpa_) {
    return std::nullopt;
  }
  std::size_t same = 1;
  while (same < waypoints_kpa.size() && same < waypoints_kpa_.size() &&
         waypoints_kpa[same] == waypoints_kpa_[same]) {
    ++same;
  }
  same = std::min(same, waypoints_kpa.size() - 1);  // the last motion's hold is simulated again
  return Change{std::move(waypoints_kpa), same, cost};
}

Path PlanImprover::path_of(const Change& change) const {
  return {states_[change.same - 1],
          {change.waypoints_kpa.begin() + std::ptrdiff_t(change.same), change.waypoints_kpa.end()}};
}

void PlanImprover::settle(std::vector<Change> changes, std::span<const PathOutcome> outcomes) {
  misses_ = misses_of(changes, outcomes);
  before_kpa_.clear();
  std::vector<std::pair<double, std::size_t>> by_merit;
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (!outcomes[k].in_goal) {
      continue;
    }
    const double merit_kpa = aim_.merit_kpa(changes[k].cost_kpa, *outcomes[k].held_tip);
    if (merit_kpa < merit_kpa_ - min_gain_kpa_) {
      by_merit.emplace_back(merit_kpa, k);
    }
  }
  std::sort(by_merit.begin(), by_merit.end());
  for (const auto& [merit_kpa, k] : by_merit) {
    if (opinions_.agree(changes[k].waypoints_kpa)) {
      accept(std::move(changes[k]), outcomes[k]);
      return;
    }
  }
}

/// The cheapest of them.
std::vector<PlanImprover::Miss> PlanImprover::misses_of(
    const std::vector<Change>& changes, std::span<const PathOutcome> outcomes) const {
  std::vector<std::pair<double, std::size_t>> by_cost;
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (outcomes[k].held_tip &&
        (!outcomes[k].in_goal || aim_.beyond(*outcomes[k].held_tip) > 0.0)) {
      by_cost.emplace_back(changes[k].cost_kpa, k);
    }
  }
  std::sort(by_cost.begin(), by_cost.end());
  by_cost.resize(std::min(by_cost.size(), kRepairs));
  std::vector<Miss> misses;
  for (const auto& [cost_kpa, k] : by_cost) {
    misses.push_back({changes[k].waypoints_kpa, *outcomes[k].held_tip});
  }
  return misses;
}

void PlanImprover::accept(Change change, const PathOutcome& outcome) {
  states_.resize(change.same);
  states_.insert(states_.end(), outcome.at.begin(), outcome.at.end());
  before_kpa_ = std::exchange(waypoints_kpa_, std::move(change.waypoints_kpa));
  merit_kpa_ = aim_.merit_kpa(change.cost_kpa, *outcome.held_tip);
  if (merit_kpa_ < (1.0 - kNotableGain) * milestone_kpa_) {
    milestone_kpa_ = merit_kpa_;
    fruitless_rounds_ = 0;
  }
}

ImproverTeam::ImproverTeam(const PlanningProblem& problem, SecondOpinions& opinions, int size,
                           std::uint64_t seed)
    : choice_(seed, kChoiceStream) {
  for (int i = 0; i < size; ++i) {
    improvers_.emplace_back(problem, opinions, seed, std::uint64_t(i));
  }
}

std::optional<BatchSearch::Solution> ImproverTeam::take_waiting() {
  if (waiting_.empty()) {
    return std::nullopt;
  }
  const std::size_t index = choice_.index(std::uint32_t(waiting_.size()));
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
  auto states = mapped<MotionState>(search.tree().nodes_to(solution->node),
                                    [&](const int node) { return search.tree().state(node); });
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
