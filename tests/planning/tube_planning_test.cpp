#include <algorithm>
#include <functional>
#include <limits>

#include <gmock/gmock.h>

#include "limber/certificate/certificate.hpp"
#include "limber/common/error.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/world/plan.hpp"
#include "planning/planner_setting.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

/// 12 mm at the tip at level 0.95, 6 mm at 0.9.
CompensationModel model_with_tube(const ArmDescription& arm) {
  CompensationModel model = play_network(arm, kPlayM);
  Tube tube;
  for (int i = 0; i < arm.point_count(); ++i) {
    tube.plate_scale_m.push_back(std::max(1e-4, 0.006 * i / (arm.point_count() - 1)));
  }
  tube.end_scale_m = 0.004;
  tube.end_heading_scale_rad = 0.02;
  tube.growth = {0.4, 0.1};
  tube.source = "a test";
  tube.levels = {{0.9, 1.0, 100, 3, 0.95, 0, 0}, {0.95, 2.0, 100, 0, 0.95, 0, 0}};
  model.tube = tube;
  return model;
}

struct TubeSetting {
  ArmDescription arm = three_segment_arm();
  ForwardModel model{arm, model_with_tube(arm)};
  Environment environment = pillars();

  PlanResult plan(const AskedRoom& asked = {}) const {
    PlannerLimits limits;
    limits.iterations = 8000;
    return make_planner("default")->plan(
        problem_with_room(arm, model, environment, error_room(model, asked)), limits, 3);
  }
  Certificate certificate(const Plan& p) const {
    return certify(p, arm, &model.compensation(), {}, environment);
  }
};

const TubeSetting& setting() {
  static const TubeSetting s;
  return s;
}

std::vector<std::string> failed_checks(const Certificate& certificate) {
  std::vector<std::string> checks;
  for (const CertificateFailure& failure : certificate.failures) {
    checks.push_back(failure.check);
  }
  return checks;
}

TEST(TubeRoom, IsThatOfTheLevelAskedForOrOfNinetyFivePercent) {
  const TubeSetting& s = setting();
  const ErrorRoom standard = error_room(s.model);
  ASSERT_TRUE(standard.tube);
  EXPECT_EQ(standard.tube->level, 0.95);
  EXPECT_DOUBLE_EQ(standard.tube->plate_radius_m.back(), 0.012);
  EXPECT_DOUBLE_EQ(standard.margin_m, 0.012);
  EXPECT_DOUBLE_EQ(standard.goal_margin.position_m, 0.008);
  EXPECT_DOUBLE_EQ(standard.goal_margin.orientation_rad, 0.04);
  AskedRoom asked;
  asked.tube_level = 0.9;
  EXPECT_DOUBLE_EQ(error_room(s.model, asked).tube->plate_radius_m.back(), 0.006);
  asked = {};
  asked.margin_m = 0.003;
  EXPECT_FALSE(error_room(s.model, asked).tube);
  EXPECT_EQ(error_room(s.model, asked).margin_m, 0.003);
}

TEST(TubeRoom, OfALevelThatIsNotThereNamesThoseThatAre) {
  AskedRoom asked;
  asked.tube_level = 0.99;
  EXPECT_THAT([&] { (void)error_room(setting().model, asked); },
              ThrowsMessage<InputError>(HasSubstr("a tube of 0.99 is asked for (--tube); "
                                                  "the model carries 0.9, 0.95")));
  EXPECT_THAT([&] { (void)error_room(ForwardModel(three_segment_arm()), asked); },
              ThrowsMessage<InputError>(HasSubstr("the model carries none: limber calibrate")));
}

TEST(TubePlanning, PlansKeepTheInflatedArmFreeAndTheGoalInside) {
  const TubeSetting& s = setting();
  const PlanResult result = s.plan();
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  const Plan& plan = *result.plan;
  ASSERT_TRUE(plan.tube);
  EXPECT_TRUE(plan.tube->goal_inside);
  EXPECT_EQ(plan.margin_m, 0.0);
  EXPECT_LE(plan.goal_distance_m, s.environment.goal.position_tolerance_m - 0.008);
  const CollisionChecker inflated(
      s.arm, s.environment.obstacles, 0.0,
      {plan.tube->plate_radius_m, plan.tube->growth, plan.frames.front().backbone});
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    const Backbone& from = plan.frames[k - 1].backbone;
    EXPECT_TRUE(inflated.is_motion_free(from, plan.frames[k].backbone)) << k;
    smallest = std::min(smallest, inflated.motion_clearance(from, plan.frames[k].backbone).value_m);
  }
  EXPECT_NEAR(plan.clearance_m, smallest, CollisionChecker::kToleranceM);
  EXPECT_THAT(failed_checks(s.certificate(plan)), IsEmpty());
}

TEST(TubePlanning, TheCertificateRefusesATubeThatTouchesOrIsNotTheModels) {
  const TubeSetting& s = setting();
  AskedRoom bare;
  bare.margin_m = 0.0;
  bare.goal_margin_m = 0.0;
  const PlanResult result = s.plan(bare);  // the cheapest way goes close by
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  Plan plan = *result.plan;
  ASSERT_LT(plan.clearance_m, 0.004) << "nothing would touch";
  plan.tube = error_room(s.model).tube;
  EXPECT_THAT(failed_checks(s.certificate(plan)), Contains("collision"));
  const Plan kept = *s.plan().plan;
  const struct {
    const char* check;
    std::function<void(PlanTube&)> change;
  } cases[] = {
      {"tube", [](PlanTube& t) { t.plate_radius_m[9] *= 0.99; }},
      {"tube", [](PlanTube& t) { t.plate_radius_m.pop_back(); }},
      {"tube", [](PlanTube& t) { t.plate_radius_m[2] = -0.1; }},
      {"tube", [](PlanTube& t) { t.end_radius_m = 0.0; }},
      {"tube", [](PlanTube& t) { t.end_heading_rad = 0.0; }},
      {"tube", [](PlanTube& t) { t.level = 0.97; }},
      {"tube", [](PlanTube& t) { t.growth.start_share = 0.39; }},
      {"tube", [](PlanTube& t) { t.growth.start_share = 1.1; }},
      {"tube", [](PlanTube& t) { t.growth.full_after_m = 0.11; }},
      {"tube", [](PlanTube& t) { t.growth.full_after_m = -0.1; }},
      {"collision", [](PlanTube& t) { t.plate_radius_m.assign(16, 0.2); }},
      {"goal", [](PlanTube& t) { t.end_radius_m = 0.0199; }},
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    Plan changed = kept;
    cases[i].change(*changed.tube);
    EXPECT_THAT(failed_checks(s.certificate(changed)), Contains(cases[i].check)) << "case " << i;
  }
}

TEST(TubePlanning, AStartInsideTheTubeIsRefusedWhereItIsAskedForAndYieldsWhereNot) {
  TubeSetting s;
  // 4 mm beside the tip of the straight arm, less than its tube has there.
  const Backbone start = start_state(s.environment, s.arm).backbone;
  const CollisionChecker bare(s.arm, {});
  s.environment.obstacles = {Circle{double(start(15, 0)), -0.004 - 0.01 - bare.radius_m(14), 0.01}};
  AskedRoom asked;
  asked.tube_level = 0.95;
  EXPECT_EQ(s.plan(asked).status, PlanStatus::invalid_start);
  const PlanResult yielded = s.plan();
  ASSERT_EQ(yielded.status, PlanStatus::solved) << yielded.reason;
  EXPECT_FALSE(yielded.plan->tube);
  EXPECT_THAT(yielded.warnings, Contains(HasSubstr("nothing is promised")));
}

TEST(TubePlanning, PlanFilesKeepTheTube) {
  const TemporaryFolder folder;
  const Plan plan = *setting().plan().plan;
  write_plan(folder.path() / "p.json", plan);
  const Plan back = read_plan(folder.path() / "p.json");
  EXPECT_EQ(back.tube, plan.tube);
  EXPECT_TRUE(back.certified->seal_is_intact);
}

}  // namespace
}  // namespace limber
