#include "limber/lab/plan_spread.hpp"

#include <gtest/gtest.h>

#include "limber/forward/forward_model.hpp"
#include "limber/world/collision.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

constexpr double kRoundingM = 1e-6;  // float32 positions of the order of 1 m

/// A plan of the first of three arms with more and more play, and each by itself.
struct Planned {
  ArmDescription arm = three_segment_arm();
  Environment environment = pillars();
  CompensationModel model;
  Plan plan;

  Planned() : model(play_network(arm, kPlays[0])) {
    model.more_members = {play_network(arm, kPlays[1]).layers, play_network(arm, kPlays[2]).layers};
    const ForwardModel first(arm, model.member(0));
    PlannerLimits limits;
    limits.iterations = 1000;
    const PlanResult result = make_planner("default")->plan({arm, first, environment}, limits, 3);
    plan = result.plan.value_or(Plan{});
  }

  /// Member k's backbones, by steps of its own.
  std::vector<Backbone> alone(int k) const {
    const ForwardModel member(arm, play_network(arm, kPlays[k]));
    std::vector<Backbone> shapes{plan.frames.front().backbone};
    for (std::size_t t = 1; t < plan.frames.size(); ++t) {
      shapes.push_back(member.checked_step(plan.frames[t - 1].pressure_kpa,
                                           plan.frames[t].pressure_kpa, shapes.back()));
    }
    return shapes;
  }

  static constexpr float kPlays[] = {0.005F, 0.008F, 0.02F};
};

TEST(PlanSpread, IsThatOfTheNetworksEachByItself) {
  const Planned p;
  ASSERT_FALSE(p.plan.frames.empty()) << "not solved";
  const auto spread = plan_spread(p.plan, p.arm, p.model, p.environment);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->members, 3);

  const int last = p.plan.frame_count() - 1;
  std::vector<std::vector<Backbone>> shapes{p.alone(0), p.alone(1), p.alone(2)};
  double nearest = 1e9, farthest = 0.0, widest = 0.0, clearance = 1e9;
  const CollisionChecker checker(p.arm, p.environment.obstacles);
  for (const auto& one : shapes) {
    const auto tip = one.back().row(15);
    const double distance = std::hypot(double(tip[0]) - p.environment.goal.x_m,
                                       double(tip[1]) - p.environment.goal.y_m);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
    for (const auto& other : shapes) {
      widest = std::max(
          widest, double((one.back() - other.back()).leftCols(2).rowwise().norm().maxCoeff()));
    }
    for (std::size_t t = 1; t < one.size(); ++t) {
      clearance = std::min(clearance, checker.motion_clearance(one[t - 1], one[t]).value_m);
    }
  }
  EXPECT_NEAR(spread->goal_distance.min_m, nearest, kRoundingM);
  EXPECT_NEAR(spread->goal_distance.max_m, farthest, kRoundingM);
  EXPECT_GE(spread->goal_distance.mean_m, nearest);
  EXPECT_LE(spread->goal_distance.mean_m, farthest);
  EXPECT_EQ(spread->end.frame, last);
  EXPECT_NEAR(spread->end.largest_distance_m, widest, kRoundingM);
  EXPECT_GT(widest, 1e-3) << "they differ";
  EXPECT_LE(spread->end.standard_deviation_m, widest);
  ASSERT_TRUE(spread->closest);
  // The checker's bound is this close, and pairs that cannot be nearest are not looked at closely.
  EXPECT_NEAR(spread->closest->clearance.min_m, clearance, CollisionChecker::kToleranceM);
  const auto& at = spread->closest->at;
  double there = 0.0;
  for (const auto& one : shapes) {
    for (const auto& other : shapes) {
      const auto t = static_cast<std::size_t>(at.frame);
      there = std::max(there, double((one[t] - other[t]).row(at.plate).head(2).norm()));
    }
  }
  EXPECT_NEAR(at.largest_distance_m, there, kRoundingM);
}

TEST(PlanSpread, OneNetworkHasNoneAndAFreeEnvironmentNoClosestApproach) {
  Planned p;
  ASSERT_FALSE(p.plan.frames.empty()) << "not solved";
  EXPECT_FALSE(plan_spread(p.plan, p.arm, p.model.member(0), p.environment));
  p.environment.obstacles.clear();
  const auto spread = plan_spread(p.plan, p.arm, p.model, p.environment);
  ASSERT_TRUE(spread);
  EXPECT_FALSE(spread->closest);
}

}  // namespace
}  // namespace limber
