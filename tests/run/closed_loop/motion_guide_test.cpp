#include "src/run/closed_loop/motion_guide.hpp"

#include <gmock/gmock.h>

#include "limber/planning/planner_factory.hpp"
#include "planning/play_model.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

constexpr double kMarginM = 0.02;

/// Finds what it is told to find.
class FakePlanner final : public Planner {
 public:
  const char* name() const override { return "fake"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    ++calls;
    asked_queries = limits.queries.value_or(0);
    starts.push_back(*problem.environment.start);
    PlanResult result;
    if (searches) {
      result = make_planner("default", 1)->plan(problem, limits, seed, callback);
      if (result.plan && !keeps_certificate) {
        result.plan->certified.reset();
      }
    }
    return result;
  }

  bool searches = true;
  bool keeps_certificate = true;
  int calls = 0;
  std::uint64_t asked_queries = 0;
  std::vector<ArmStart> starts;
};

/// A plan along a straight line of set points, and an arm that is somewhere on it.
class MotionGuideTest : public ::testing::Test {
 protected:
  MotionGuideTest() {
    environment_.name = "a goal to the right";
    const Pressures end_kpa = Pressures::Constant(2, 90.0F);
    MotionModel::Workspace workspace;
    MotionState end = start();
    model_.step(end_kpa, end, workspace);
    const Pose goal = tip_pose(end.backbone);
    environment_.goal = {goal.x_m, goal.y_m, std::nullopt, 0.02, 0.1};
    PlannerLimits limits;
    limits.queries = 20000;
    PlanResult result =
        make_planner("default", 1)->plan({arm_, model_, environment_, 0.0}, limits, 1);
    EXPECT_TRUE(result.plan.has_value()) << result.reason;
    plan_ = std::move(*result.plan);
    plan_.margin_m = kMarginM;
    // It promises the goal's centre.
    const Pose end_of_plan = tip_pose(plan_.frames.back().backbone);
    environment_.goal.x_m = end_of_plan.x_m;
    environment_.goal.y_m = end_of_plan.y_m;
    plan_.goal_distance_m = 0.0;
  }

  /// As much as a few kPa less at the plan's end do to the tip: more than half the tolerance.
  ModelMiss miss() const {
    MotionModel::Workspace workspace;
    MotionState less = start();
    model_.step(plan_.frames.back().setpoint_kpa - Eigen::Vector2f(8.0F, 5.0F), less, workspace);
    const Pose there = tip_pose(less.backbone);
    const Eigen::Vector3d off(environment_.goal.x_m - there.x_m, environment_.goal.y_m - there.y_m,
                              0.0);
    EXPECT_GT(off.norm(), 0.011);
    return {off, 1.0, {}};
  }

  MotionState start() const {
    const ArmStart rest = start_state(Environment{}, arm_);
    return model_.settled_state(rest.pressures_kpa, rest.backbone);
  }

  /// Where the plan has the arm after one of its frames.
  MotionState planned(std::size_t frame) const {
    const std::vector<PlanFrame> until(plan_.frames.begin(),
                                       plan_.frames.begin() + std::ptrdiff_t(frame) + 1);
    return state_after(until, model_);
  }

  /// A small circle where the plan's tip passes in a frame, beside what is there then.
  void block(std::size_t frame) {
    const Pose tip = tip_pose(plan_.frames[frame].backbone);
    environment_.obstacles = {Circle{tip.x_m, tip.y_m, 0.005}};
  }

  MotionGuide guide(PlanCheck check = {}) {
    ErrorRoom room;
    room.margin_m = kMarginM;
    if (!check) {
      check = certificate_check(arm_, model_);
    }
    return MotionGuide(arm_, model_, environment_, room, {.motion_queries = 5000}, planner_, check,
                       1);
  }

  MotionAdvice ask(MotionGuide& guide, std::size_t next, const MotionState& now,
                   const ModelMiss& miss = {}) {
    return guide.advise({plan_, next, plan_.frames[next].setpoint_kpa}, environment_.goal, now,
                        miss);
  }

  const ArmDescription arm_ = small_arm();
  const ForwardModel forward_{arm_, play_network(arm_, 0.0F)};
  const MotionModel model_{forward_};
  Environment environment_;
  Plan plan_;
  FakePlanner planner_;
};

TEST_F(MotionGuideTest, GoesOnWhereNothingStraysAndAsksNobody) {
  MotionGuide one = guide([](Plan&, const Environment&) {
    ADD_FAILURE() << "nothing to certify";
    return false;
  });
  for (std::size_t k = 0; k + 1 < plan_.frames.size(); ++k) {
    const MotionAdvice advice = ask(one, k + 1, planned(k));
    EXPECT_EQ(advice.kind, MotionAdvice::Kind::go_on);
    EXPECT_FALSE(advice.plan);
  }
  EXPECT_EQ(planner_.calls, 0);
}

TEST_F(MotionGuideTest, WhatTheModelMissesIsMadeUpForByAPlanFromTheNextFrame) {
  constexpr std::size_t kFrame = 3;
  MotionGuide one = guide();
  const Eigen::Vector3d off = miss().sum;
  const MotionAdvice advice = ask(one, kFrame + 1, planned(kFrame), miss());
  ASSERT_TRUE(advice.plan);
  EXPECT_TRUE(advice.plan->plan.certified);
  EXPECT_EQ(advice.plan->plan.frames.front().setpoint_kpa, plan_.frames[kFrame + 1].setpoint_kpa);
  EXPECT_EQ(advice.plan->plan.frames.front().backbone, planned(kFrame + 1).backbone);
  // It ends as far on the other side of the goal as the model is expected to be off there.
  const Pose end = tip_pose(advice.plan->plan.frames.back().backbone);
  constexpr double kNearM = 0.003;
  EXPECT_NEAR(end.x_m, environment_.goal.x_m - off.x(), kNearM);
  EXPECT_NEAR(end.y_m, environment_.goal.y_m - off.y(), kNearM);
}

TEST_F(MotionGuideTest, NoPlanIsTakenThatItsCertificateRefuses) {
  planner_.keeps_certificate = false;
  int asked = 0;
  MotionGuide one = guide([&](Plan&, const Environment&) {
    ++asked;
    return false;
  });
  EXPECT_FALSE(ask(one, 4, planned(3), miss()).plan);
  EXPECT_GT(asked, 0);
  block(plan_.frames.size() - 1 - std::size_t(plan_.hold_frame_count));
  MotionGuide other = guide([](Plan&, const Environment&) { return false; });
  EXPECT_FALSE(ask(other, 2, planned(1)).plan);
  EXPECT_GT(planner_.calls, 0) << "it found one, which is not certified";
}

/// A model with memory behind slow valves: a held arm still moves on.
class HeldArmTest : public MotionGuideTest {
 protected:
  HeldArmTest() {
    environment_.obstacles.clear();
    PlannerLimits limits;
    limits.queries = 20000;
    const PlanResult result =
        make_planner("default", 1)->plan({slow_, slow_model_, environment_, 0.0}, limits, 1);
    EXPECT_TRUE(result.plan.has_value()) << result.reason;
    plan_ = *result.plan;
    motion_ = plan_.frames.size() - 1 - std::size_t(plan_.hold_frame_count);
  }

  static ArmDescription slow(ArmDescription arm) {
    arm.pressure_rate_limit_kpa_per_s = 40.0;
    return arm;
  }

  /// A circle behind the end of the way, its centre so far from where the arm's body will be.
  void put_behind_the_end(double gap_m) {
    const Pose tip = tip_pose(plan_.frames[motion_ / 2].backbone);
    const Pose end = tip_pose(plan_.frames.back().backbone);
    const double way_m = std::hypot(end.x_m - tip.x_m, end.y_m - tip.y_m);
    const double behind_m = slow_.segments.back().width_m / 2.0 + slow_.actuator_radius_m + gap_m;
    environment_.obstacles = {Circle{end.x_m + behind_m * (end.x_m - tip.x_m) / way_m,
                                     end.y_m + behind_m * (end.y_m - tip.y_m) / way_m, 0.005}};
  }

  MotionGuide refusing_guide() {
    planner_.searches = false;
    ErrorRoom room;
    room.margin_m = kMarginM;
    return MotionGuide(
        slow_, slow_model_, environment_, room, {.motion_queries = 5000}, planner_,
        [](Plan&, const Environment&) { return false; }, 1);
  }

  MotionState slow_planned(std::size_t frame) const {
    return state_after({plan_.frames.begin(), plan_.frames.begin() + std::ptrdiff_t(frame) + 1},
                       slow_model_);
  }

  /// Of an arm that gets the set points of a frame for a second more.
  std::vector<double> clearances_held(std::size_t frame) const {
    const CollisionChecker checker(slow_, environment_.obstacles);
    MotionState state = slow_planned(frame);
    MotionModel::Workspace workspace;
    std::vector<double> clearances_m;
    for (int k = 0; k < slow_.frames_in(1.0); ++k) {
      const Backbone before = state.backbone;
      slow_model_.step(plan_.frames[frame].setpoint_kpa, state, workspace);
      clearances_m.push_back(checker.motion_clearance(before, state.backbone, 1.0).value_m);
    }
    return clearances_m;
  }

  const ArmDescription slow_ = slow(arm_);
  const ForwardModel slow_forward_{slow_, play_network(slow_, 0.0005F)};
  const MotionModel slow_model_{
      slow_forward_, ValveModel(slow_, {true, std::vector<SegmentValves>(
                                                  2, {{0.1, 100.0}, {0.1, 100.0}, 0.1, 0.2})})};
  std::size_t motion_ = 0;  // frames of it
};

TEST_F(HeldArmTest, IsHaltedWhereTheWayIsFreeForLessThanASecond) {
  const Pose end = tip_pose(plan_.frames.back().backbone);
  environment_.obstacles = {Circle{end.x_m, end.y_m, 0.005}};
  const CollisionChecker checker(slow_, environment_.obstacles);
  std::size_t struck = 0;  // its first frame
  while (checker.clearance(plan_.frames[struck].backbone).value_m > 0.0) {
    ++struck;
  }
  MotionGuide one = refusing_guide();
  std::size_t next = 1;
  MotionAdvice advice;
  while (advice.kind != MotionAdvice::Kind::stop && next < motion_) {
    advice = ask(one, next, slow_planned(next - 1));
    ++next;
  }
  ASSERT_EQ(advice.kind, MotionAdvice::Kind::stop);
  EXPECT_THAT(advice.reason, HasSubstr("obstacle 0 (circle) is in the way"));
  EXPECT_EQ(planner_.asked_queries, 5000U);
  const std::size_t last = next - 1;  // whose set points are held
  ASSERT_GT(last, 2U) << "far away it goes on";
  constexpr std::size_t kFramesOfMargin = 4;  // a margin is kept, which the plan comes into earlier
  EXPECT_NEAR(double(struck - last), slow_.frames_in(1.0), kFramesOfMargin);
  const std::vector<double> held_m = clearances_held(last);
  EXPECT_LT(held_m.back(), held_m.front() - 0.001) << "it comes nearer while it is held";
  EXPECT_GT(*std::min_element(held_m.begin(), held_m.end()), kMarginM);
}

TEST_F(HeldArmTest, KeepsAsFarAwayAsTheForecastsWereOff) {
  put_behind_the_end(0.02);
  const MotionState now = slow_planned(motion_ / 2 - 1);
  MotionGuide guide = refusing_guide();
  EXPECT_EQ(ask(guide, motion_ / 2, now).kind, MotionAdvice::Kind::go_on);
  EXPECT_EQ(planner_.calls, 0);
  ModelMiss off;
  off.plate_m = Eigen::VectorXd::Constant(slow_.point_count(), 0.03);
  ask(guide, motion_ / 2, now, off);
  EXPECT_EQ(planner_.calls, 0) << "noise makes single forecasts that strike far ahead";
  ask(guide, motion_ / 2, now, off);
  EXPECT_EQ(planner_.calls, 1) << "the rest of the plan is not free any more";
}

TEST_F(HeldArmTest, KeepsAsMuchOfTheRoomAsItIsTold) {
  put_behind_the_end(0.02);  // farther than a quarter of the margin, nearer than all of it
  const MotionState now = slow_planned(motion_ / 2 - 1);
  for (const auto& [share, searches] :
       {std::pair(MotionGuide::kShareInMotion, 0), std::pair(1.0, 1)}) {
    MotionGuide guide = refusing_guide();
    guide.keep(share);
    planner_.calls = 0;
    ask(guide, motion_ / 2, now);
    ask(guide, motion_ / 2, now);
    EXPECT_EQ(planner_.calls, searches) << share;
  }
}

TEST_F(MotionGuideTest, FindsAWayAroundWhatIsInTheWay) {
  const std::size_t end = plan_.frames.size() - 1 - std::size_t(plan_.hold_frame_count);
  block(end / 2);
  const Pose tip = tip_pose(plan_.frames[end / 2].backbone);
  environment_.obstacles = {Circle{tip.x_m + 0.01, tip.y_m, 0.004}};
  MotionGuide one = guide();
  const MotionAdvice advice = ask(one, 1, planned(0));
  if (advice.plan) {  // certified for the environment with the obstacle
    EXPECT_TRUE(advice.plan->plan.certified);
    EXPECT_GT(advice.plan->plan.clearance_m, 0.0);
  } else {
    EXPECT_NE(advice.kind, MotionAdvice::Kind::go_on);
  }
}

}  // namespace
}  // namespace limber
