#include "src/planning/forest/forest_search.hpp"

#include <gtest/gtest.h>

#include "limber/forward/motion_simulator.hpp"
#include "planning/play_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

struct Setting {
  ArmDescription arm = three_segment_arm();
  ForwardModel model{arm, play_network(arm, 0.01F)};
  Environment environment;
  ArmStart start = start_state(environment, arm);
  Forest forest;

  Setting() {
    environment.goal = {0.3, 0.4, std::nullopt, 0.02, 0.3};
    ForestSettings settings;
    settings.nodes = 3000;
    settings.jobs = 1;
    forest = *grow_forest(arm, model, forest_key(arm, "model", {}, start), start, settings);
  }

  /// The truth about every node, simulated frame by frame: motions and hold.
  std::vector<bool> free(const CollisionChecker& checker) const {
    MotionSimulator simulator(arm, model, checker);
    std::vector<MotionState> at{simulator.start(start)};
    std::vector<bool> way{true};
    std::vector<bool> all{true};
    MotionState end, held;
    for (int i = 1; i < forest.size(); ++i) {
      const auto parent = static_cast<std::size_t>(forest.parents[static_cast<std::size_t>(i)]);
      way.push_back(way[parent] && simulator.move(at[parent], forest.setpoints_kpa.col(i), end));
      all.push_back(way.back() && simulator.hold(end, held));
      at.push_back(end);
    }
    return all;
  }
};

TEST(ForestFilter, MostlyAgreesWithTheModel) {
  Setting s;
  s.environment.obstacles = {Circle{0.45, 0.22, 0.025}, Circle{0.5, -0.2, 0.04}};
  const CollisionChecker checker(s.arm, s.environment.obstacles, 0.0);
  const std::vector<bool> truth = s.free(checker);
  ForestFilter filter(s.forest, {s.arm, s.model, s.environment}, checker);
  int said = 0, are = 0, both = 0;
  for (int i = s.forest.size(); i-- > 1;) {
    const bool is_free = truth[static_cast<std::size_t>(i)];
    const bool says_free = filter.leaves_free(i);
    said += says_free ? 1 : 0;
    are += is_free ? 1 : 0;
    both += is_free && says_free ? 1 : 0;
  }
  ASSERT_GT(are, 300);
  ASSERT_LT(are, 2700) << "the obstacles are in the way of something";
  EXPECT_GT(both, 0.9 * said) << said << " said to be free";
  EXPECT_GT(both, 0.9 * are) << are << " are free";
}

TEST(ForestFilter, WithoutObstaclesEverythingIsFree) {
  const Setting s;
  const CollisionChecker checker(s.arm, {}, 0.0);
  ForestFilter filter(s.forest, {s.arm, s.model, s.environment}, checker);
  for (int i = 0; i < s.forest.size(); ++i) {
    EXPECT_TRUE(filter.leaves_free(i));
  }
}

}  // namespace
}  // namespace limber
