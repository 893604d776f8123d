#include "forest_search.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr std::size_t kFirstBatch = 1;  // small, so that an easy plan comes at once; then doubled
constexpr std::size_t kFirstNear = 8;   // their step mostly ends in the goal, not nearly always
constexpr std::size_t kMaxBatch = 64;
constexpr std::size_t kMaxNear = 64;  // tried: then the search has enough nodes to start from
constexpr double kNearM = 0.10;       // how near the goal's disc those end
constexpr int kRoundsWithPlan = 2;    // more expensive ones, for the improvers to start from
constexpr std::ptrdiff_t kMaxNearLookedAt = 2048;
constexpr int kMaxLooks = 1024;   // checks of the filter in a round; then it is the search's turn
constexpr int kLooksAtOnce = 64;  // then the time limit is checked

Eigen::Vector2f point_m(const PoseGoal& goal) {
  return {static_cast<float>(goal.x_m), static_cast<float>(goal.y_m)};
}

/// Nothing is known of a node if the motion to it collided.
bool is_ruled_out(const MotionState& state) {
  return state.backbone.size() == 0;
}

Pose pose_of(const TipGrid::Tip& tip) {
  return {double(tip.x_m), double(tip.y_m), double(tip.theta_rad)};
}

}  // namespace

ForestSearch::ForestSearch(const Forest& forest, const PlanningProblem& problem,
                           const CollisionChecker& checker, PathSimulator& simulator,
                           BatchSearch& search)
    : forest_(forest),
      problem_(problem),
      simulator_(simulator),
      search_(search),
      filter_(forest, problem, checker),
      near_left_(kMaxNear) {
  grafted_[0] = 0;
  known_[0] = start_of(problem);
  find_those_in_goal();
}

void ForestSearch::find_those_in_goal() {
  const PoseGoal& goal = problem_.environment.goal;
  std::vector<Ranked> found;
  forest_.tips.visit_near(point_m(goal), static_cast<float>(goal.position_tolerance_m),
                          [&](const TipGrid::Tip& tip) {
                            if (is_within(goal, pose_error(goal, pose_of(tip)))) {
                              found.emplace_back(double(tip.cost_kpa), tip.node);
                            }
                          });
  in_goal_ = Ranking({}, std::move(found));
}

void ForestSearch::find_those_near() {
  const PoseGoal& goal = problem_.environment.goal;
  std::vector<Ranked> found;
  forest_.tips.visit_near(point_m(goal), static_cast<float>(goal.position_tolerance_m + kNearM),
                          [&](const TipGrid::Tip& tip) {
                            found.emplace_back(goal_error(goal, pose_of(tip)), tip.node);
                          });
  if (std::ssize(found) > kMaxNearLookedAt) {
    std::nth_element(found.begin(), found.begin() + kMaxNearLookedAt, found.end());
    found.resize(static_cast<std::size_t>(kMaxNearLookedAt));
  }
  near_.emplace(Ranking({}, std::move(found)));
}

std::optional<ForestSearch::Candidate> ForestSearch::candidate(int node, bool step) {
  if (node == 0 || !tried_.insert(node).second || !filter_.leaves_free(node)) {
    return std::nullopt;
  }
  Candidate found{node, {node}, std::nullopt};  // even if it is known: its hold is not
  int i = forest_.parents[static_cast<std::size_t>(node)];
  for (; known_.count(i) == 0; i = forest_.parents[static_cast<std::size_t>(i)]) {
    found.path.push_back(i);
  }
  const auto last = known_.find(node);
  if (is_ruled_out(known_.at(i)) || (last != known_.end() && is_ruled_out(last->second))) {
    return std::nullopt;
  }
  std::reverse(found.path.begin(), found.path.end());
  if (step) {
    const auto held = forest_.held_tips.col(node);
    found.step_kpa = search_.limited(step_toward_goal(
        problem_.model.no_load(), problem_.environment.goal, problem_.arm.length_m(),
        forest_.setpoints_kpa.col(node), {double(held[0]), double(held[1]), double(held[2])}));
  }
  return found;
}

void ForestSearch::collect(Ranking& nodes, std::size_t wanted, bool step,
                           const std::function<bool()>& give_up) {
  for (int looks = 1; looks <= kMaxLooks && !nodes.empty() && paths_.size() < wanted; ++looks) {
    if (looks % kLooksAtOnce == 0 && give_up()) {
      return;
    }
    const int node = nodes.top().second;
    nodes.pop();
    std::optional<Candidate> found = candidate(node, step);
    if (!found) {
      continue;
    }
    const int from = forest_.parents[static_cast<std::size_t>(found->path.front())];
    Path path{known_.at(from), {}};
    path.hold = true;  // the forest knows where the hold leads, however far
    for (const int passed : found->path) {
      path.to_kpa.emplace_back(forest_.setpoints_kpa.col(passed));
    }
    if (found->step_kpa) {
      path.to_kpa.push_back(*found->step_kpa);
    }
    paths_.push_back(std::move(path));
    candidates_.push_back(std::move(*found));
  }
}

bool ForestSearch::round(const std::function<bool()>& give_up) {
  const bool has_plan = !search_.solutions().empty();
  if (has_plan && ++rounds_since_plan_ > kRoundsWithPlan) {
    return false;
  }
  const auto wanted = [this](std::size_t first) {
    return std::min(first << std::min(rounds_, 8), kMaxBatch);
  };
  paths_.clear();
  candidates_.clear();
  collect(in_goal_, wanted(kFirstBatch), false, give_up);
  if (in_goal_.empty() && paths_.empty() && !has_plan) {
    if (!near_) {
      find_those_near();
    }
    collect(*near_, std::min(wanted(kFirstNear), near_left_), true, give_up);
    near_left_ -= paths_.size();
  }
  ++rounds_;
  if (paths_.empty()) {
    return !in_goal_.empty() || (near_ && !near_->empty() && near_left_ > 0);
  }
  simulator_.run(paths_, outcomes_, give_up);
  // Once time is up some are wrongly ruled out, but these are no longer needed.
  for (std::size_t k = 0; k < paths_.size(); ++k) {
    settle(candidates_[k], outcomes_[k]);
  }
  return true;
}

void ForestSearch::settle(const Candidate& tried, const PathOutcome& outcome) {
  for (std::size_t i = 0; i < tried.path.size(); ++i) {
    if (i >= outcome.at.size()) {
      known_.try_emplace(tried.path[i]);
      return;
    }
    known_.try_emplace(tried.path[i], outcome.at[i]);
  }
  int node = graft(tried.node);
  if (!outcome.free) {
    return;  // the step collides, not the path to it
  }
  if (tried.step_kpa) {
    node = search_.graft(node, outcome.at.back());
  }
  if (outcome.in_goal) {
    search_.note_solution(node, *outcome.held_tip);
  }
}

int ForestSearch::graft(int node) {
  std::vector<int> path;
  int i = node;
  for (; grafted_.count(i) == 0; i = forest_.parents[static_cast<std::size_t>(i)]) {
    path.push_back(i);
  }
  int grafted = grafted_.at(i);
  for (auto step = path.rbegin(); step != path.rend(); ++step) {
    grafted = search_.graft(grafted, known_.at(*step));
    grafted_[*step] = grafted;
  }
  return grafted;
}

}  // namespace limber
