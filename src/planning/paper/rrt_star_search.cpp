#include "rrt_star_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "limber/arm/plate_distance.hpp"
#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kTreeStream = 1;
constexpr float kSameSample = 1e-4F;      // of the limit: a sample this close adds nothing
constexpr double kImprovementKpa = 1e-6;  // rounding of a sum of pressures
/// A gain γ of the near radius γ (ln N / N)^(1/n) for which RRT* is asymptotically optimal on a
/// cube of side 2: 2 (1 + 1/n)^(1/n) (volume / volume of the unit ball)^(1/n), which PRM* needs and
/// which is more than enough for RRT* (Karaman and Frazzoli 2011, theorems 34 and 38).
double min_near_gain(int n) {
  const double ball = std::pow(std::numbers::pi, 0.5 * n) / std::tgamma(0.5 * n + 1.0);
  return 2.0 * std::pow((1.0 + 1.0 / n) * std::pow(2.0, n) / ball, 1.0 / n);
}

}  // namespace

RrtStarSearch::RrtStarSearch(const PlanningProblem& problem, MotionSimulator& simulator,
                             const PressureRrtStarSettings& settings, std::uint64_t seed)
    : problem_(problem),
      simulator_(simulator),
      settings_(settings),
      random_(seed, kTreeStream),
      goal_sampler_(problem.model.no_load(), problem.environment.goal, settings.goal_configurations,
                    problem.limits),
      scale_kpa_(pressure_scales_kpa(problem.arm)),
      box_(pressure_box(limits_of(problem))),
      match_kpa_(
          float(settings.match_pressure * double(pressure_limits_kpa(problem.arm).maxCoeff()))),
      near_gain_(settings.near_factor * min_near_gain(problem.arm.channel_count())),
      tree_(problem.model),
      index_(problem.arm.channel_count()),
      batch_(simulator) {
  const MotionState start = start_of(problem);
  tree_.add(start, -1, 0.0);
  index_.add(scaled(start.setpoint_kpa()));
  in_goal_.push_back(0);
  nearest_error_ = std::numeric_limits<double>::infinity();
  judge(0);
}

Eigen::VectorXf RrtStarSearch::scaled(const PressuresRef& pressures_kpa) const {
  return pressures_kpa.cwiseQuotient(scale_kpa_);
}

Pressures RrtStarSearch::sample() {
  Pressures q(scale_kpa_.size());
  const double kind = random_.uniform();
  if (kind < settings_.goal_bias) {
    q = goal_sampler_.sample(random_);
    for (int i = 0; i < q.size(); ++i) {
      q[i] += float(random_.normal() * settings_.goal_spread) * scale_kpa_[i];
    }
    return box_.limited(q);
  }
  const Pressures middle = 0.5F * (box_.low_kpa + box_.high_kpa);
  const Pressures half = 0.5F * (box_.high_kpa - box_.low_kpa);
  for (int i = 0; i < q.size(); ++i) {
    q[i] = middle[i] + float(random_.uniform(-1.0, 1.0)) * half[i];
  }
  return box_.limited(q);
}

std::optional<Pressures> RrtStarSearch::steer(const Pressures& sample, int nearest) const {
  const auto from = tree_.setpoint_kpa(nearest);
  const float distance = scaled(sample - from).norm();
  if (distance <= kSameSample) {
    return std::nullopt;
  }
  const float step = float(settings_.step_size);
  const Pressures kpa =
      distance <= step ? sample : Pressures(from + (sample - from) * (step / distance));
  return box_.limited(kpa);
}

RrtStarSearch::Nodes RrtStarSearch::near(const Pressures& kpa, int nearest) const {
  const double count = tree_.size() + 1.0;
  const double radius =
      std::min(near_gain_ * std::pow(std::log(count) / count, 1.0 / double(scale_kpa_.size())),
               settings_.step_size);
  Nodes nodes;
  index_.within(scaled(kpa), float(radius), nodes);
  if (!std::binary_search(nodes.begin(), nodes.end(), nearest)) {
    nodes.insert(std::lower_bound(nodes.begin(), nodes.end(), nearest), nearest);
  }
  return nodes;
}

std::vector<RrtStarSearch::Candidate> RrtStarSearch::by_cost(const Pressures& kpa,
                                                             const Nodes& near) const {
  auto candidates = mapped<Candidate>(near, [&](const int node) {
    return Candidate{tree_.cost_kpa(node) + motion_cost_kpa(tree_.setpoint_kpa(node), kpa), node};
  });
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.cost_kpa < b.cost_kpa || (a.cost_kpa == b.cost_kpa && a.node < b.node);
  });
  return candidates;
}

std::optional<int> RrtStarSearch::connect(const Pressures& kpa, const Nodes& near) {
  MotionState end;
  for (const Candidate& candidate : by_cost(kpa, near)) {
    if (simulator_.move(tree_.state(candidate.node), kpa, end)) {
      const int node = tree_.add(end, candidate.node, candidate.cost_kpa);
      index_.add(scaled(kpa));
      in_goal_.push_back(0);
      return node;
    }
  }
  return std::nullopt;
}

bool RrtStarSearch::matches(const MotionState& end, int node) const {
  const Eigen::Index n = scale_kpa_.size();
  const auto valves = tree_.valves(node);
  const auto backbone = tree_.backbone(node);
  return end.setpoint_kpa() == valves.segment(n, n) &&
         (end.valves - valves).lpNorm<Eigen::Infinity>() <= match_kpa_ &&
         largest_plate_distance_m(end.backbone, backbone) <= settings_.match_position_m &&
         (end.backbone - backbone).col(2).lpNorm<Eigen::Infinity>() <=
             float(settings_.match_orientation_rad);
}

std::optional<std::vector<RrtStarSearch::Changed>> RrtStarSearch::simulate_below(
    Changed root, const PlannerBudget& budget) {
  std::vector<Changed> changed{std::move(root)};
  for (std::size_t k = 0; k < changed.size(); ++k) {
    if (budget.out_of_time()) {
      return std::nullopt;
    }
    const int node = changed[k].node;
    bool is_free = true;
    tree_.visit_children(node, [&](int child) {
      const double cost = changed[k].cost_kpa +
                          motion_cost_kpa(tree_.setpoint_kpa(node), tree_.setpoint_kpa(child));
      if (!is_free || !changed[k].state) {
        changed.push_back({child, cost, std::nullopt});  // the same state: the same below
        return;
      }
      MotionState end;
      is_free = simulator_.move(*changed[k].state, tree_.setpoint_kpa(child), end);
      const bool as_before = end == tree_.state(child);
      changed.push_back({child, cost, as_before ? std::nullopt : std::optional(std::move(end))});
    });
    if (!is_free) {
      return std::nullopt;
    }
  }
  return changed;
}

void RrtStarSearch::simulate_to(const Nodes& nodes, int from) {
  const std::vector<MotionState> states(nodes.size(), tree_.state(from));
  Eigen::MatrixXf to_kpa(scale_kpa_.size(), std::ssize(nodes));
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    to_kpa.col(Eigen::Index(c)) = tree_.setpoint_kpa(nodes[c]);
  }
  batch_.run(states, to_kpa);
}

void RrtStarSearch::rewire(int from, const Nodes& near, const PlannerBudget& budget) {
  const auto cost_through = [&](int node) {
    return tree_.cost_kpa(from) +
           motion_cost_kpa(tree_.setpoint_kpa(from), tree_.setpoint_kpa(node));
  };
  const auto is_cheaper = [&](int node) {
    return cost_through(node) < tree_.cost_kpa(node) - kImprovementKpa;
  };
  Nodes nodes;
  std::copy_if(near.begin(), near.end(), std::back_inserter(nodes), is_cheaper);
  if (nodes.empty() || budget.out_of_time()) {
    return;
  }
  simulate_to(nodes, from);
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    const int node = nodes[c];
    if (!is_cheaper(node)) {
      continue;  // an earlier rewiring has made it so
    }
    ++statistics_.rewires_tried;
    const auto motion = int(c);
    const MotionState& end = batch_.end(motion);
    if (!matches(end, node) || !batch_.is_free(motion, simulator_.checker())) {
      continue;
    }
    const bool as_before = end == tree_.state(node);
    const auto changed = simulate_below(
        {node, cost_through(node), as_before ? std::nullopt : std::optional(end)}, budget);
    if (changed) {
      accept_rewiring(*changed, from);
    }
  }
}

/// @param changed  the rewired node first
void RrtStarSearch::accept_rewiring(const std::vector<Changed>& changed, int from) {
  ++statistics_.rewires_accepted;
  tree_.set_parent(changed.front().node, from);
  for (const Changed& change : changed) {
    tree_.set_cost_kpa(change.node, change.cost_kpa);
    if (change.state) {
      tree_.set_state(change.node, *change.state);
    }
  }
  for (const Changed& change : changed) {
    change.state ? judge(change.node) : consider_best(change.node);
  }
}

bool RrtStarSearch::ends_in_goal(int node) {
  const PoseGoal& goal = problem_.environment.goal;
  MotionState held;
  return settings_.hold.reaches(goal, tree_.settled_tip(node)) &&
         simulator_.hold(tree_.state(node), held) &&
         is_within(goal, pose_error(goal, tip_pose(held.backbone)));
}

void RrtStarSearch::judge(int node) {
  const PoseGoal& goal = problem_.environment.goal;
  const double error = goal_error(goal, tree_.settled_tip(node));
  if (error < nearest_error_) {
    nearest_error_ = error;
    nearest_node_ = node;
  }
  in_goal_[node] = ends_in_goal(node) ? 1 : 0;
  consider_best(node);
}

void RrtStarSearch::consider_best(int node) {
  const double cost = tree_.cost_kpa(node);
  if (in_goal_[node] && (!best_cost_kpa_ || cost < *best_cost_kpa_ - kImprovementKpa)) {
    best_cost_kpa_ = cost;
    best_waypoints_kpa_ = tree_.path_to(node);
  }
}

void RrtStarSearch::iterate(const PlannerBudget& budget) {
  ++statistics_.iterations;
  const Pressures target = sample();
  const int nearest = index_.nearest(scaled(target));
  const std::optional<Pressures> kpa = steer(target, nearest);
  if (!kpa) {
    return;
  }
  const Nodes nodes = near(*kpa, nearest);
  const std::optional<int> node = connect(*kpa, nodes);
  if (node) {
    judge(*node);
    rewire(*node, nodes, budget);
  }
}

double RrtStarSearch::bytes() const {
  const std::size_t index_bytes = std::size_t(scale_kpa_.size()) * sizeof(float) + 2 * sizeof(int);
  return double(tree_.size()) * double(tree_.bytes_per_node() + index_bytes + 1);
}

PlannerStatistics RrtStarSearch::statistics() const {
  PlannerStatistics statistics = statistics_;
  statistics.nodes = std::uint64_t(tree_.size());
  return statistics;
}

}  // namespace limber
