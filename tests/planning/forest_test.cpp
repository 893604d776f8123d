#include "limber/planning/forest.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/play_model.hpp"
#include "support/sample_arm.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kNodes = 3000;
constexpr float kPlayM = 0.01F;

struct Setting {
  ArmDescription arm = three_segment_arm();
  ForwardModel model{arm, play_network(arm, kPlayM)};
  Environment environment;
  ArmStart start = start_state(environment, arm);

  Setting() {
    environment.name = "behind a pillar";
    environment.obstacles = {Circle{0.45, 0.22, 0.025}};
    environment.goal = {0.30, 0.40, std::nullopt, 0.02, 0.3};
  }

  Forest grow(int jobs = 1, std::uint64_t seed = 1, int nodes = kNodes) const {
    ForestSettings settings;
    settings.nodes = nodes;
    settings.jobs = jobs;
    settings.seed = seed;
    return *grow_forest(arm, model, forest_key(arm, "model", {}, start), start, settings);
  }

  PlanResult plan(const Forest* forest, std::uint64_t iterations, std::uint64_t seed = 3) const {
    PlannerLimits limits;
    limits.iterations = iterations;
    return make_planner("default", 1, forest)->plan({arm, model, environment}, limits, seed);
  }
};

// Every node is what its motions from the start lead to, by one query after another.
TEST(Forest, EveryNodeIsWhereItsMotionsLead) {
  const Setting s;
  const Forest forest = s.grow();
  ASSERT_EQ(forest.size(), kNodes);
  const CollisionChecker free(s.arm, {}, 0.0);
  MotionSimulator simulator(s.arm, s.model, free);
  std::vector<MotionState> states{simulator.start(s.start)};
  for (int i = 1; i < forest.size(); ++i) {
    const int parent = forest.parents[static_cast<std::size_t>(i)];
    ASSERT_LT(parent, i);
    MotionState at;
    simulator.move_unchecked(states[static_cast<std::size_t>(parent)], forest.setpoints_kpa.col(i),
                             at);
    states.push_back(at);
    MotionState held;
    ASSERT_TRUE(simulator.hold(at, held));
    constexpr float kRounding = 1e-5F;  // [m, rad]; batches round as single queries do, nearly
    EXPECT_TRUE(
        held.backbone.bottomRows<1>().transpose().isApprox(forest.held_tips.col(i), kRounding))
        << "node " << i;
    Backbone stored = s.start.backbone;
    blend_shapes(forest.shapes.col(i), forest.shapes.col(i), 0.0F, s.arm.length_m(), stored);
    constexpr float kStored =
        1e-3F;  // [m, rad]; 15 gaps of half a unit each, and their turns' lever
    EXPECT_LT((stored - at.backbone).cwiseAbs().maxCoeff(), kStored) << "node " << i;
    EXPECT_LE(
        (forest.setpoints_kpa.col(i).array().abs() - pressure_limits_kpa(s.arm).array()).maxCoeff(),
        0.0F);
  }
}

TEST(Forest, IsTheSameForAnyNumberOfThreads) {
  const Setting s;
  const Forest one = s.grow(1);
  const Forest two = s.grow(2);
  EXPECT_EQ(one.parents, two.parents);
  EXPECT_EQ(one.setpoints_kpa, two.setpoints_kpa);
  EXPECT_EQ(one.held_tips, two.held_tips);
  EXPECT_EQ(one.shapes, two.shapes);
  EXPECT_NE(one.setpoints_kpa, s.grow(1, 2).setpoints_kpa) << "the seed counts";
}

// Where nothing is in the way, a motion of the forest is a plan at once.
TEST(Forest, GivesAPlanWithFewerQueriesAndLessCost) {
  Setting s;
  s.environment.obstacles = {Circle{-0.3, 0.3, 0.02}};
  constexpr int kDense = 30'000;  // some of them end in the goal
  const Forest forest = s.grow(2, 1, kDense);
  FirstSolution without{0.0, 0.0, 0};
  FirstSolution with{0.0, 0.0, 0};
  const auto add = [](const PlanResult& result, FirstSolution& sum) {
    sum.queries += result.first_solution->queries;
    sum.cost_kpa += result.first_solution->cost_kpa;
  };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PlanResult bare = s.plan(nullptr, 2000, seed);
    const PlanResult helped = s.plan(&forest, 2000, seed);
    ASSERT_EQ(bare.status, PlanStatus::solved);
    ASSERT_EQ(helped.status, PlanStatus::solved) << helped.reason;
    ASSERT_TRUE(helped.certificate->certified());
    add(bare, without);
    add(helped, with);
  }
  EXPECT_LT(with.queries, without.queries);
  EXPECT_LT(with.cost_kpa, without.cost_kpa);
}

TEST(Forest, PlansAreTheSameForAnyNumberOfThreads) {
  const Setting s;
  const Forest forest = s.grow();
  PlannerLimits limits;
  limits.iterations = 2000;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const PlanResult one = make_planner("default", 1, &forest)->plan(problem, limits, 5);
  const PlanResult two = make_planner("default", 2, &forest)->plan(problem, limits, 5);
  ASSERT_EQ(one.status, PlanStatus::solved);
  EXPECT_EQ(one.plan->waypoints_kpa, two.plan->waypoints_kpa);
  EXPECT_EQ(one.statistics.queries, two.statistics.queries);
}

/// 0 → A → B, and where A's tip is held. The goal is about that place.
struct ByHand {
  Setting s;
  Forest forest;
  Pose held;
  Pose at_b;

  ByHand() {
    const Pressures to_a = Eigen::Vector3f(-40.0F, -40.0F, -40.0F);
    const Pressures to_b = Eigen::Vector3f(-90.0F, -90.0F, -90.0F);
    forest.key = forest_key(s.arm, "model", {}, s.start);
    forest.parents = {-1, 0, 1};
    forest.setpoints_kpa.resize(3, 3);
    forest.setpoints_kpa << s.start.pressures_kpa, to_a, to_b;
    const CollisionChecker free(s.arm, {}, 0.0);
    MotionSimulator simulator(s.arm, s.model, free);
    MotionState a, held_at_a, b;
    simulator.move_unchecked(simulator.start(s.start), to_a, a);
    EXPECT_TRUE(simulator.hold(a, held_at_a));
    simulator.move_unchecked(a, to_b, b);
    forest.shapes.resize(45, 3);
    int column = 0;
    for (const Backbone& shape : {s.start.backbone, a.backbone, b.backbone}) {
      round_shape(shape, s.arm.length_m(), forest.shapes.col(column++));
    }
    held = tip_pose(held_at_a.backbone);
    at_b = tip_pose(b.backbone);
    s.environment.goal = {held.x_m, held.y_m, std::nullopt, 0.01, 0.3};
    s.environment.obstacles = {};
    set_held_tips(held);
  }

  /// B is said to be held at `tip_of_b`.
  void set_held_tips(const Pose& tip_of_b) {
    const auto column = [](const Pose& pose) {
      return Eigen::Vector3d(pose.x_m, pose.y_m, pose.theta_rad).cast<float>().eval();
    };
    forest.held_tips.resize(3, 3);
    forest.held_tips << Eigen::Vector3f(0.7F, 0.0F, 0.0F), column(held), column(tip_of_b);
    forest.complete();
  }
};

TEST(Forest, AMotionThatEndsInTheGoalIsAPlanAtOnce) {
  const ByHand hand;
  const PlanResult result = hand.s.plan(&hand.forest, 1);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_NEAR(result.first_solution->cost_kpa, 120.0, 1e-3);
}

// No motion of the forest ends in the goal; a Newton step behind the one that ends 3 cm off does.
// It leads on, not back: a step back would be lost in the play.
TEST(Forest, AMotionThatEndsNearTheGoalIsTakenThereByAStep) {
  ByHand hand;
  hand.set_held_tips(hand.at_b);
  hand.s.environment.goal.x_m -= 0.03;
  const PlanResult bare = hand.s.plan(nullptr, 1000);
  const PlanResult result = hand.s.plan(&hand.forest, 1000);
  ASSERT_EQ(bare.status, PlanStatus::solved) << bare.reason;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  constexpr std::uint64_t kMotion = 60;  // frames to A, of the step, and of the hold
  EXPECT_LT(result.first_solution->queries, kMotion);
  EXPECT_GT(bare.first_solution->queries, kMotion);
}

TEST(Forest, OfAnotherMachinesFitOfTheSameArmIsItsOwn) {
  Setting s;
  const Forest forest = s.grow();
  s.arm.segments[0].strain_polynomial[0] += 1e-9;  // 1e-7 of strain
  const ForestKey key = forest_key(s.arm, "model", {}, s.start);
  ASSERT_NE(key.arm_hash, forest.key.arm_hash);
  EXPECT_TRUE(is_grown_for(forest, s.arm, key));
  EXPECT_NO_THROW(require_forest_of(forest, s.arm, {}, s.start));
  EXPECT_FALSE(is_grown_for(forest, s.arm, forest_key(s.arm, "another model", {}, s.start)));
}

TEST(Forest, OfAnotherArmOrStartIsRefused) {
  Setting s;
  Forest forest = s.grow();
  const auto refusal = [&](const char* message) {
    EXPECT_THAT([&] { (void)s.plan(&forest, 10); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  const std::optional<ArmStart> rest = s.environment.start;
  Backbone bent = s.start.backbone;
  bent(15, 1) += 0.01F;
  s.environment.start = ArmStart{s.start.pressures_kpa, bent};
  refusal("grown for another start");
  s.environment.start = rest;
  forest.setpoints_kpa(1, 7) = 1e6F;
  forest.complete();
  refusal("set points beyond the arm's limits");
  forest.setpoints_kpa.conservativeResize(2, Eigen::NoChange);
  forest.complete();
  refusal("2 set points per node; arm 'three_segment' has 3 segments");
  forest = s.grow();
  forest.shapes.conservativeResize(42, Eigen::NoChange);
  refusal("42 numbers per shape; arm 'three_segment' needs 45");
  ArmDescription longer = s.arm;
  longer.segments[1].length_m = 0.3;
  forest.key.arm_hash = longer.hash();
  forest.arm_description = arm_keys_to_yaml(longer);
  refusal("another arm than 'three_segment': segments[1].length_m: 0.3 there, 0.235 here");
  ArmDescription faster = s.arm;
  faster.pressure_rate_limit_kpa_per_s = 150.0;
  forest.key.arm_hash = faster.hash();
  forest.arm_description = arm_keys_to_yaml(faster);
  refusal("grown for 150 kPa/s, and 'three_segment' allows 100 kPa/s");
  forest.arm_description.clear();
  refusal("grown for another arm");
  EXPECT_THAT([&] { (void)make_planner("paper", 1, &forest); },
              ThrowsMessage<InputError>(HasSubstr("planner 'paper' uses no forest")));
}

TEST(Forest, OfAnArmInSpaceIsRefused) {
  const ArmDescription arm = testing_support::space_arm();
  const ForwardModel model(arm);
  const ArmStart start{Pressures::Zero(arm.channel_count()), Backbone::Zero(arm.point_count(), 3)};
  EXPECT_THAT([&] { (void)grow_forest(arm, model, forest_key(arm, "model", {}, start), start); },
              ThrowsMessage<InputError>(HasSubstr("a forest can't use an arm in space yet")));
}

TEST(Forest, OfAModelThatRunsOffIsRefused) {
  Setting s;
  CompensationModel model = play_network(s.arm, kPlayM);
  model.layers.back().weight *= 1e30F;
  model.layers.front().weight *= 1e30F;
  const ForwardModel wild(s.arm, model);
  EXPECT_THAT(
      [&] { (void)grow_forest(s.arm, wild, forest_key(s.arm, "wild", {}, s.start), s.start); },
      ThrowsMessage<InputError>(HasSubstr("the model diverges")));
}

}  // namespace
}  // namespace limber
