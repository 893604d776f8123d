#include "src/planning/ompl/pruned_sst.hpp"

#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/PlannerData.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "src/planning/ompl/arm_space.hpp"

namespace limber {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

constexpr double kCostRounding = 1e-9;  // of a cost, in double

/// Stable sparse RRT on the arm among pillars. Its laws hold for any draws.
class PrunedSstTree : public ::testing::TestWithParam<double> {
 protected:
  static void SetUpTestSuite() {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(5);
  }

  void SetUp() override {
    si_ = make_space_information(world_);
    definition_ = std::make_shared<ob::ProblemDefinition>(si_);
    ob::ScopedState<> start(si_);
    world_.write(start_of(problem_), 0.0, true, start.get());
    definition_->addStartState(start);
    const PlanResult solved = setting_.plan("default", 1500);
    ASSERT_TRUE(solved.plan);
    world_.goal_configurations = {solved.plan->frames.back().setpoint_kpa};
    definition_->setGoal(make_arm_goal(world_, si_));
    definition_->setOptimizationObjective(make_pressure_objective(world_, si_, 0.0));
    planner_ = std::make_unique<PrunedSst>(si_);
    planner_->setPruningRadius(GetParam());
    planner_->setSelectionRadius(1.5 * GetParam());
    planner_->setGoalBias(0.2);
    planner_->setProblemDefinition(definition_);
    planner_->setup();
  }

  ob::PlannerStatus search(int iterations) {
    int asked = 0;
    return planner_->solve(
        ob::PlannerTerminationCondition([&asked, iterations] { return ++asked > iterations; }));
  }

  double cost(const ob::State* state) const {
    return state->as<ob::RealVectorStateSpace::StateType>()->values[world_.cost_index()];
  }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  CollisionChecker checker_{setting_.arm, setting_.environment.obstacles};
  MotionSimulator simulator_{setting_.arm, problem_.model, checker_};
  ArmWorld world_{problem_, checker_, simulator_, {}, RandomStream(3, 1)};
  oc::SpaceInformationPtr si_;
  ob::ProblemDefinitionPtr definition_;
  std::unique_ptr<PrunedSst> planner_;
};

// The invariant that makes the tree sparse: one active node per witness, and no node kept without
// need: who is dominated has children.
TEST_P(PrunedSstTree, HasOneActiveNodePerWitnessAndNoDominatedLeaf) {
  (void)search(3000);
  const SstCounts counts = planner_->counts();
  EXPECT_EQ(counts.active, counts.witnesses);
  ob::PlannerData data(si_);
  planner_->getPlannerData(data);
  std::size_t leaves = 0;
  std::size_t nodes = 0;
  for (unsigned v = 0; v < data.numVertices(); ++v) {
    std::vector<unsigned> next;
    const bool is_root = data.isStartVertex(v);
    const bool is_copy = data.isGoalVertex(v) && data.getIncomingEdges(v, next) == 0 && !is_root;
    nodes += is_copy ? 0 : 1;
    leaves += !is_copy && data.getEdges(v, next) == 0 ? 1 : 0;
  }
  EXPECT_EQ(nodes, counts.active + counts.inactive) << "every node is on a branch to a leaf";
  EXPECT_LE(leaves, counts.active);
  EXPECT_LE(counts.inactive, nodes - leaves);
}

// A coarser witness set makes a smaller tree of the same effort: witnesses lie farther apart than
// the pruning radius.
TEST_P(PrunedSstTree, StaysSmallerThanWhatWasTried) {
  (void)search(3000);
  EXPECT_GT(planner_->counts().active, 1U);
  EXPECT_LT(planner_->counts().active + planner_->counts().inactive, 3000U);
}

TEST_P(PrunedSstTree, EveryEdgeIsTheMotionThatItsControlMakes) {
  (void)search(600);
  oc::PlannerData data(si_);
  planner_->getPlannerData(data);
  ob::ScopedState<> end(si_);
  int edges = 0;
  for (unsigned v = 0; v < data.numVertices(); ++v) {
    std::vector<unsigned> children;
    data.getEdges(v, children);
    for (const unsigned child : children) {
      ++edges;
      const auto& edge = static_cast<const oc::PlannerDataEdgeControl&>(data.getEdge(v, child));
      const ob::State* from = data.getVertex(v).getState();
      const ob::State* to = data.getVertex(child).getState();
      const auto frames =
          static_cast<int>(std::lround(edge.getDuration() / si_->getPropagationStepSize()));
      ASSERT_GE(frames, 1);
      si_->propagate(from, edge.getControl(), frames, end.get());
      EXPECT_TRUE(si_->equalStates(end.get(), to));
      EXPECT_TRUE(si_->isValid(to));
      EXPECT_GE(cost(to), cost(from));
    }
  }
  const SstCounts counts = planner_->counts();
  EXPECT_EQ(std::size_t(edges) + 1, counts.active + counts.inactive) << "a tree";
  EXPECT_GT(edges, 1);
}

TEST_P(PrunedSstTree, ASolutionLeadsFromTheStartIntoTheGoal) {
  const ob::PlannerStatus status = search(6000);
  const ob::PathPtr found = definition_->getSolutionPath();
  ASSERT_TRUE(found) << status.asString();
  auto& path = static_cast<oc::PathControl&>(*found);
  EXPECT_TRUE(si_->equalStates(path.getState(0), definition_->getStartState(0)));
  EXPECT_EQ(definition_->hasApproximateSolution(), status != ob::PlannerStatus::EXACT_SOLUTION);
  const ob::State* end = path.getState(path.getStateCount() - 1);
  EXPECT_EQ(definition_->getGoal()->isSatisfied(end), !definition_->hasApproximateSolution());
  double sum = 0.0;
  const ob::OptimizationObjectivePtr objective = definition_->getOptimizationObjective();
  for (std::size_t i = 1; i < path.getStateCount(); ++i) {
    sum += objective->motionCost(path.getState(i - 1), path.getState(i)).value();
  }
  EXPECT_NEAR(sum, cost(end), kCostRounding * cost(end));
  EXPECT_TRUE(path.check()) << "every control gives the state behind it, without collision";
}

INSTANTIATE_TEST_SUITE_P(Radii, PrunedSstTree, ::testing::Values(0.1, 0.3, 0.6),
                         [](const auto& radius) {
                           return "Radius" + std::to_string(int(10.0 * radius.param));
                         });

TEST(PrunedSst, WithoutAStartThatIsFreeItSaysSo) {
  ompl::msg::noOutputHandler();
  Setting setting(false);
  const PlanningProblem problem{setting.arm, setting.model, setting.environment};
  const CollisionChecker checker(setting.arm, setting.environment.obstacles);
  MotionSimulator simulator(setting.arm, problem.model, checker);
  ArmWorld world{problem, checker, simulator, {}, RandomStream(3, 1)};
  world.goal_configurations = {Pressures::Zero(3)};
  const oc::SpaceInformationPtr si = make_space_information(world);
  auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<> start(si);
  world.write(start_of(problem), 0.0, false, start.get());
  definition->addStartState(start);
  definition->setGoal(make_arm_goal(world, si));
  definition->setOptimizationObjective(make_pressure_objective(world, si, 0.0));
  PrunedSst planner(si);
  planner.setProblemDefinition(definition);
  planner.setup();
  EXPECT_EQ(planner.solve(ob::PlannerTerminationCondition([] { return false; })),
            ob::PlannerStatus::INVALID_START);
}

}  // namespace
}  // namespace limber
