#include "limber/planning/forest.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/planning/planner.hpp"
#include "search/path_simulator.hpp"
#include "search/sparse_tree.hpp"

namespace limber {

namespace {

constexpr int kMaxCells = 64;  // along the longer side of what the tips reach

// Finer than a search's: there are many nodes, and each keeps only the path to it.
constexpr StateCells kCells{0.02, 0.005, 0.05};
constexpr std::uint64_t kGrowStream = std::uint64_t{1} << 33;  // one stream a proposal from here
constexpr double kStep = 0.5;
constexpr double kRandomParent = 0.5;
constexpr double kFarShare = 0.5;  // of the edges that reach their target
constexpr std::size_t kBatch = 512;
constexpr int kMaxIdleRounds = 1000;

struct Edge {
  int parent;
  Pressures to_kpa;
};

/// One growth, round by round.
class Grower {
 public:
  Grower(const ArmDescription& arm, const MotionModel& model, const ArmStart& start,
         const ForestSettings& settings)
      : settings_(settings),
        environment_(empty_environment(start)),
        problem_{arm, model, environment_},
        checker_(arm, environment_.obstacles, 0.0),
        paths_(problem_, checker_, {kAnywhere, kAnywhere}, settings.jobs),
        tree_(arm, problem_.model, kCells, start_of(problem_)) {
    hold_start();
  }

  int size() const { return tree_.size(); }

  void round() {
    std::vector<Edge> edges;
    std::vector<Path> batch;
    for (std::size_t k = 0; k < kBatch; ++k) {
      RandomStream random(settings_.seed, kGrowStream + proposals_++);
      const Pressures target = tree_.box().sample(random);
      const int parent = tree_.parent_near(target, kRandomParent, random);
      const Pressures to =
          random.uniform() < kFarShare ? target : tree_.stepped(parent, target, kStep);
      batch.push_back({tree_.states().state(parent), {to}});
      edges.push_back({parent, to});
    }
    const std::vector<PathOutcome> outcomes = paths_.run(batch, [] { return false; });
    for (std::size_t k = 0; k < edges.size() && tree_.size() < settings_.nodes; ++k) {
      add(edges[k], outcomes[k]);
    }
  }

  Forest forest(const ForestKey& key) const {
    const PressureTree& states = tree_.states();
    Forest forest;
    forest.key = key;
    forest.setpoints_kpa.resize(tree_.scales_kpa().size(), states.size());
    forest.held_tips.resize(kPoseSize, states.size());
    forest.shapes.resize(kPoseSize * (problem_.arm.point_count() - 1), states.size());
    for (int i = 0; i < states.size(); ++i) {
      forest.parents.push_back(states.parent(i));
      forest.setpoints_kpa.col(i) = states.setpoint_kpa(i);
      forest.held_tips.col(i) = held_tips_[i];
      round_shape(states.backbone(i), problem_.arm.length_m(), forest.shapes.col(i));
    }
    forest.complete();
    return forest;
  }

 private:
  static constexpr double kAnywhere = std::numeric_limits<double>::infinity();

  static Environment empty_environment(const ArmStart& start) {
    Environment environment;
    environment.start = start;
    return environment;
  }

  void hold_start() {
    const MotionState start = start_of(problem_);
    const std::vector<PathOutcome> outcomes =
        paths_.run({{start, {start.setpoint_kpa()}}}, [] { return false; });
    refuse_if(!outcomes.front().held_tip,
              "the model diverges while the arm stands still at its start");
    note_tip(outcomes.front());
  }

  void note_tip(const PathOutcome& outcome) {
    held_tips_.push_back(numbers_of(*outcome.held_tip).cast<float>());
  }

  void add(const Edge& edge, const PathOutcome& outcome) {
    if (!outcome.held_tip) {
      return;  // without obstacles, a motion that is not free has diverged
    }
    const double cost = tree_.states().cost_kpa(edge.parent) +
                        motion_cost_kpa(tree_.states().setpoint_kpa(edge.parent), edge.to_kpa);
    if (tree_.add(outcome.at.front(), edge.parent, cost)) {
      note_tip(outcome);
    }
  }

  ForestSettings settings_;
  Environment environment_;
  PlanningProblem problem_;
  CollisionChecker checker_;
  PathSimulator paths_;
  SparseTree tree_;
  std::vector<Eigen::Vector3f> held_tips_;
  std::uint64_t proposals_ = 0;
};

/// A forest keeps no name.
ArmIdentity arm_of(const Forest& forest) {
  return {"", forest.key.arm_hash, forest.arm_description};
}

/// Its motions change set points as fast as the arm of then allowed.
std::string why_another_rate(const Forest& forest, const ArmDescription& arm) {
  if (forest.key.arm_hash == arm.hash()) {  // which holds the rate, too
    return "";
  }
  const std::optional<double> rate = rate_limit_of(arm_of(forest), "the forest");
  return !rate || *rate == arm.pressure_rate_limit_kpa_per_s
             ? std::string()
             : fmt::format(
                   "the forest was grown for {0} {2}/s, and '{3}' allows {1} {2}/s: grow it again",
                   *rate, arm.pressure_rate_limit_kpa_per_s, arm.command.unit, arm.name);
}

std::string bytes_of(const float* values, Eigen::Index count) {
  return {reinterpret_cast<const char*>(values), std::size_t(count) * sizeof(float)};
}

}  // namespace

TipGrid::TipGrid(const Eigen::Matrix3Xf& tips, const std::vector<float>& costs_kpa) {
  if (tips.cols() == 0) {
    return;
  }
  low_m_ = tips.topRows<2>().rowwise().minCoeff();
  const Eigen::Vector2f size_m = tips.topRows<2>().rowwise().maxCoeff() - low_m_;
  constexpr float kMinCellM = 1e-3F;
  cell_m_ = std::max(size_m.maxCoeff() / float(kMaxCells), kMinCellM);
  columns_ = cell_index(size_m.x(), kMaxCells) + 1;
  rows_ = cell_index(size_m.y(), kMaxCells) + 1;
  const auto cell_of = [&](Eigen::Index i) { return cell(column(tips(0, i)), row(tips(1, i))); };
  // A counting sort: how many there are in each cell, where each cell begins, then everyone's
  // place.
  begins_.assign(std::size_t(columns_) * std::size_t(rows_) + 1, 0);
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    ++begins_[cell_of(i) + 1];
  }
  for (std::size_t c = 1; c < begins_.size(); ++c) {
    begins_[c] += begins_[c - 1];
  }
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  tips_.resize(tips.cols());
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    tips_[next[cell_of(i)]++] = {tips(0, i), tips(1, i), tips(2, i), costs_kpa[i], std::int32_t(i)};
  }
}

int TipGrid::cell_index(float distance_m, int count) const {
  // Compared as floats: a point far away does not fit an int, nor does one that is not a number.
  const float cells = distance_m / cell_m_;
  if (!(cells > 0.0F)) {
    return 0;
  }
  return cells < float(count) ? int(cells) : count - 1;
}

void Forest::complete() {
  std::vector<double> sums(parents.size(), 0.0);
  for (std::size_t i = 1; i < sums.size(); ++i) {
    const auto parent = std::size_t(parents[i]);
    sums[i] = sums[parent] + motion_cost_kpa(setpoints_kpa.col(Eigen::Index(parent)),
                                             setpoints_kpa.col(Eigen::Index(i)));
  }
  costs_kpa.assign(sums.begin(), sums.end());
  lowest_kpa = setpoints_kpa.rowwise().minCoeff();
  highest_kpa = setpoints_kpa.rowwise().maxCoeff();
  tips = TipGrid(held_tips, costs_kpa);
}

bool is_grown_for(const Forest& forest, const ArmDescription& arm, const ForestKey& key) {
  ForestKey same_arm = key;
  same_arm.arm_hash = forest.key.arm_hash;
  return forest.key == same_arm && why_another_arm(arm_of(forest), arm, "the forest").empty() &&
         why_another_rate(forest, arm).empty();
}

void require_forest_of(const Forest& forest, const ArmDescription& arm,
                       const ValveParameters& valves, const ArmStart& start) {
  const std::string why = why_another_arm(arm_of(forest), arm, "the forest");
  refuse_if(!why.empty(), "the forest was grown for another arm than '{}': {}. Grow it again",
            arm.name, why);
  if (const std::string rate = why_another_rate(forest, arm); !rate.empty()) {
    throw InputError(rate);
  }
  const ForestKey key = forest_key(arm, forest.key.model_hash, valves, start);
  if (!is_grown_for(forest, arm, key)) {
    throw InputError(fmt::format(
        "the forest was grown for {} than '{}' has here: grow it again",
        forest.key.valves_hash != key.valves_hash ? "other valves" : "another start", arm.name));
  }
  const PressureBox box = pressure_box(arm);
  const auto refuse = [](const std::string& what) {
    throw InputError(fmt::format("the forest holds {}: it is broken; grow it again", what));
  };
  if (forest.highest_kpa.size() != box.high_kpa.size()) {
    refuse(fmt::format("{} set points per node; arm '{}' has {} segments",
                       forest.highest_kpa.size(), arm.name, box.high_kpa.size()));
  }
  if ((forest.highest_kpa.array() > box.high_kpa.array()).any() ||
      (forest.lowest_kpa.array() < box.low_kpa.array()).any()) {
    refuse("set points beyond the arm's limits");
  }
  const Eigen::Index numbers = kPoseSize * (arm.point_count() - 1);
  if (forest.shapes.rows() != numbers) {
    refuse(fmt::format("{} numbers per shape; arm '{}' needs {}", forest.shapes.rows(), arm.name,
                       numbers));
  }
}

ForestKey forest_key(const ArmDescription& arm, const std::string& model_hash,
                     const ValveParameters& valves, const ArmStart& start) {
  std::string bytes = bytes_of(start.pressures_kpa.data(), start.pressures_kpa.size()) +
                      bytes_of(start.backbone.data(), start.backbone.size()) +
                      bytes_of(start.before.data(), start.before.size());
  for (const Pressures& kpa : start.setpoints_kpa) {
    bytes += bytes_of(kpa.data(), kpa.size());
  }
  return {arm.hash(), model_hash, valves.hash(), content_hash(bytes)};
}

std::optional<Forest> grow_forest(const ArmDescription& arm, const MotionModel& model,
                                  const ForestKey& key, const ArmStart& start,
                                  const ForestSettings& settings, const ForestCallback& callback) {
  require_planar(arm, "a forest");
  refuse_if(settings.nodes < 1 || settings.nodes > Forest::kMaxNodes,
            "a forest of {} nodes; expected 1 to {}", settings.nodes, Forest::kMaxNodes);
  Grower grower(arm, model, start, settings);
  int idle_rounds = 0;
  while (grower.size() < settings.nodes && idle_rounds < kMaxIdleRounds) {
    const int before = grower.size();
    grower.round();
    idle_rounds = grower.size() == before ? idle_rounds + 1 : 0;
    if (callback && !callback(grower.size())) {
      return std::nullopt;
    }
  }
  Forest forest = grower.forest(key);
  forest.arm_description = arm_keys_to_yaml(arm);
  return forest;
}

}  // namespace limber
