#include "src/planning/search/second_opinions.hpp"

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

/// An ensemble of arms with more and more play.
CompensationModel ensemble(const ArmDescription& arm, const std::vector<float>& plays_m) {
  CompensationModel model = play_network(arm, plays_m.front());
  for (std::size_t i = 1; i < plays_m.size(); ++i) {
    model.more_members.push_back(play_network(arm, plays_m[i]).layers);
  }
  return model;
}

struct Opinions {
  explicit Opinions(const std::vector<float>& plays_m)
      : model(arm, ensemble(arm, plays_m)), problem{arm, model, environment} {
    for (const float play_m : plays_m) {
      members.push_back(std::make_unique<ForwardModel>(arm, play_network(arm, play_m)));
    }
  }

  /// Each member but the leading one by itself, one frame after another.
  bool others_agree(const std::vector<Pressures>& waypoints_kpa) const {
    for (std::size_t i = 1; i < members.size(); ++i) {
      const PlanningProblem alone{arm, *members[i], environment};
      if (!ends_in_goal(alone, walk(alone, checker, waypoints_kpa))) {
        return false;
      }
    }
    return true;
  }

  ArmDescription arm = three_segment_arm();
  Environment environment = pillars();
  ForwardModel model;
  PlanningProblem problem;
  CollisionChecker checker{arm, environment.obstacles};
  std::vector<std::unique_ptr<ForwardModel>> members;
};

TEST(SecondOpinions, OfOneNetworkOrNoneThereIsNobodyToAsk) {
  for (const bool play : {false, true}) {
    const Setting s(play);
    const PlanningProblem problem{s.arm, s.model, s.environment};
    const CollisionChecker checker(s.arm, s.environment.obstacles);
    SecondOpinions opinions(problem, checker);
    EXPECT_TRUE(opinions.empty());
    EXPECT_TRUE(opinions.agree({Pressures::Zero(3), Pressures::Constant(3, 100.0F)}));
    EXPECT_EQ(opinions.queries(), 0U);
  }
}

TEST(SecondOpinions, AgreeWhereEveryOtherMemberEndsInTheGoalFreely) {
  Opinions some({0.005F, 0.008F, 0.015F});
  SecondOpinions opinions(some.problem, some.checker);
  EXPECT_FALSE(opinions.empty());
  RandomStream random(1, 1);
  constexpr int kCases = 400;
  constexpr double kMarginM = 0.005;
  int agreed = 0, reached = 0;
  const PlanResult plan = make_planner("default")->plan(
      {some.arm, *some.members.front(), some.environment, kMarginM},
      [] {
        PlannerLimits limits;
        limits.iterations = 1000;
        return limits;
      }(),
      3);
  ASSERT_TRUE(plan.plan) << plan.reason;
  some.environment.goal.position_tolerance_m = 0.04;  // as cheap plans end on the rim
  for (int k = 0; k < kCases; ++k) {
    std::vector<Pressures> waypoints = plan.plan->waypoints_kpa;
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
      for (float& one : waypoints[i]) {
        one = std::clamp(one + static_cast<float>(2.0 * random.normal()), -100.0F, 100.0F);
      }
    }
    reached += ends_in_goal(some.problem, walk(some.problem, some.checker, waypoints)) ? 1 : 0;
    const bool agree = opinions.agree(waypoints);
    EXPECT_EQ(agree, some.others_agree(waypoints)) << "case " << k;
    agreed += agree ? 1 : 0;
  }
  EXPECT_GT(agreed, 10) << reached << " reached by the leading one";
  EXPECT_LT(agreed, kCases - 10) << "they differ";
  EXPECT_GT(opinions.queries(), std::uint64_t(kCases));
}

}  // namespace
}  // namespace limber
