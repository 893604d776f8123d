#include "forest_search.hpp"

#include <algorithm>
#include <cmath>

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

constexpr double kLookM = 0.04;     // of the plate that moves farthest: one check per this length
constexpr int kMaxEdgeChecks = 16;  // along an edge

constexpr std::size_t kFirstBatch = 1;  // small, so that an easy plan comes at once; then doubled
constexpr std::size_t kFirstNear = 8;   // their step mostly ends in the goal, not nearly always
constexpr std::size_t kMaxBatch = 64;
constexpr std::size_t kMaxNear = 64;  // tried: then the search has enough nodes to start from
constexpr double kNearM = 0.10;       // how near the goal's disc those end
constexpr int kRoundsWithPlan = 2;    // more expensive ones, for the improvers to start from
constexpr std::ptrdiff_t kMaxNearLookedAt = 2048;
constexpr int kMaxFilterChecks =
    1024;                         // checks of the filter in a round; then it is the search's turn
constexpr int kLooksAtOnce = 64;  // then the time limit is checked

Eigen::Vector2f point_m(const PoseGoal& goal) {
  return {float(goal.x_m), float(goal.y_m)};
}

/// Nothing is known of a node if the motion to it collided.
bool is_ruled_out(const MotionState& state) {
  return state.backbone.size() == 0;
}

Pose pose_of(const TipGrid::Tip& tip) {
  return {double(tip.x_m), double(tip.y_m), double(tip.theta_rad)};
}

int parent_of(const Forest& forest, int node) {
  return forest.parents[node];
}

/// Nodes on the path to `node`, itself included, after the last one that is in `known`.
template <class Known>
std::vector<int> path_beyond(const Known& known, const Forest& forest, int node) {
  std::vector<int> path;
  for (; known.count(node) == 0; node = parent_of(forest, node)) {
    path.push_back(node);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

ForestFilter::ForestFilter(const Forest& forest, const PlanningProblem& problem,
                           const CollisionChecker& checker)
    : forest_(forest),
      checker_(checker),
      arm_length_m_(problem.arm.length_m()),
      start_(start_state(problem.environment, problem.arm).backbone) {
  known_[0] = true;
}

bool ForestFilter::leaves_free(int node) {
  // The end first: one look rules out most, and all that goes on from there.
  if (known_.count(node) == 0 && !checker_.is_free(shape_at(node))) {
    known_[node] = false;
  }
  return leaves_path_free(node) && leaves_hold_free(node);
}

bool ForestFilter::leaves_path_free(int node) {
  for (const int passed : path_beyond(known_, forest_, node)) {
    known_[passed] = known_.at(parent_of(forest_, passed)) && leaves_edge_free(passed);
  }
  return known_.at(node);
}

bool ForestFilter::leaves_edge_free(int node) const {
  const int parent = parent_of(forest_, node);
  const Backbone end = shape_at(node);
  if (!checker_.is_free(end)) {
    return false;
  }
  const int looks = std::min(
      kMaxEdgeChecks, int(std::ceil(largest_plate_distance_m(shape_at(parent), end) / kLookM)));
  for (int k = 1; k < looks; ++k) {
    if (!checker_.is_free(shape_between(parent, node, float(k) / float(looks)))) {
      return false;
    }
  }
  return true;
}

bool ForestFilter::leaves_hold_free(int node) const {
  const Backbone end = shape_at(node);
  Backbone held = end;
  // Of the held shape the tip alone is stored: every plate does its part of what the tip does.
  const Eigen::Index last = held.rows() - 1;
  const Eigen::RowVector3f shift = forest_.held_tips.col(node).transpose() - held.row(last);
  for (Eigen::Index plate = 1; plate <= last; ++plate) {
    const float part = float(plate) / float(last);
    held.row(plate) += part * part * shift;
  }
  return checker_.is_motion_free(end, held);
}

Backbone ForestFilter::shape_between(int from, int to, float fraction) const {
  Backbone shape = start_;
  blend_shapes(forest_.shapes.col(from), forest_.shapes.col(to), fraction, arm_length_m_, shape);
  return shape;
}

ForestSearch::ForestSearch(const Forest& forest, const PlanningProblem& problem,
                           const CollisionChecker& checker, PathSimulator& simulator,
                           BatchSearch& search)
    : forest_(forest),
      problem_(problem),
      simulator_(simulator),
      search_(search),
      filter_(forest, problem, checker),
      setpoints_(setpoints_of(problem)),
      in_goal_(those_in_goal()),
      near_left_(kMaxNear) {
  grafted_[0] = 0;
  known_[0] = start_of(problem);
}

ForestSearch::Ranking ForestSearch::those_in_goal() const {
  const PoseGoal& goal = problem_.environment.goal;
  std::vector<Ranked> found;
  forest_.tips.visit_near(point_m(goal), float(goal.position_tolerance_m),
                          [&](const TipGrid::Tip& tip) {
                            if (is_within(goal, pose_error(goal, pose_of(tip)))) {
                              found.emplace_back(double(tip.cost_kpa), tip.node);
                            }
                          });
  return Ranking({}, std::move(found));
}

ForestSearch::Ranking ForestSearch::those_near() const {
  const PoseGoal& goal = problem_.environment.goal;
  std::vector<Ranked> found;
  forest_.tips.visit_near(point_m(goal), float(goal.position_tolerance_m + kNearM),
                          [&](const TipGrid::Tip& tip) {
                            found.emplace_back(goal_error(goal, pose_of(tip)), tip.node);
                          });
  if (std::ssize(found) > kMaxNearLookedAt) {
    std::nth_element(found.begin(), found.begin() + kMaxNearLookedAt, found.end());
    found.resize(kMaxNearLookedAt);
  }
  return Ranking({}, std::move(found));
}

std::optional<ForestSearch::Candidate> ForestSearch::candidate(int node, bool step) {
  if (node == 0 || !tried_.insert(node).second || !filter_.leaves_free(node)) {
    return std::nullopt;
  }
  Candidate found{node, path_beyond(known_, forest_, parent_of(forest_, node)), std::nullopt};
  found.path.push_back(node);  // even if it is known: its hold is not
  const bool is_within_limits = std::ranges::all_of(found.path, [this](int passed) {
    const Pressures kpa = forest_.setpoints_kpa.col(passed);
    return setpoints_.limited(kpa) == kpa;
  });
  if (!is_within_limits) {
    return std::nullopt;
  }
  const auto last = known_.find(node);
  if (is_ruled_out(known_.at(parent_of(forest_, found.path.front()))) ||
      (last != known_.end() && is_ruled_out(last->second))) {
    return std::nullopt;
  }
  if (step) {
    found.step_kpa = search_.limited(step_toward_goal(
        problem_.model.no_load(), problem_.environment.goal, problem_.arm.length_m(),
        forest_.setpoints_kpa.col(node), pose_of(forest_.held_tips.col(node).cast<double>())));
  }
  return found;
}

Path ForestSearch::path_of(const Candidate& candidate) const {
  Path path{known_.at(parent_of(forest_, candidate.path.front())), {}};
  path.hold = true;  // the forest knows where that leads, however far it goes
  for (const int passed : candidate.path) {
    path.to_kpa.emplace_back(forest_.setpoints_kpa.col(passed));
  }
  if (candidate.step_kpa) {
    path.to_kpa.push_back(*candidate.step_kpa);
  }
  return path;
}

ForestSearch::Batch ForestSearch::collect(Ranking& nodes, std::size_t wanted, bool step,
                                          const std::function<bool()>& give_up) {
  Batch batch;
  for (int looks = 1; looks <= kMaxFilterChecks && !nodes.empty() && batch.paths.size() < wanted;
       ++looks) {
    if (looks % kLooksAtOnce == 0 && give_up()) {
      break;
    }
    const int node = nodes.top().second;
    nodes.pop();
    if (std::optional<Candidate> found = candidate(node, step)) {
      batch.paths.push_back(path_of(*found));
      batch.candidates.push_back(std::move(*found));
    }
  }
  return batch;
}

/// Those that end in the goal; once there are none, and still no plan, those near it.
ForestSearch::Batch ForestSearch::next_batch(const std::function<bool()>& give_up, bool has_plan) {
  const auto wanted = [this](std::size_t first) {
    return std::min(first << std::min(rounds_, 8), kMaxBatch);
  };
  Batch batch = collect(in_goal_, wanted(kFirstBatch), false, give_up);
  if (in_goal_.empty() && batch.paths.empty() && !has_plan) {
    if (!near_) {
      near_.emplace(those_near());
    }
    batch = collect(*near_, std::min(wanted(kFirstNear), near_left_), true, give_up);
    near_left_ -= batch.paths.size();
  }
  ++rounds_;
  return batch;
}

ForestSearch::Round ForestSearch::round(const std::function<bool()>& give_up, bool has_plan) {
  if (has_plan && ++rounds_since_plan_ > kRoundsWithPlan) {
    return {};
  }
  const Batch batch = next_batch(give_up, has_plan);
  if (batch.paths.empty()) {
    return {!in_goal_.empty() || (near_ && !near_->empty() && near_left_ > 0), {}};
  }
  const std::vector<PathOutcome> outcomes = simulator_.run(batch.paths, give_up);
  // Once time is up some are wrongly ruled out, unless another path of the batch reached them.
  Round result{true, {}};
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (const auto solution = settle(batch.candidates[k], outcomes[k])) {
      result.found.push_back(*solution);
    }
  }
  return result;
}

std::optional<BatchSearch::Solution> ForestSearch::settle(const Candidate& tried,
                                                          const PathOutcome& outcome) {
  for (std::size_t i = 0; i < tried.path.size(); ++i) {
    if (i >= outcome.at.size()) {
      known_.try_emplace(tried.path[i]);
      return std::nullopt;
    }
    // Another path that was cut short may have ruled it out.
    known_.insert_or_assign(tried.path[i], outcome.at[i]);
  }
  int node = graft(tried.node);
  if (!outcome.free) {
    return std::nullopt;  // the step collides, not the way to it
  }
  if (tried.step_kpa) {
    node = search_.graft(node, outcome.at.back());
  }
  return outcome.in_goal ? std::optional(search_.solution_at(node, *outcome.held_tip))
                         : std::nullopt;
}

int ForestSearch::graft(int node) {
  for (const int passed : path_beyond(grafted_, forest_, node)) {
    grafted_[passed] = search_.graft(grafted_.at(parent_of(forest_, passed)), known_.at(passed));
  }
  return grafted_.at(node);
}

}  // namespace limber
