#include "src/planning/forest/forest_search.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

const auto kNever = [] { return false; };

/// A forest of an arm with play, and obstacles in the way of a part of it.
class ForestSearches : public ::testing::Test {
 protected:
  static constexpr int kNodes = 4000;

  static void SetUpTestSuite() {
    setting_ = new Setting(true);
    setting_->environment.obstacles = {Circle{0.45, 0.22, 0.03}, Circle{0.5, -0.2, 0.05}};
    ForestSettings settings;
    settings.nodes = kNodes;
    const ArmStart start = start_state(setting_->environment, setting_->arm);
    forest_ =
        new Forest(*grow_forest(setting_->arm, setting_->model,
                                forest_key(setting_->arm, "model", {}, start), start, settings));
  }
  static void TearDownTestSuite() {
    delete forest_;
    delete setting_;
  }

  static std::vector<Pressures> waypoints_to(int node) {
    std::vector<Pressures> waypoints;
    for (int i = node; i >= 0; i = forest_->parents[static_cast<std::size_t>(i)]) {
      waypoints.emplace_back(forest_->setpoints_kpa.col(i));
    }
    std::reverse(waypoints.begin(), waypoints.end());
    return waypoints;
  }

  /// Held tips of nodes spread over the forest.
  static std::vector<PoseGoal> goals() {
    std::vector<PoseGoal> goals;
    for (int node = 50; node < kNodes; node += kNodes / 40) {
      const auto tip = forest_->held_tips.col(node);
      goals.push_back({double(tip[0]), double(tip[1]), std::nullopt, 0.015, 0.3});
    }
    return goals;
  }

  /// What the search finds, all rounds.
  struct Found {
    std::vector<BatchSearch::Solution> solutions;
    std::vector<std::vector<Pressures>> waypoints_kpa;
    int rounds = 0;
    std::uint64_t queries = 0;
  };

  /// @param stand  whether a solution is a plan; else all of them are refused
  static Found search(const PlanningProblem& problem, int jobs = 1, bool stand = true) {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles);
    PathSimulator simulator(problem, checker, {0.05, 0.5}, jobs);
    BatchSearch tree(problem, simulator, {}, 1);
    ForestSearch search(*forest_, problem, checker, simulator, tree);
    Found found;
    for (ForestSearch::Round round{true, {}}; round.more && found.rounds < kNodes; ++found.rounds) {
      round = search.round(kNever, stand && !found.solutions.empty());
      for (const BatchSearch::Solution& one : round.found) {
        found.solutions.push_back(one);
        found.waypoints_kpa.push_back(tree.waypoints_to(one.node));
      }
    }
    found.queries = simulator.queries();
    return found;
  }

  static inline Setting* setting_ = nullptr;
  static inline Forest* forest_ = nullptr;
};

// Brute force: every node of the forest, all motions on the way there and the hold, one frame
// after another.
TEST_F(ForestSearches, FindWhatBruteForceFinds) {
  Setting& s = *setting_;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const CollisionChecker checker(s.arm, s.environment.obstacles);
  std::map<int, Pose> held;  // of the nodes that are free
  for (int node = 1; node < kNodes; ++node) {
    const Walk one = walk(problem, checker, waypoints_to(node));
    if (one.is_free) {
      held[node] = one.held_tip;
    }
  }
  ASSERT_GT(held.size(), kNodes / 10U);
  ASSERT_LT(held.size(), kNodes - 100U) << "the obstacles are in the way of something";

  int solvable = 0, cheapest = 0, with_a_plan = 0;
  for (const PoseGoal& goal : goals()) {
    s.environment.goal = goal;
    double best_kpa = std::numeric_limits<double>::infinity();
    for (const auto& [node, tip] : held) {
      if (is_within(goal, pose_error(goal, tip))) {
        best_kpa = std::min(best_kpa, double(forest_->costs_kpa[static_cast<std::size_t>(node)]));
      }
    }
    const Found found = search(problem);
    if (!std::isfinite(best_kpa)) {
      continue;
    }
    ++solvable;
    with_a_plan += found.solutions.empty() ? 0 : 1;
    constexpr double kRoundingKpa = 1e-2;  // the forest keeps costs as float32
    cheapest +=
        !found.solutions.empty() && found.solutions.front().cost_kpa <= best_kpa + kRoundingKpa ? 1
                                                                                                : 0;
  }
  ASSERT_GT(solvable, 10);
  EXPECT_EQ(with_a_plan, solvable);
  EXPECT_GE(cheapest, 9 * solvable / 10) << "the filter guesses, and may pass one over";
}

TEST_F(ForestSearches, SolutionsAreFreeAndEndInTheGoal) {
  Setting& s = *setting_;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const CollisionChecker checker(s.arm, s.environment.obstacles);
  std::size_t count = 0;
  for (const PoseGoal& goal : goals()) {
    s.environment.goal = goal;
    const Found found = search(problem);
    for (std::size_t k = 0; k < found.solutions.size(); ++k) {
      ++count;
      const Walk alone = walk(problem, checker, found.waypoints_kpa[k]);
      EXPECT_TRUE(ends_in_goal(problem, alone));
      EXPECT_EQ(alone.held_tip.x_m, found.solutions[k].held_tip.x_m);
      EXPECT_NEAR(path_cost_kpa(found.waypoints_kpa[k]), found.solutions[k].cost_kpa, 1e-2);
    }
  }
  EXPECT_GT(count, 20U);
}

TEST_F(ForestSearches, GoOnWhereAllThatTheyFoundIsRefused) {
  Setting& s = *setting_;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  std::size_t standing = 0, refused = 0;
  for (const PoseGoal& goal : goals()) {
    s.environment.goal = goal;
    standing += search(problem).solutions.size();
    refused += search(problem, 1, false).solutions.size();
  }
  EXPECT_GT(refused, standing);
}

TEST_F(ForestSearches, StayWithinTheSetPointsThatWereRecorded) {
  Setting& s = *setting_;
  PlanningProblem problem{s.arm, s.model, s.environment};
  const Eigen::Index joint = 3 + 3 * (s.arm.point_count() - 1);
  LearntRegion learnt;  // any shape and rate is known
  learnt.low_kpa = Pressures::Constant(3, -60.0F);
  learnt.high_kpa = Pressures::Constant(3, 60.0F);
  learnt.steepest_fall_kpa_per_s = learnt.steepest_rise_kpa_per_s = Pressures::Constant(3, 1e6F);
  learnt.joint_offset = Eigen::VectorXf::Zero(joint);
  learnt.joint_scale = Eigen::VectorXf::Ones(joint);
  learnt.axes = Eigen::MatrixXf::Zero(1, joint);
  learnt.axes(0, joint - 1) = 1.0F;
  learnt.axis_low = Eigen::VectorXf::Constant(1, -100.0F);
  learnt.axis_high = Eigen::VectorXf::Constant(1, 100.0F);
  const RecordedRegion region(learnt, s.arm.frame_rate_hz);
  problem.stay_within = &region;
  for (const PoseGoal& goal : goals()) {
    s.environment.goal = goal;
    for (const std::vector<Pressures>& waypoints_kpa : search(problem).waypoints_kpa) {
      for (const Pressures& kpa : waypoints_kpa) {
        EXPECT_LE(kpa.cwiseAbs().maxCoeff(), 60.0F);
      }
    }
  }
}

TEST_F(ForestSearches, AreTheSameForAnyNumberOfThreads) {
  Setting& s = *setting_;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  for (const PoseGoal& goal : goals()) {
    s.environment.goal = goal;
    const Found one = search(problem, 1);
    const Found two = search(problem, 2);
    EXPECT_EQ(one.waypoints_kpa, two.waypoints_kpa);
    EXPECT_EQ(one.queries, two.queries);
    EXPECT_EQ(one.rounds, two.rounds);
  }
}

// What the stored shapes rule out costs no query of the model.
TEST_F(ForestSearches, WhereNothingIsFreeTheyEndWithoutAQuery) {
  Setting s(true);
  s.environment.goal = goals().front();
  s.environment.obstacles = {Rectangle{0.35, 0.12, 1.0, 0.1, 0.0},
                             Rectangle{0.35, -0.12, 1.0, 0.1, 0.0}};
  const PlanningProblem problem{s.arm, s.model, s.environment};
  s.environment.goal = {0.1, 0.5, std::nullopt, 0.015, 0.3};
  const Found found = search(problem);
  EXPECT_TRUE(found.solutions.empty());
  EXPECT_EQ(found.queries, 0U);
  EXPECT_LT(found.rounds, 100);
}

}  // namespace
}  // namespace limber
