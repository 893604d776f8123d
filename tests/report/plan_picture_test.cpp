#include "limber/report/plan_picture.hpp"
#include "limber/planning/planner_factory.hpp"

#include <gmock/gmock.h>

#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Environment one_of_each() {
  Environment e;
  e.name = "a & b";
  e.obstacles = {Circle{0.2, 0.3, 0.02}, Rectangle{0.4, 0.3, 0.05, 0.02, 0.3},
                 Polygon{{{0.5, -0.3}, {0.6, -0.3}, {0.55, -0.25}}}};
  e.goal = {0.6, -0.2, 0.5, 0.02, 0.3};
  return e;
}

TEST(PlanPicture, ShowsThePlanWithItsModelAndCost) {
  const ArmDescription arm = three_segment_arm();
  const Environment e = one_of_each();
  const ForwardModel model(arm);
  PlannerLimits limits;
  limits.iterations = 3000;
  limits.cost_threshold_kpa = 1e6;
  const PlanResult result = make_planner("paper")->plan({arm, model, e}, limits, 1);
  ASSERT_TRUE(result.plan);
  const std::string svg = plan_picture(arm, e, result);
  EXPECT_THAT(svg, AllOf(HasSubstr("a &amp; b, no-load model: "), HasSubstr("path of its tip"),
                         HasSubstr("tips of the search tree"), HasSubstr(" psi, "),
                         Not(HasSubstr("no plan"))));
}

TEST(PlanPicture, CostsAreInTheUnitOfAnArmThatKnowsNoPressure) {
  const ArmDescription arm = three_segment_arm();
  PlanResult result;
  result.plan.emplace();
  result.plan->model = "no_load";
  result.plan->command = {"tendon", "mm"};
  result.plan->cost_kpa = 12.345;
  result.plan->frames.assign(
      2, {Pressures::Zero(3), Pressures::Zero(3), start_state(one_of_each(), arm).backbone});
  EXPECT_THAT(plan_picture(arm, one_of_each(), result), HasSubstr("no-load model: 12.35 mm, "));
  EXPECT_THAT(plan_animation(arm, one_of_each(), *result.plan), HasSubstr("model, 12.35 mm"));
}

TEST(PlanPicture, NeverShowsANearMissAsAPlan) {
  const ArmDescription arm = three_segment_arm();
  const Environment e = one_of_each();
  const ForwardModel model(arm);
  PlannerLimits limits;
  limits.iterations = 1;
  const PlanResult result = make_planner("paper")->plan({arm, model, e}, limits, 1);
  ASSERT_FALSE(result.plan);
  EXPECT_THAT(plan_picture(arm, e, result),
              AllOf(HasSubstr("no plan; the nearest motion found"), HasSubstr(": limit"),
                    Not(HasSubstr("the plan's last shape"))));
}

TEST(PressurePicture, HasALineForEachSetPointAndPrediction) {
  const ArmDescription arm = three_segment_arm();
  Plan plan;
  const Backbone shape(arm.point_count(), 3);
  for (int k = 0; k < 4; ++k) {
    plan.frames.push_back(
        {Pressures::Constant(3, 5.0F * float(k)), Pressures::Constant(3, 4.0F * float(k)), shape});
  }
  const std::string predicted = pressure_picture(arm, plan);
  EXPECT_THAT(predicted, AllOf(HasSubstr("segment 0: set point"), HasSubstr("segment 2: predicted"),
                               HasSubstr("pressure [kPa]")));
}

TEST(PlanPicture, BoxHoldsTheGoalAndTheObstaclesInReach) {
  const ArmDescription arm = three_segment_arm();
  Environment e = one_of_each();
  e.goal.x_m = -0.5;
  e.obstacles.push_back(Circle{50.0, 0.0, 1.0});
  const WorldBox box = picture_box(arm, e);
  EXPECT_LT(box.x_min_m, -0.5);
  EXPECT_LT(box.x_max_m, 1.5) << "what is far away is cut off";
}

}  // namespace
}  // namespace limber
