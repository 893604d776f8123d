#include "src/planning/search/path_simulator.hpp"

#include <gtest/gtest.h>

#include "planning/play_model.hpp"

namespace limber {
namespace {

const auto kNever = [] { return false; };

struct Setting {
  ArmDescription arm = three_segment_arm();
  ForwardModel model{arm, play_network(arm, 0.01F)};
  Environment environment;
  ArmStart start = start_state(environment, arm);
  CollisionChecker checker{arm, {Circle{0.3, 0.35, 0.03}}, 0.0};

  Setting() { environment.goal = {0.6, -0.3, std::nullopt, 0.02, 0.3}; }

  std::vector<PathOutcome> run(const std::vector<Path>& paths, int jobs = 1) const {
    const PlanningProblem problem{arm, model, environment};
    PathSimulator simulator(problem, checker, {0.05, 0.5}, jobs);
    return simulator.run(paths, kNever);
  }

  Path path(std::vector<Pressures> to_kpa, bool hold = false) const {
    return {MotionModel(model).settled_state(start.pressures_kpa, start.backbone),
            std::move(to_kpa), hold};
  }

  std::vector<Path> random_paths(int count) const {
    RandomStream random(5, 1);
    std::vector<Path> paths;
    for (int k = 0; k < count; ++k) {
      paths.push_back(path({random_pressures(arm, random), random_pressures(arm, random)}, k % 2));
    }
    return paths;
  }
};

// One query after another, by the simulator that knows nothing of batches.
TEST(PathSimulator, EndsWhereOneMotionAfterAnotherEnds) {
  const Setting s;
  const std::vector<Path> paths = s.random_paths(60);
  const std::vector<PathOutcome> outcomes = s.run(paths);
  MotionSimulator simulator(s.arm, s.model, s.checker);
  int free = 0;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    MotionState at = paths[k].from;
    std::size_t done = 0;
    for (const Pressures& to : paths[k].to_kpa) {
      MotionState end;
      if (!simulator.move(at, to, end)) {
        break;
      }
      at = end;
      ASSERT_LT(done, outcomes[k].at.size()) << "path " << k;
      EXPECT_TRUE(outcomes[k].at[done] == at) << "path " << k;
      ++done;
    }
    EXPECT_EQ(outcomes[k].at.size(), done);
    EXPECT_EQ(outcomes[k].free, done == paths[k].to_kpa.size());
    free += outcomes[k].free ? 1 : 0;
  }
  EXPECT_GT(free, 10);
  EXPECT_LT(free, 58) << "the obstacle is in some paths' way";
}

TEST(PathSimulator, OutcomesDependOnNeitherNeighboursNorThreads) {
  const Setting s;
  const std::vector<Path> paths = s.random_paths(70);
  const std::vector<PathOutcome> together = s.run(paths, 2);
  for (std::size_t k = 0; k < paths.size(); k += 7) {
    const PathOutcome alone = s.run({paths[k]}).front();
    EXPECT_TRUE(alone.at == together[k].at);
    EXPECT_EQ(alone.queries, together[k].queries);
    EXPECT_EQ(alone.held_tip.has_value(), together[k].held_tip.has_value());
  }
}

// Far from the goal a hold is worth its queries only to those who ask for it.
TEST(PathSimulator, HoldsNearTheGoalAndWhereAskedTo) {
  const Setting s;
  const Pressures bent = Eigen::Vector3f(-20.0F, -20.0F, -20.0F);
  const PathOutcome passing = s.run({s.path({bent})}).front();
  const PathOutcome held = s.run({s.path({bent}, true)}).front();
  ASSERT_TRUE(passing.free);
  EXPECT_FALSE(passing.held_tip);
  ASSERT_TRUE(held.held_tip);
  EXPECT_FALSE(held.in_goal);
  EXPECT_EQ(held.queries, passing.queries + static_cast<std::uint64_t>(s.arm.frames_in(kHoldS)));

  Setting near;
  near.environment.goal = {held.held_tip->x_m, held.held_tip->y_m, std::nullopt, 0.02, 0.3};
  EXPECT_TRUE(near.run({near.path({bent})}).front().in_goal);
}

}  // namespace
}  // namespace limber
