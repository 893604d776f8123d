#include "limber/forward/recorded_region.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Of recordings with these pressures and rates; any shape is known.
LearntRegion recorded(const Pressures& low_kpa, const Pressures& high_kpa, float rate_kpa_per_s) {
  const ArmDescription arm = three_segment_arm();
  const Eigen::Index joint = 3 + 3 * (arm.point_count() - 1);
  LearntRegion region;
  region.low_kpa = low_kpa;
  region.high_kpa = high_kpa;
  region.steepest_fall_kpa_per_s = Pressures::Constant(3, rate_kpa_per_s);
  region.steepest_rise_kpa_per_s = Pressures::Constant(3, rate_kpa_per_s);
  region.joint_offset = Eigen::VectorXf::Zero(joint);
  region.joint_scale = Eigen::VectorXf::Ones(joint);
  region.axes = Eigen::MatrixXf::Zero(1, joint);
  region.axes(0, joint - 1) = 1.0F;
  region.axis_low = Eigen::VectorXf::Constant(1, -100.0F);
  region.axis_high = Eigen::VectorXf::Constant(1, 100.0F);
  return region;
}

constexpr float kFast = 1e6F;

TEST(RecordedRegion, SaysInNumbersWhereAPlanLeavesIt) {
  Setting s(false);
  const PlanResult result = s.plan("default", 1500);
  ASSERT_TRUE(result.plan);
  float lowest = 0.0F;
  for (const PlanFrame& frame : result.plan->frames) {
    lowest = std::min(lowest, frame.setpoint_kpa[1]);
  }
  const Pressures wide = Pressures::Constant(3, 500.0F);
  EXPECT_THAT(excursions_beyond(recorded(-wide, wide, kFast), *result.plan, Command{}), IsEmpty());

  Pressures low = -wide;
  low[1] = lowest + 5.0F;
  const std::vector<std::string> below =
      excursions_beyond(recorded(low, wide, kFast), *result.plan, Command{});
  ASSERT_FALSE(below.empty());
  EXPECT_EQ(below.front(), fmt::format("segment 1 down to {:.4g} kPa; recorded {:.4g} … 500",
                                       lowest, lowest + 5.0F));

  const std::vector<std::string> fast =
      excursions_beyond(recorded(-wide, wide, 1.0F), *result.plan, Command{});
  ASSERT_FALSE(fast.empty());
  EXPECT_THAT(fast.front(), HasSubstr("kPa per second; recorded up to 1"));
  float fastest = 0.0F;
  for (std::size_t k = 1; k < result.plan->frames.size(); ++k) {
    const PlanFrame& before = result.plan->frames[k - 1];
    fastest = std::max(
        fastest, (result.plan->frames[k].pressure_kpa - before.pressure_kpa).cwiseAbs().maxCoeff() *
                     float(result.plan->frame_rate_hz));
  }
  EXPECT_THAT(fast,
              ::testing::Contains(HasSubstr(fmt::format("by {:.4g} kPa per second", fastest))));
}

TEST(RecordedRegion, PlansAskedToStayInsideDo) {
  Setting s(false);
  PlannerLimits limits;
  limits.iterations = 3000;
  const PlanResult free = make_planner("default")->plan({s.arm, s.model, s.environment}, limits, 3);
  ASSERT_TRUE(free.plan);
  Pressures low = free.plan->waypoints_kpa.front();
  Pressures high = low;
  for (const Pressures& waypoint : free.plan->waypoints_kpa) {
    low = low.cwiseMin(waypoint);
    high = high.cwiseMax(waypoint);
  }
  // A narrower box, in which the goal can still be reached.
  const LearntRegion region = recorded(low.array() - 15.0F, high.array() * 0.98F, kFast);
  const RecordedRegion inside(region, s.arm.frame_rate_hz);
  ASSERT_FALSE(excursions_beyond(region, *free.plan, Command{}).empty());
  for (const char* planner : {"default", "paper"}) {
    const PlanResult result = make_planner(planner)->plan(
        {s.arm, s.model, s.environment, 0.0, {}, std::nullopt, &inside}, limits, 3);
    if (result.plan) {
      EXPECT_THAT(excursions_beyond(region, *result.plan, Command{}), IsEmpty()) << planner;
    } else {
      EXPECT_STREQ(planner, "paper") << result.reason;
      EXPECT_THAT(result.reason, HasSubstr("leaves what the model's recordings held"));
    }
  }
}

TEST(RecordedRegion, JudgesEveryFrameByPressureRateAndShape) {
  const ArmDescription arm = three_segment_arm();
  const Pressures limit = Pressures::Constant(3, 40.0F);
  LearntRegion learnt = recorded(-limit, limit, 100.0F);
  const RecordedRegion region(learnt, arm.frame_rate_hz);
  RecordedRegion::Workspace workspace = region.make_workspace();
  const Backbone rest = start_state(Environment(), arm).backbone;
  const auto holds = [&](float before, float now) {
    return region.holds(Pressures::Constant(3, before), Pressures::Constant(3, now), rest, rest,
                        workspace);
  };
  EXPECT_TRUE(holds(0.0F, 4.9F));
  EXPECT_FALSE(holds(0.0F, 5.2F)) << "104 kPa a second";
  EXPECT_FALSE(holds(0.0F, -5.2F));
  EXPECT_FALSE(holds(40.0F, 41.0F)) << "beyond the recorded pressures";
  learnt.axis_low[0] = -2e-3F;
  learnt.axis_high[0] = -1e-3F;  // the last plate was always turned
  const RecordedRegion turned(learnt, arm.frame_rate_hz);
  EXPECT_FALSE(turned.holds(Pressures::Zero(3), Pressures::Zero(3), rest, rest, workspace));
}

TEST(RecordedRegion, SaysAtWhichRateEverySegmentMayMove) {
  const ArmDescription arm = three_segment_arm();
  const Pressures limit = Pressures::Constant(3, 40.0F);
  LearntRegion learnt = recorded(-limit, limit, 100.0F);
  learnt.steepest_rise_kpa_per_s = Pressures{{30.0F, 60.0F, 0.0F}};  // the last one never rose
  const RecordedRegion region(learnt, arm.frame_rate_hz);
  const double rate_kpa_per_s = region.rate_limit_kpa_per_s();
  EXPECT_NEAR(rate_kpa_per_s, 30.0, 0.3);
  const Backbone rest = start_state(Environment(), arm).backbone;
  RecordedRegion::Workspace workspace = region.make_workspace();
  Pressures next = Pressures::Constant(3, float(rate_kpa_per_s / arm.frame_rate_hz));
  next[2] = 0.0F;
  EXPECT_TRUE(region.holds(Pressures::Zero(3), next, rest, rest, workspace));
  EXPECT_FALSE(region.holds(Pressures::Zero(3), 1.1F * next, rest, rest, workspace));
}

TEST(RecordedRegion, JudgesHowFastTheArmMoves) {
  const ArmDescription arm = three_segment_arm();
  const Pressures limit = Pressures::Constant(3, 40.0F);
  LearntRegion learnt = recorded(-limit, limit, 100.0F);
  learnt.joint_change = Eigen::VectorXf::Constant(learnt.joint_offset.size(), 0.01F);
  learnt.joint_change.head(3).setConstant(10.0F);
  const RecordedRegion region(learnt, arm.frame_rate_hz);
  RecordedRegion::Workspace workspace = region.make_workspace();
  const Backbone rest = start_state(Environment(), arm).backbone;
  const auto holds = [&](float turn_rad) {
    Backbone now = rest;
    now(arm.point_count() - 1, 2) += turn_rad;
    return region.holds(Pressures::Zero(3), Pressures::Zero(3), rest, now, workspace);
  };
  EXPECT_TRUE(holds(0.009F));
  EXPECT_FALSE(holds(0.011F));
}

TEST(PressureBox, LimitsAndDrawsInside) {
  const PressureBox box{Pressures::Constant(2, -3.0F), Pressures::Constant(2, 7.0F)};
  EXPECT_EQ(box.limited(Pressures::Constant(2, 9.0F))[0], 7.0F);
  EXPECT_EQ(box.limited(Pressures::Constant(2, -9.0F))[1], -3.0F);
  RandomStream random(1, 0);
  float lowest = 100.0F;
  float highest = -100.0F;
  for (int k = 0; k < 1000; ++k) {
    const Pressures drawn = box.sample(random);
    lowest = std::min(lowest, drawn.minCoeff());
    highest = std::max(highest, drawn.maxCoeff());
  }
  EXPECT_GE(lowest, -3.0F);
  EXPECT_LE(highest, 7.0F);
  EXPECT_LT(lowest, -2.9F);
  EXPECT_GT(highest, 6.9F);
  const PressureBox both =
      box.within({Pressures::Constant(2, 0.0F), Pressures::Constant(2, 90.0F)});
  EXPECT_EQ(both.low_kpa[0], 0.0F);
  EXPECT_EQ(both.high_kpa[1], 7.0F);
}

}  // namespace
}  // namespace limber
