#include "forest_search.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr std::uint64_t kStream = std::uint64_t{1} << 59;
constexpr std::size_t kFirstBatch = 8;  // small, so that an easy plan comes at once; then doubled
constexpr std::size_t kLargestBatch = 64;
constexpr std::size_t kMostInGoal = 4096;
constexpr std::size_t kMostNear = 8;  // motions that end near the goal: the search goes on there
constexpr float kNearM = 0.05F;       // how near the goal those end
constexpr int kRoundsWithPlan = 2;    // dearer ones, for the improvers to start from

}  // namespace

ForestSearch::ForestSearch(const Forest& forest, const PlanningProblem& problem,
                           PathSimulator& simulator, BatchSearch& search, std::uint64_t seed)
    : forest_(forest), problem_(problem), simulator_(simulator), search_(search) {
  grafted_[0] = 0;
  known_[0] = start_state(problem.environment, problem.arm).backbone;
  find_candidates(seed);
}

void ForestSearch::find_candidates(std::uint64_t seed) {
  const PoseGoal& goal = problem_.environment.goal;
  const Eigen::Vector2f centre(static_cast<float>(goal.x_m), static_cast<float>(goal.y_m));
  const float reach = static_cast<float>(goal.position_tolerance_m) + kNearM;
  std::vector<std::pair<double, int>> inside;  // cost
  std::vector<std::pair<double, int>> near;    // error
  const auto x_of = [this](std::int32_t node) { return forest_.held_tips(0, node); };
  auto place = std::ranges::lower_bound(forest_.by_x, centre.x() - reach, {}, x_of);
  for (; place != forest_.by_x.end() && x_of(*place) <= centre.x() + reach; ++place) {
    const int i = *place;
    const auto held = forest_.held_tips.col(i);
    if ((held.head<2>() - centre).squaredNorm() > reach * reach) {
      continue;
    }
    const Pose tip{double(held[0]), double(held[1]), double(held[2])};
    if (is_within(goal, pose_error(goal, tip))) {
      inside.emplace_back(double(forest_.costs_kpa[static_cast<std::size_t>(i)]), i);
    } else {
      near.emplace_back(goal_error(goal, tip), i);
    }
  }
  std::sort(inside.begin(), inside.end());
  // What blocks the cheapest blocks most that are akin to it: every other motion is any of them.
  RandomStream random(seed, kStream);
  const std::size_t most = std::min(inside.size(), kMostInGoal);
  for (std::size_t k = 0; k < most; ++k) {
    candidates_.push_back(inside[k].second);
    candidates_.push_back(inside[random.index(static_cast<std::uint32_t>(inside.size()))].second);
  }
  in_goal_ = candidates_.size();
  const auto end = near.begin() + static_cast<std::ptrdiff_t>(std::min(near.size(), kMostNear));
  std::partial_sort(near.begin(), end, near.end());
  for (auto item = near.begin(); item != end; ++item) {
    candidates_.push_back(item->second);
  }
}

std::optional<std::vector<int>> ForestSearch::way_to(int node) const {
  std::vector<int> way{node};  // even where it is known: its hold is not
  int i = forest_.parents[static_cast<std::size_t>(node)];
  for (; known_.count(i) == 0; i = forest_.parents[static_cast<std::size_t>(i)]) {
    way.push_back(i);
  }
  const auto last = known_.find(node);
  if (known_.at(i).size() == 0 || (last != known_.end() && last->second.size() == 0)) {
    return std::nullopt;
  }
  std::reverse(way.begin(), way.end());
  return way;
}

bool ForestSearch::round(const std::function<bool()>& give_up) {
  const bool has_plan = !search_.solutions().empty();
  if (has_plan && ++rounds_since_plan_ > kRoundsWithPlan) {
    return false;
  }
  const std::size_t end = has_plan ? in_goal_ : candidates_.size();
  const std::size_t wanted = std::min(kFirstBatch << std::min(rounds_++, 8), kLargestBatch);
  paths_.clear();
  ways_.clear();
  for (; next_ < end && paths_.size() < wanted; ++next_) {
    const int node = candidates_[next_];
    std::optional<std::vector<int>> way;
    if (node == 0 || !tried_.insert(node).second || !(way = way_to(node))) {
      continue;
    }
    const int from = forest_.parents[static_cast<std::size_t>(way->front())];
    Path path{forest_.pressures_kpa.col(from), known_.at(from), {}};
    for (const int step : *way) {
      path.to_kpa.emplace_back(forest_.pressures_kpa.col(step));
    }
    paths_.push_back(std::move(path));
    ways_.push_back(std::move(*way));
  }
  if (paths_.empty()) {
    return false;
  }
  simulator_.run(paths_, outcomes_, give_up);
  // Once time is up some are wrongly ruled out, which nobody asks for any more.
  for (std::size_t k = 0; k < paths_.size(); ++k) {
    settle(ways_[k], outcomes_[k]);
  }
  return true;
}

void ForestSearch::settle(const std::vector<int>& way, const PathOutcome& outcome) {
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i >= outcome.at.size()) {
      known_.try_emplace(way[i]);
      return;
    }
    known_.try_emplace(way[i], outcome.at[i]);
  }
  if (outcome.free) {
    const int place = graft(way.back());
    if (outcome.in_goal) {
      search_.note_solution(place);
    }
  }
}

int ForestSearch::graft(int node) {
  std::vector<int> way;
  int i = node;
  for (; grafted_.count(i) == 0; i = forest_.parents[static_cast<std::size_t>(i)]) {
    way.push_back(i);
  }
  int place = grafted_.at(i);
  for (auto step = way.rbegin(); step != way.rend(); ++step) {
    place = search_.graft(place, forest_.pressures_kpa.col(*step), known_.at(*step));
    grafted_[*step] = place;
  }
  return place;
}

}  // namespace limber
