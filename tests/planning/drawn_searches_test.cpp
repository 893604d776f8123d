// Laws of what planners grow, for problems drawn by a number: arms, play, valves, environments.
#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/planning/forest.hpp"
#include "planning/drawn_problem.hpp"
#include "src/planning/search/batch_search.hpp"
#include "support/property.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

constexpr double kSumShare = 1e-9;    // of costs added up in another order
constexpr float kFloatShare = 1e-5F;  // the same, in float32 along a path
constexpr float kRoundingKpa = 1e-3F;
constexpr int kSlower = 10;
constexpr int kSlowerForests = 20;
constexpr int kRounds = 4;
constexpr int kNodes = 60;

PlanningProblem problem_of(const DrawnProblem& drawn, const MotionModel& model) {
  PlanningProblem problem{drawn.arm, model, drawn.environment, drawn.margin_m};
  problem.limits = drawn.limits;
  return problem;
}

/// A search of a drawn problem.
struct Search {
  Search(const DrawnProblem& drawn, int jobs)
      : model(drawn.forward, ValveModel(drawn.arm, drawn.valves)),
        problem(problem_of(drawn, model)),
        checker(checker_of(problem)),
        simulator(problem, checker, {settings.hold_position_m, settings.hold_orientation_rad},
                  jobs),
        search(problem, simulator, settings, drawn.number) {}

  void grow() {
    for (int k = 0; k < kRounds; ++k) {
      (void)search.round(std::nullopt, [] { return false; });
    }
  }

  /// Planners search from no other.
  bool starts_lawfully() const {
    const ArmStart start = start_state(problem.environment, problem.arm);
    const std::vector<PressureLimits> limits = limits_of(problem);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      if (!limits[i].contains(double(start.pressures_kpa[Eigen::Index(i)]))) {
        return false;
      }
    }
    return checker.is_free(start.backbone);
  }

  DefaultPlannerSettings settings;
  MotionModel model;
  PlanningProblem problem;
  CollisionChecker checker;
  PathSimulator simulator;
  BatchSearch search;
};

TEST(DrawnSearches, CostsOfTreesAddUpAndTheirNodesKeepTheLimits) {
  expect_law(
      "every node costs its parent's cost and its motion, and is where the motion leads",
      [] {
        const DrawnProblem drawn(drawn_number());
        Search one(drawn, 1);
        RC_PRE(one.starts_lawfully());
        one.grow();
        const PressureTree& tree = one.search.tree();
        const std::vector<PressureLimits> limits = limits_of(one.problem);
        MotionSimulator simulator(drawn.arm, one.model, one.checker);
        MotionState end;
        RC_ASSERT(tree.cost_kpa(0) == 0.0);
        for (int i = 1; i < tree.size(); ++i) {
          const int parent = tree.parent(i);
          RC_ASSERT(parent < i);
          const double cost_kpa = tree.cost_kpa(parent) + (tree.setpoint_kpa(i).cast<double>() -
                                                           tree.setpoint_kpa(parent).cast<double>())
                                                              .lpNorm<1>();
          RC_ASSERT(std::abs(tree.cost_kpa(i) - cost_kpa) <= kSumShare * (1.0 + cost_kpa));
          for (int c = 0; c < drawn.arm.channel_count(); ++c) {
            RC_ASSERT(limits[std::size_t(c)].contains(double(tree.setpoint_kpa(i)[c])));
          }
          RC_ASSERT(simulator.move(tree.state(parent), tree.setpoint_kpa(i), end));
          RC_ASSERT(end == tree.state(i));
        }
      },
      kSlower);
}

TEST(DrawnSearches, TreesDoNotDependOnTheNumberOfThreads) {
  expect_law(
      "another number of threads grows the same tree",
      [] {
        const DrawnProblem drawn(drawn_number());
        Search one(drawn, 1);
        RC_PRE(one.starts_lawfully());
        Search three(drawn, 3);
        one.grow();
        three.grow();
        const PressureTree& a = one.search.tree();
        const PressureTree& b = three.search.tree();
        RC_ASSERT(a.size() == b.size());
        RC_ASSERT(one.simulator.queries() == three.simulator.queries());
        for (int i = 0; i < a.size(); ++i) {
          RC_ASSERT(a.parent(i) == b.parent(i));
          RC_ASSERT(a.cost_kpa(i) == b.cost_kpa(i));
          RC_ASSERT(a.state(i) == b.state(i));
        }
      },
      kSlower);
}

Forest forest_of(const DrawnProblem& drawn, int jobs) {
  const MotionModel model(drawn.forward, ValveModel(drawn.arm, drawn.valves));
  const ArmStart start = start_state(drawn.environment, drawn.arm);
  ForestSettings settings;
  settings.nodes = kNodes;
  settings.seed = drawn.number;
  settings.jobs = jobs;
  return *grow_forest(drawn.arm, model, forest_key(drawn.arm, "model", drawn.valves, start), start,
                      settings);
}

void check_same(const Forest& a, const Forest& b) {
  RC_ASSERT(a.key == b.key);
  RC_ASSERT(a.arm_description == b.arm_description);
  RC_ASSERT(a.parents == b.parents);
  RC_ASSERT(a.setpoints_kpa == b.setpoints_kpa);
  RC_ASSERT(a.held_tips == b.held_tips);
  RC_ASSERT(a.costs_kpa == b.costs_kpa);
  RC_ASSERT(a.shapes == b.shapes);
}

void check_costs_and_limits(const Forest& forest, const ArmDescription& arm) {
  RC_ASSERT(forest.costs_kpa.at(0) == 0.0F);
  for (std::size_t i = 1; i < forest.parents.size(); ++i) {
    const auto node = Eigen::Index(i);
    const Eigen::Index parent = forest.parents[i];
    RC_ASSERT(parent >= 0);
    RC_ASSERT(parent < node);
    const float cost_kpa =
        forest.costs_kpa[std::size_t(parent)] +
        (forest.setpoints_kpa.col(node) - forest.setpoints_kpa.col(parent)).lpNorm<1>();
    RC_ASSERT(std::abs(forest.costs_kpa[i] - cost_kpa) <= kFloatShare * cost_kpa + kRoundingKpa);
    for (int c = 0; c < arm.channel_count(); ++c) {
      const float kpa = forest.setpoints_kpa(c, node);
      RC_ASSERT(arm.limits_of_channel(c).contains(double(kpa)));
      RC_ASSERT(forest.lowest_kpa[c] <= kpa);
      RC_ASSERT(forest.highest_kpa[c] >= kpa);
    }
  }
}

TEST(DrawnSearches, ForestsAddUpComeBackFromTheirFilesAndDoNotDependOnThreads) {
  expect_law(
      "a forest's node costs its parent's cost and its motion; written and read, or grown by more "
      "threads, it is the same forest",
      [] {
        const DrawnProblem drawn(drawn_number());
        const Forest forest = forest_of(drawn, 1);
        check_costs_and_limits(forest, drawn.arm);
        check_same(forest, forest_of(drawn, 3));
        const TemporaryFolder folder;
        write_forest(folder.path() / "a.forest", forest);
        check_same(forest, read_forest(folder.path() / "a.forest"));
      },
      kSlowerForests);
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// Of any size: never by an index beyond its segments, nor by another message.
TEST(DrawnSearches, ArmsInSpaceAreRefusedByName) {
  expect_law("forests and planners say that they can't use an arm in space yet", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::space_arm(number, random);
    const ForwardModel forward(arm);
    const MotionModel model(forward);
    const ArmStart start{Pressures::Zero(arm.channel_count()),
                         Backbone::Zero(arm.point_count(), kPoseSize)};
    Environment environment;
    environment.goal = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    const std::string of_forest =
        refusal([&] { (void)grow_forest(arm, model, forest_key(arm, "", {}, start), start); });
    RC_ASSERT(of_forest.find("a forest can't use an arm in space") != std::string::npos);
    PlannerLimits limits;
    limits.iterations = 10;
    for (const char* name : {"default", "paper"}) {
      const std::string of_planner = refusal([&] {
        (void)make_planner(name)->plan({arm, model, environment}, limits, number);
      });
      RC_ASSERT(of_planner.find("a planner can't use an arm in space") != std::string::npos);
    }
  });
}

}  // namespace
}  // namespace limber
