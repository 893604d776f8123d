#include "batch_search.hpp"

#include <algorithm>
#include <utility>

#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kSearchStream = std::uint64_t{1} << 32;  // one stream a proposal from here
constexpr float kSamePoint = 1e-4F;    // of the limit: an edge this short adds nothing
constexpr std::size_t kMinEdges = 16;  // of a batch, while the tree is small
constexpr std::size_t kMaxEdges = 128;
constexpr std::size_t kElites = 32;
constexpr int kMaxShotChoices = 16;  // nodes of which the one nearest to the goal is steered

}  // namespace

BatchSearch::BatchSearch(const PlanningProblem& problem, PathSimulator& simulator,
                         const DefaultPlannerSettings& settings, std::uint64_t seed,
                         std::uint64_t first_proposal)
    : problem_(problem),
      simulator_(simulator),
      settings_(settings),
      seed_(seed),
      goal_sampler_(problem.model.no_load(), problem.environment.goal, settings.goal_configurations,
                    problem.limits),
      tree_(problem.arm, problem.model,
            {settings.cell_pressure, settings.cell_position_m, settings.cell_orientation_rad},
            start_of(problem)),
      proposals_(first_proposal) {
  tree_.keep_within(setpoints_of(problem));
  note_error(0);
}

double BatchSearch::error_of(int node) const {
  return goal_error(problem_.environment.goal, tree().settled_tip(node));
}

void BatchSearch::note_error(int node) {
  const double error = error_of(node);
  if (elite_.size() == kElites && error >= elite_.back().error) {
    return;
  }
  const auto position =
      std::upper_bound(elite_.begin(), elite_.end(), error,
                       [](double value, const Elite& elite) { return value < elite.error; });
  elite_.insert(position, {error, node});
  if (elite_.size() > kElites) {
    elite_.pop_back();
  }
}

/// Normal about `about_kpa`, within the limits. @param spread  standard deviation, of the limit
Pressures BatchSearch::scattered(const Pressures& about_kpa, double spread,
                                 RandomStream& random) const {
  Pressures kpa = about_kpa;
  for (Eigen::Index i = 0; i < kpa.size(); ++i) {
    kpa[i] += float(random.normal() * spread) * tree_.scales_kpa()[i];
  }
  return tree_.box().limited(kpa);
}

BatchSearch::Edge BatchSearch::shot_at_goal(RandomStream& random) {
  int node = elite_[random.index(std::uint32_t(elite_.size()))].node;
  if (random.uniform() < 0.5) {
    const int choices = random.uniform() < 0.5 ? 1 : random_power_of_two(random, kMaxShotChoices);
    node = tree_.random_node(random);
    double error = error_of(node);
    for (int k = 1; k < choices; ++k) {
      const int other = tree_.random_node(random);
      const double other_error = error_of(other);
      if (other_error < error) {
        node = other;
        error = other_error;
      }
    }
  }
  const Pressures to =
      step_toward_goal(problem_.model.no_load(), problem_.environment.goal, problem_.arm.length_m(),
                       tree().setpoint_kpa(node), tree().settled_tip(node));
  return {node, scattered(to, settings_.shot_spread, random)};
}

BatchSearch::Edge BatchSearch::exploration(RandomStream& random) {
  const Pressures to = tree_.box().sample(random);
  const int parent = tree_.parent_near(to, settings_.random_parent, random);
  return {parent, tree_.stepped(parent, to, settings_.step_size)};
}

BatchSearch::Edge BatchSearch::propose(RandomStream& random) {
  const double kind = random.uniform();
  if (kind < settings_.goal_steering_share) {
    return shot_at_goal(random);
  }
  if (kind < settings_.goal_steering_share + settings_.goal_bias) {
    const Pressures to = scattered(goal_sampler_.sample(random), settings_.goal_spread, random);
    return {tree_.parent_near(to, settings_.random_parent, random), to};
  }
  return exploration(random);
}

std::vector<BatchSearch::Edge> BatchSearch::propose_batch(
    const std::optional<double>& best_cost_kpa) {
  const std::size_t wanted = std::clamp(std::size_t(tree_.size()) / 4, kMinEdges, kMaxEdges);
  goal_sampler_.draw_at_most(std::min(settings_.goal_configurations, 1 + rounds_++ / 2));
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < wanted; ++k) {
    RandomStream random(seed_, kSearchStream + proposals_++);
    Edge edge = propose(random);
    const auto from = tree().setpoint_kpa(edge.parent);
    edge.cost_kpa = tree().cost_kpa(edge.parent) + motion_cost_kpa(from, edge.to_kpa);
    if (tree_.scaled(edge.to_kpa - from).norm() <= kSamePoint ||
        (best_cost_kpa && edge.cost_kpa >= settings_.max_cost_ratio * *best_cost_kpa)) {
      continue;
    }
    edges.push_back(std::move(edge));
  }
  return edges;
}

std::vector<BatchSearch::Solution> BatchSearch::round(const std::optional<double>& best_cost_kpa,
                                                      const std::function<bool()>& give_up) {
  const std::vector<Edge> edges = propose_batch(best_cost_kpa);
  const auto paths = mapped<Path>(edges, [&](const Edge& edge) {
    return Path{tree().state(edge.parent), {edge.to_kpa}};
  });
  const std::vector<PathOutcome> outcomes = simulator_.run(paths, give_up);
  std::vector<Solution> found;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!outcomes[k].free) {
      continue;
    }
    if (const std::optional<Solution> solution = add(edges[k], outcomes[k])) {
      found.push_back(*solution);
    }
  }
  return found;
}

std::optional<BatchSearch::Solution> BatchSearch::add(const Edge& edge,
                                                      const PathOutcome& outcome) {
  const std::optional<int> node =
      tree_.add(outcome.at.front(), edge.parent, edge.cost_kpa, outcome.in_goal);
  if (!node) {
    return std::nullopt;
  }
  note_error(*node);
  return outcome.in_goal ? std::optional(solution_at(*node, *outcome.held_tip)) : std::nullopt;
}

BatchSearch::Solution BatchSearch::solution_at(int node, const Pose& held_tip) const {
  return {node, tree().cost_kpa(node), held_tip};
}

int BatchSearch::graft(int parent, const MotionState& state) {
  const double cost_kpa =
      tree().cost_kpa(parent) + motion_cost_kpa(tree().setpoint_kpa(parent), state.setpoint_kpa());
  const int node = *tree_.add(state, parent, cost_kpa, true);
  note_error(node);
  return node;
}

}  // namespace limber
