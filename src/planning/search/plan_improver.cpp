#include "plan_improver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "goal_seeker.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kFirstStream = std::uint64_t{1} << 40;  // one stream a change from here
constexpr double kImprovementKpa = 1e-4;
constexpr double kNotable = 1e-3;  // of the cost
constexpr double kMaxShift = 0.3;  // standard deviation, of the limit
constexpr double kMinShift = 0.002;
constexpr std::size_t kCandidates = 8;
constexpr int kTries = 128;  // random changes, to find as many that are cheaper
constexpr std::size_t kMaxWaypoints = 40;
constexpr std::size_t kRepairs = 4;  // of a round's changes, those that would be the cheapest
constexpr double kInsideRim = 0.98;  // of the goal's tolerance, where a repair leads

/// The pose nearest to `tip` well inside the goal's region.
PoseGoal nearest_inside(const PoseGoal& goal, const Pose& tip) {
  PoseGoal inside = goal;
  const double distance = std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m);
  const double most = kInsideRim * goal.position_tolerance_m;
  const double share = distance > most ? most / distance : 1.0;
  inside.x_m += share * (tip.x_m - goal.x_m);
  inside.y_m += share * (tip.y_m - goal.y_m);
  if (goal.theta_rad) {
    const double max_rad = kInsideRim * goal.orientation_tolerance_rad;
    const double turn = std::remainder(tip.theta_rad - *goal.theta_rad, 2.0 * std::numbers::pi);
    inside.theta_rad = *goal.theta_rad + std::clamp(turn, -max_rad, max_rad);
  }
  return inside;
}

}  // namespace

PlanImprover::PlanImprover(const PlanningProblem& problem, SecondOpinions& opinions,
                           std::uint64_t seed, std::uint64_t stream)
    : problem_(problem),
      opinions_(opinions),
      aim_(problem),
      seed_(seed),
      stream_(kFirstStream * (1 + stream)),
      limit_kpa_(pressure_limits_kpa(problem.arm)),
      box_(setpoints_of(problem)) {}

void PlanImprover::adopt(std::vector<Pressures> waypoints_kpa, std::vector<MotionState> states,
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

Pressures PlanImprover::limited(const Pressures& pressures_kpa) const {
  return box_.limited(pressures_kpa);
}

/// Removes one to a few waypoints in a row; start and end stay.
bool PlanImprover::leave_out(RandomStream& random) {
  if (candidate_kpa_.size() <= 2) {
    return false;
  }
  const auto inner = static_cast<std::uint32_t>(candidate_kpa_.size()) - 2;
  const std::uint32_t first = 1 + random.index(inner);
  const std::uint32_t most = inner + 1 - first;
  const std::uint32_t count = 1 + random.index(std::min(most, 4U));
  candidate_kpa_.erase(candidate_kpa_.begin() + first, candidate_kpa_.begin() + first + count);
  return true;
}

/// Runs one segment's pressure evenly between two waypoints: the cost counts reversals only.
bool PlanImprover::straighten(RandomStream& random) {
  if (candidate_kpa_.size() <= 2) {
    return false;
  }
  const auto count = static_cast<std::uint32_t>(candidate_kpa_.size());
  const std::uint32_t first = random.index(count - 2);
  const std::uint32_t last = first + 2 + random.index(count - first - 2);
  const auto segment =
      static_cast<Eigen::Index>(random.index(static_cast<std::uint32_t>(limit_kpa_.size())));
  const float from = candidate_kpa_[first][segment];
  const float to = candidate_kpa_[last][segment];
  for (std::uint32_t i = first + 1; i < last; ++i) {
    candidate_kpa_[i][segment] = from + (to - from) * float(i - first) / float(last - first);
  }
  return true;
}

/// Normal, of a scale drawn evenly in its logarithm, along all segments or one of them.
Pressures PlanImprover::random_shift(RandomStream& random) const {
  const double scale = kMinShift * std::pow(kMaxShift / kMinShift, random.uniform());
  const auto n = static_cast<std::uint32_t>(limit_kpa_.size());
  const std::uint32_t only = random.index(2 * n);  // ≥ n: all of them
  Pressures shift = Pressures::Zero(limit_kpa_.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (only >= n || only == i) {
      shift[i] = static_cast<float>(random.normal() * scale) * limit_kpa_[i];
    }
  }
  return shift;
}

void PlanImprover::shift_one(RandomStream& random) {
  const std::size_t i = 1 + random.index(static_cast<std::uint32_t>(candidate_kpa_.size()) - 1);
  candidate_kpa_[i] = limited(candidate_kpa_[i] + random_shift(random));
}

void PlanImprover::shift_end(RandomStream& random) {
  shift_in_proportion(random_shift(random));
}

/// Shifts the end, and the waypoints before it in proportion to how far along they are.
void PlanImprover::shift_in_proportion(const Pressures& shift_kpa) {
  const auto last = static_cast<float>(candidate_kpa_.size() - 1);
  for (std::size_t i = 1; i < candidate_kpa_.size(); ++i) {
    candidate_kpa_[i] = limited(candidate_kpa_[i] + shift_kpa * (float(i) / last));
  }
}

/// Puts a waypoint between two, for later changes to move.
bool PlanImprover::split(RandomStream& random) {
  if (candidate_kpa_.size() >= kMaxWaypoints) {
    return false;
  }
  const std::uint32_t i = random.index(static_cast<std::uint32_t>(candidate_kpa_.size()) - 1);
  const auto share = static_cast<float>(random.uniform(0.2, 0.8));
  const Pressures between = candidate_kpa_[i] + share * (candidate_kpa_[i + 1] - candidate_kpa_[i]);
  candidate_kpa_.insert(candidate_kpa_.begin() + i + 1, limited(between));
  return true;
}

void PlanImprover::change(RandomStream& random) {
  // An added waypoint alone changes no cost: it comes with a shift of the rest.
  if (random.uniform() < 0.1) {
    split(random);
  }
  switch (random.index(4)) {
    case 0:
      leave_out(random) ? void() : shift_end(random);
      break;
    case 1:
      straighten(random) ? void() : shift_end(random);
      break;
    case 2:
      shift_end(random);
      break;
    default:
      shift_one(random);
  }
}

void PlanImprover::propose(std::vector<Path>& paths) {
  candidates_.clear();
  ++fruitless_rounds_;
  if (waypoints_kpa_.size() < 2) {
    return;  // the start is in the goal
  }
  for (const Miss& miss : misses_) {
    repair(miss);
    add_candidate(paths);
  }
  if (before_kpa_.size() == waypoints_kpa_.size()) {
    go_on(paths);
  }
  for (int k = 0; k < kTries && candidates_.size() < kCandidates; ++k) {
    RandomStream random(seed_, stream_ + changes_++);
    candidate_kpa_ = waypoints_kpa_;
    change(random);
    add_candidate(paths);
  }
}

/// What the last round changed may be worth changing further.
void PlanImprover::go_on(std::vector<Path>& paths) {
  for (const float factor : {1.0F, 3.0F}) {
    candidate_kpa_ = waypoints_kpa_;
    for (std::size_t i = 1; i < candidate_kpa_.size(); ++i) {
      const Pressures way = waypoints_kpa_[i] - before_kpa_[i];
      candidate_kpa_[i] = limited(candidate_kpa_[i] + factor * way);
    }
    add_candidate(paths);
  }
}

void PlanImprover::add_candidate(std::vector<Path>& paths) {
  const double cost = path_cost_kpa(candidate_kpa_);
  if (cost >= merit_kpa_ - kImprovementKpa) {
    return;
  }
  std::size_t same = 1;
  while (same < candidate_kpa_.size() && same < waypoints_kpa_.size() &&
         candidate_kpa_[same] == waypoints_kpa_[same]) {
    ++same;
  }
  same = std::min(same, candidate_kpa_.size() - 1);  // the last motion's hold is simulated again
  paths.push_back(
      {states_[same - 1],
       {candidate_kpa_.begin() + static_cast<std::ptrdiff_t>(same), candidate_kpa_.end()}});
  candidates_.push_back({candidate_kpa_, same, cost});
}

/// Shifts it by the no-load model's Newton step from its end to the rim of the aim: cheap plans end
/// there, so that most changes that save something end just beyond.
void PlanImprover::repair(const Miss& miss) {
  candidate_kpa_ = miss.waypoints_kpa;
  const Pressures end = candidate_kpa_.back();
  const PoseGoal target = nearest_inside(aim_.inner(), miss.held_tip);
  shift_in_proportion(step_toward_goal(problem_.model.no_load(), target, problem_.arm.length_m(),
                                       end, miss.held_tip) -
                      end);
}

void PlanImprover::settle(const PathOutcome* outcomes) {
  note_misses(outcomes);
  before_kpa_.clear();
  std::vector<std::pair<double, std::size_t>> by_merit;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    if (!outcomes[k].in_goal) {
      continue;
    }
    const double merit_kpa = aim_.merit_kpa(candidates_[k].cost_kpa, *outcomes[k].held_tip);
    if (merit_kpa < merit_kpa_ - kImprovementKpa) {
      by_merit.emplace_back(merit_kpa, k);
    }
  }
  std::sort(by_merit.begin(), by_merit.end());
  for (const auto& [merit_kpa, k] : by_merit) {
    if (opinions_.agree(candidates_[k].waypoints_kpa)) {
      accept(k, outcomes[k]);
      return;
    }
  }
}

/// The cheapest of them.
void PlanImprover::note_misses(const PathOutcome* outcomes) {
  std::vector<std::pair<double, std::size_t>> by_cost;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    if (outcomes[k].held_tip &&
        (!outcomes[k].in_goal || aim_.beyond(*outcomes[k].held_tip) > 0.0)) {
      by_cost.emplace_back(candidates_[k].cost_kpa, k);
    }
  }
  std::sort(by_cost.begin(), by_cost.end());
  by_cost.resize(std::min(by_cost.size(), kRepairs));
  misses_.clear();
  for (const auto& [cost_kpa, k] : by_cost) {
    misses_.push_back({candidates_[k].waypoints_kpa, *outcomes[k].held_tip});
  }
}

void PlanImprover::accept(std::size_t candidate, const PathOutcome& outcome) {
  Candidate& taken = candidates_[candidate];
  states_.resize(taken.same);
  states_.insert(states_.end(), outcome.at.begin(), outcome.at.end());
  before_kpa_ = std::exchange(waypoints_kpa_, std::move(taken.waypoints_kpa));
  merit_kpa_ = aim_.merit_kpa(taken.cost_kpa, *outcome.held_tip);
  if (merit_kpa_ < (1.0 - kNotable) * milestone_kpa_) {
    milestone_kpa_ = merit_kpa_;
    fruitless_rounds_ = 0;
  }
}

}  // namespace limber
