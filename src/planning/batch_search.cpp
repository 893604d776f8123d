#include "batch_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limber {

namespace {

constexpr std::uint64_t kSearchStream = std::uint64_t{1} << 32;  // one stream a proposal from here
constexpr float kSamePoint = 1e-4F;       // of the limit: an edge this short adds nothing
constexpr std::size_t kFewestEdges = 16;  // of a batch, while the tree is small
constexpr std::size_t kMostEdges = 128;
constexpr std::size_t kElites = 32;
// Nodes of which the nearest becomes a parent; powers of two up to this are drawn alike, so that
// edges of all lengths are tried: one that overshoots has to come back from afar.
constexpr int kMostParentChoices = 32;
constexpr int kMostShotChoices = 16;  // nodes of which the nearest to the goal is shot from

// 1, 2, 4, … `most`, a power of two.
int choices_of(RandomStream& random, int most) {
  int kinds = 1;
  while (1 << (kinds - 1) < most) {
    ++kinds;
  }
  return 1 << random.index(static_cast<std::uint32_t>(kinds));
}

// Mixes a value into a hash (the finaliser of SplitMix64).
std::uint64_t mixed(std::uint64_t hash, std::int64_t value) {
  std::uint64_t x = hash + 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(value);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace

BatchSearch::BatchSearch(const PlanningProblem& problem, PathSimulator& simulator,
                         const DefaultPlannerSettings& settings, std::uint64_t seed)
    : problem_(problem),
      simulator_(simulator),
      settings_(settings),
      seed_(seed),
      goal_sampler_(problem.model.no_load(), problem.environment.goal,
                    settings.goal_configurations),
      limit_kpa_(pressure_limits_kpa(problem.arm)),
      tree_(problem.arm.segment_count(), problem.arm.point_count()),
      index_(problem.arm.segment_count()) {
  const ArmStart start = start_state(problem.environment, problem.arm);
  tree_.add(start.pressures_kpa, start.backbone, -1, 0.0);
  index_.add(scaled(start.pressures_kpa));
  stands_for_.push_back(0);
  cheapest_[cell_of(start.pressures_kpa, tip_pose(start.backbone))] = 0;
  note_error(0);
}

Eigen::VectorXf BatchSearch::scaled(const PressuresRef& pressures_kpa) const {
  return pressures_kpa.cwiseQuotient(limit_kpa_);
}

Pressures BatchSearch::limited(const Pressures& pressures_kpa) const {
  return pressures_kpa.cwiseMax(-limit_kpa_).cwiseMin(limit_kpa_);
}

std::uint64_t BatchSearch::cell_of(const PressuresRef& pressures_kpa, const Pose& tip) const {
  const auto quantised = [](double value, double cell) {
    return static_cast<std::int64_t>(std::floor(value / cell));
  };
  std::uint64_t hash = 0;
  for (Eigen::Index i = 0; i < pressures_kpa.size(); ++i) {
    hash = mixed(
        hash, quantised(double(pressures_kpa[i]) / double(limit_kpa_[i]), settings_.cell_pressure));
  }
  hash = mixed(hash, quantised(tip.x_m, settings_.cell_position_m));
  hash = mixed(hash, quantised(tip.y_m, settings_.cell_position_m));
  return mixed(hash, quantised(tip.theta_rad, settings_.cell_orientation_rad));
}

void BatchSearch::note_error(int node) {
  const double error = goal_error(problem_.environment.goal, tip_pose(tree_.backbone(node)));
  if (elite_.size() == kElites && error >= elite_.back().error) {
    return;
  }
  const auto place =
      std::upper_bound(elite_.begin(), elite_.end(), error,
                       [](double value, const Elite& elite) { return value < elite.error; });
  elite_.insert(place, {error, node});
  if (elite_.size() > kElites) {
    elite_.pop_back();
  }
}

int BatchSearch::any_node(RandomStream& random) const {
  return static_cast<int>(random.index(static_cast<std::uint32_t>(tree_.size())));
}

/// The nearest node or the nearest of some: of several backbones at like pressures each gets its
/// turn.
int BatchSearch::parent_near(const Pressures& target_kpa, RandomStream& random) const {
  int node = 0;
  if (random.uniform() >= settings_.random_parent) {
    node = index_.nearest(scaled(target_kpa));
  } else {
    float nearest = std::numeric_limits<float>::infinity();
    const int choices = choices_of(random, kMostParentChoices);
    for (int k = 0; k < choices; ++k) {
      const int other = any_node(random);
      const float distance =
          (target_kpa - tree_.pressures_kpa(other)).cwiseQuotient(limit_kpa_).squaredNorm();
      if (distance < nearest) {
        nearest = distance;
        node = other;
      }
    }
  }
  while (stands_for_[static_cast<std::size_t>(node)] != node) {
    node = stands_for_[static_cast<std::size_t>(node)];
  }
  return node;
}

BatchSearch::Proposal BatchSearch::shot_at_goal(RandomStream& random) {
  int node = elite_[random.index(static_cast<std::uint32_t>(elite_.size()))].node;
  if (random.uniform() < 0.5) {
    const auto error_at = [&](int i) {
      return goal_error(problem_.environment.goal, tip_pose(tree_.backbone(i)));
    };
    const int choices = random.uniform() < 0.5 ? 1 : choices_of(random, kMostShotChoices);
    node = any_node(random);
    double error = error_at(node);
    for (int k = 1; k < choices; ++k) {
      const int other = any_node(random);
      const double other_error = error_at(other);
      if (other_error < error) {
        node = other;
        error = other_error;
      }
    }
  }
  Pressures to =
      step_toward_goal(problem_.model.no_load(), problem_.environment.goal, problem_.arm.length_m(),
                       tree_.pressures_kpa(node), tip_pose(tree_.backbone(node)));
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    to[i] += static_cast<float>(random.normal() * settings_.shot_spread) * limit_kpa_[i];
  }
  return {node, limited(to)};
}

BatchSearch::Proposal BatchSearch::toward_goal_configuration(RandomStream& random) {
  Pressures to = goal_sampler_.sample(random);
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    to[i] += static_cast<float>(random.normal() * settings_.goal_spread) * limit_kpa_[i];
  }
  to = limited(to);
  return {parent_near(to, random), to};
}

BatchSearch::Proposal BatchSearch::exploration(RandomStream& random) {
  Pressures to(limit_kpa_.size());
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    to[i] = static_cast<float>(random.uniform(-1.0, 1.0)) * limit_kpa_[i];
  }
  const int parent = parent_near(to, random);
  const auto from = tree_.pressures_kpa(parent);
  const float distance = scaled(to - from).norm();
  const auto step = static_cast<float>(settings_.step_size);
  if (distance > step) {
    to = limited(from + (to - from) * (step / distance));
  }
  return {parent, to};
}

BatchSearch::Proposal BatchSearch::propose(RandomStream& random) {
  const double kind = random.uniform();
  if (kind < settings_.goal_shots) {
    return shot_at_goal(random);
  }
  if (kind < settings_.goal_shots + settings_.goal_bias) {
    return toward_goal_configuration(random);
  }
  return exploration(random);
}

void BatchSearch::round(const std::optional<double>& best_cost_kpa,
                        const std::function<bool()>& give_up) {
  const std::size_t wanted =
      std::clamp(static_cast<std::size_t>(tree_.size()) / 4, kFewestEdges, kMostEdges);
  goal_sampler_.draw_at_most(std::min(settings_.goal_configurations, 1 + rounds_++ / 2));
  batch_.clear();
  costs_kpa_.clear();
  paths_.clear();
  for (std::size_t k = 0; k < wanted; ++k) {
    RandomStream random(seed_, kSearchStream + proposals_++);
    Proposal edge = propose(random);
    const auto from = tree_.pressures_kpa(edge.parent);
    const double cost = tree_.cost_kpa(edge.parent) + motion_cost_kpa(from, edge.to_kpa);
    if (scaled(edge.to_kpa - from).norm() <= kSamePoint ||
        (best_cost_kpa && cost >= settings_.dearest * *best_cost_kpa)) {
      continue;
    }
    paths_.push_back({from, tree_.backbone(edge.parent), {edge.to_kpa}});
    costs_kpa_.push_back(cost);
    batch_.push_back(std::move(edge));
  }
  simulator_.run(paths_, outcomes_, give_up);
  for (std::size_t k = 0; k < batch_.size(); ++k) {
    if (outcomes_[k].free) {
      add(batch_[k], costs_kpa_[k], outcomes_[k]);
    }
  }
}

void BatchSearch::add(const Proposal& edge, double cost_kpa, const PathOutcome& outcome) {
  const Backbone& backbone = outcome.at.front();
  const auto [place, is_new] =
      cheapest_.try_emplace(cell_of(edge.to_kpa, tip_pose(backbone)), tree_.size());
  if (!is_new && !outcome.in_goal && tree_.cost_kpa(place->second) <= cost_kpa) {
    return;
  }
  const int node = tree_.add(edge.to_kpa, backbone, edge.parent, cost_kpa);
  index_.add(scaled(edge.to_kpa));
  stands_for_.push_back(node);
  if (!is_new && tree_.cost_kpa(place->second) > cost_kpa) {
    stands_for_[static_cast<std::size_t>(place->second)] = node;
    place->second = node;
  }
  note_error(node);
  if (outcome.in_goal) {
    solutions_.push_back({node, cost_kpa});
  }
}

double BatchSearch::bytes() const {
  const std::size_t index_bytes =
      static_cast<std::size_t>(limit_kpa_.size()) * sizeof(float) + 3 * sizeof(int);
  constexpr std::size_t kCellBytes = 48;
  return double(tree_.size()) * double(tree_.bytes_per_node() + index_bytes + kCellBytes);
}

}  // namespace limber
