#include "src/planning/certified/certifying_judge.hpp"

#include <gmock/gmock.h>

#include "limber/planning/plan_builder.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using Verdict = PlanJudge::Verdict;

const auto kNever = [] { return false; };

class Judge : public ::testing::Test {
 protected:
  void SetUp() override {
    const PlanResult found = setting_.plan("default", 1500);
    ASSERT_TRUE(found.plan);
    sound_kpa_ = found.plan->waypoints_kpa;
  }
  Plan build(const std::vector<Pressures>& waypoints_kpa) {
    return build_plan(problem_, simulator_, waypoints_kpa, "test", 7);
  }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  CollisionChecker checker_{setting_.arm, setting_.environment.obstacles};
  MotionSimulator simulator_{setting_.arm, setting_.model, checker_};
  AskedProblem asked_{problem_};
  CertifyingJudge judge_{problem_, asked_};
  std::vector<Pressures> sound_kpa_;
};

TEST_F(Judge, LetsASoundPlanStandAndWritesWhatItFoundIntoIt) {
  Plan plan = build(sound_kpa_);
  ASSERT_EQ(judge_.judge(plan, kNever), Verdict::holds);
  ASSERT_TRUE(plan.certified);
  EXPECT_GT(plan.certified->clearance_m, 0.0);
  EXPECT_EQ(plan.environment_hash, environment_hash(setting_.environment));
  PlanResult result;
  result.status = PlanStatus::solved;
  result.plan = plan;
  judge_.report(result);
  ASSERT_TRUE(result.certificate);
  EXPECT_TRUE(result.certificate->certified());
}

TEST_F(Judge, RefusesAPlanThatEndsElsewhereAndSaysWhy) {
  Plan plan = build({sound_kpa_.front(), sound_kpa_.front()});
  EXPECT_EQ(judge_.judge(plan, kNever), Verdict::refused);
  EXPECT_FALSE(plan.certified);
  PlanResult result;
  result.status = PlanStatus::not_certified;
  result.best_partial = plan;
  judge_.report(result);
  ASSERT_TRUE(result.certificate);
  EXPECT_FALSE(result.certificate->certified());
  EXPECT_THAT(result.reason, HasSubstr("every plan that planner 'test' found is refused by its "
                                       "certificate, the cheapest for this: goal"));
}

TEST_F(Judge, NamesAFrameOnlyWhereOneIsToBlame) {
  Plan plan = build(sound_kpa_);
  plan.clearance_m += 0.01;
  EXPECT_EQ(judge_.judge(plan, kNever), Verdict::refused);
  PlanResult result;
  result.status = PlanStatus::not_certified;
  result.best_partial = plan;
  judge_.report(result);
  EXPECT_THAT(result.reason, HasSubstr("for this: claims: clearance_m = "));
}

TEST_F(Judge, PassesOnPlansThatHoldWithTheirFiguresAndNoOthers) {
  std::vector<Plan> passed_on;
  problem_.on_plan = [&](const Plan& plan) { passed_on.push_back(plan); };
  Plan elsewhere = build({sound_kpa_.front(), sound_kpa_.front()});
  EXPECT_EQ(judge_.judge(elsewhere, kNever), Verdict::refused);
  EXPECT_TRUE(passed_on.empty());
  Plan plan = build(sound_kpa_);
  ASSERT_EQ(judge_.judge(plan, kNever), Verdict::holds);
  ASSERT_EQ(passed_on.size(), 1U);
  EXPECT_TRUE(passed_on.front().certified);
  EXPECT_EQ(passed_on.front().waypoints_kpa, plan.waypoints_kpa);
}

TEST_F(Judge, WithoutTimeItIsNotFinished) {
  Plan plan = build(sound_kpa_);
  EXPECT_EQ(judge_.judge(plan, [] { return true; }), Verdict::unfinished);
  EXPECT_FALSE(plan.certified);
}

// A planner that asked nobody, or changed its plan since, gets no certificate on trust.
TEST_F(Judge, APlanThatNobodyAskedAboutIsJudgedAtTheEnd) {
  PlanResult good;
  good.status = PlanStatus::solved;
  good.plan = build(sound_kpa_);
  judge_.report(good);
  EXPECT_EQ(good.status, PlanStatus::solved);
  EXPECT_TRUE(good.certificate->certified());

  PlanResult changed;
  changed.status = PlanStatus::solved;
  changed.plan = good.plan;
  changed.plan->frames.back().backbone(15, 0) += 0.05F;
  changed.first_solution = FirstSolution{};
  judge_.report(changed);
  EXPECT_EQ(changed.status, PlanStatus::not_certified);
  EXPECT_FALSE(changed.plan);
  EXPECT_TRUE(changed.best_partial);
  EXPECT_FALSE(changed.first_solution);
}

}  // namespace
}  // namespace limber
