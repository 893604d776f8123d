// Planning through valves: every planner's plans say what pressures their set points become.
#include <gmock/gmock.h>

#include "limber/certificate/certificate.hpp"
#include "limber/common/error.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

ValveParameters lagging(double inflate_s, double vent_s, double dead_time_s) {
  return {true,
          std::vector<SegmentValves>(3, {{inflate_s, 100.0}, {vent_s, 100.0}, dead_time_s, 0.2})};
}

struct LaggingSetting : Setting {
  ValveParameters parameters;
  MotionModel motion;

  explicit LaggingSetting(ValveParameters valves = lagging(0.1, 0.12, 0.02))
      : Setting(true), parameters(std::move(valves)), motion(model, ValveModel(arm, parameters)) {}

  PlanResult plan(const std::string& planner, std::uint64_t iterations, int jobs = 1) const {
    PlannerLimits limits;
    limits.iterations = iterations;
    return make_planner(planner, jobs)->plan({arm, motion, environment}, limits, 3);
  }
};

/// A plan's pressures and shapes are those of the motion model along its set points.
void expect_predicted(const LaggingSetting& s, const Plan& plan) {
  MotionModel::Workspace workspace;
  const ArmStart start = start_state(s.environment, s.arm);
  MotionState state = s.motion.settled_state(start.pressures_kpa, start.backbone);
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    s.motion.step(plan.frames[k].setpoint_kpa, state, workspace);
    ASSERT_EQ(Pressures(state.pressure_kpa()), plan.frames[k].pressure_kpa) << "frame " << k;
    ASSERT_EQ(state.backbone, plan.frames[k].backbone) << "frame " << k;
  }
  const Pose tip = tip_pose(state.backbone);
  EXPECT_LE(std::hypot(tip.x_m - s.environment.goal.x_m, tip.y_m - s.environment.goal.y_m),
            s.environment.goal.position_tolerance_m);
}

TEST(ValvePlanning, PlansOfEveryPlannerAreSetPointsRunThroughTheValves) {
  const LaggingSetting s;
  for (const char* planner : {"default", "paper,valves=1"}) {
    const PlanResult result = s.plan(planner, 2500);
    ASSERT_EQ(result.status, PlanStatus::solved) << planner << ": " << result.reason;
    EXPECT_EQ(result.plan->valves_hash, s.parameters.hash());
    EXPECT_EQ(result.plan->cost_kpa, path_cost_kpa(result.plan->frames, &PlanFrame::setpoint_kpa));
    expect_predicted(s, *result.plan);
    EXPECT_TRUE(certify(*result.plan, s.arm, &s.model.compensation(), s.parameters, s.environment)
                    .certified());
  }
}

// The point of it all: on an arm whose valves lag, a plan that knows them ends in its goal and
// keeps clear; one that does not is elsewhere while it moves.
TEST(ValvePlanning, APlanWithoutValvesIsElsewhereOnAnArmThatHasThem) {
  const LaggingSetting s;
  PlannerLimits limits;
  limits.iterations = 2000;
  const PlanResult blind =
      make_planner("default")->plan({s.arm, s.model, s.environment}, limits, 3);
  ASSERT_TRUE(blind.plan);
  MotionModel::Workspace workspace;
  const ArmStart start = start_state(s.environment, s.arm);
  MotionState arm = s.motion.settled_state(start.pressures_kpa, start.backbone);
  double farthest_m = 0.0;
  for (std::size_t k = 1; k < blind.plan->frames.size(); ++k) {
    s.motion.step(blind.plan->frames[k].setpoint_kpa, arm, workspace);
    const Pose there = tip_pose(arm.backbone);
    const Pose thought = tip_pose(blind.plan->frames[k].backbone);
    farthest_m = std::max(farthest_m, std::hypot(there.x_m - thought.x_m, there.y_m - thought.y_m));
  }
  EXPECT_GT(farthest_m, 0.03);
}

TEST(ValvePlanning, PaperModeLeavesValvesOutUnlessAskedTo) {
  const LaggingSetting s;
  const PlanResult result = s.plan("paper", 2500);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.plan->valves_hash, "");
  for (const PlanFrame& frame : result.plan->frames) {
    ASSERT_EQ(frame.pressure_kpa, frame.setpoint_kpa);
  }
  EXPECT_THAT([] { (void)make_planner("paper,speed=2"); },
              ThrowsMessage<InputError>(HasSubstr("planner setting speed: unknown")));
}

TEST(ValvePlanning, SlowValvesAreHeldUntilTheirPressuresHaveArrived) {
  const LaggingSetting s(lagging(0.3, 0.5, 0.13));
  const PlanResult result = s.plan("default", 8000);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  const Plan& plan = *result.plan;
  EXPECT_GT(plan.hold_frame_count, s.arm.frames_in(kHoldS));
  const auto& end = plan.frames.back();
  constexpr float kOnePercentKpa = 1.0F;
  EXPECT_LE((end.pressure_kpa - end.setpoint_kpa).lpNorm<Eigen::Infinity>(), kOnePercentKpa);
  const auto& before = plan.frames[plan.frames.size() - 2];
  EXPECT_GT((before.pressure_kpa - before.setpoint_kpa).lpNorm<Eigen::Infinity>(), kOnePercentKpa)
      << "no longer than that";
  Plan cut = plan;
  cut.frames.pop_back();
  --cut.hold_frame_count;
  const Certificate certificate =
      certify(cut, s.arm, &s.model.compensation(), s.parameters, s.environment);
  ASSERT_FALSE(certificate.certified());
  EXPECT_EQ(certificate.failures.front().check, "hold");
}

TEST(ValvePlanning, DoesNotDependOnTheNumberOfThreads) {
  const LaggingSetting s(lagging(0.1, 0.12, 0.08));
  const PlanResult one = s.plan("default", 1500, 1);
  const PlanResult two = s.plan("default", 1500, 2);
  EXPECT_TRUE(same_tree(one, two));
  ASSERT_TRUE(one.plan && two.plan);
  EXPECT_EQ(one.plan->waypoints_kpa, two.plan->waypoints_kpa);
}

TEST(ValvePlanning, TheJudgesValvesCountNotThePlans) {
  const LaggingSetting s;
  const PlanResult result = s.plan("default", 1500);
  ASSERT_TRUE(result.plan);
  const ValveParameters slower = lagging(0.2, 0.12, 0.02);
  EXPECT_THAT(
      [&] { (void)certify(*result.plan, s.arm, &s.model.compensation(), slower, s.environment); },
      ThrowsMessage<InputError>(
          HasSubstr("made for another valve model (hash " + s.parameters.hash())));
  Plan claimed = *result.plan;
  claimed.valves_hash = slower.hash();  // says that it was made for them, and was not
  const Certificate certificate =
      certify(claimed, s.arm, &s.model.compensation(), slower, s.environment);
  ASSERT_FALSE(certificate.certified());
  EXPECT_EQ(certificate.failures.front().check, "valves");
}

TEST(ValvePlanning, AForestIsOneOfItsValves) {
  const LaggingSetting s;
  const ArmStart start = start_state(s.environment, s.arm);
  ForestSettings settings;
  settings.nodes = 2000;
  const Forest forest = *grow_forest(
      s.arm, s.motion, forest_key(s.arm, "model", s.parameters, start), start, settings);
  PlannerLimits limits;
  limits.iterations = 1500;
  const PlanResult result =
      make_planner("default", 1, &forest)->plan({s.arm, s.motion, s.environment}, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  expect_predicted(s, *result.plan);
  EXPECT_THAT(
      [&] {
        (void)make_planner("default", 1, &forest)->plan({s.arm, s.model, s.environment}, limits, 3);
      },
      ThrowsMessage<InputError>(HasSubstr("grown for other valves")));
}

TEST(ValvePlanning, TheStateAtAPlansFrameIsTheStateThatLedThere) {
  const LaggingSetting s(lagging(0.1, 0.12, 0.13));
  const CollisionChecker nothing(s.arm, {});
  MotionSimulator simulator(s.arm, s.motion, nothing);
  const ArmStart start = start_state(s.environment, s.arm);
  MotionState state = simulator.start(start);
  std::vector<PlanFrame> frames{{start.pressures_kpa, start.pressures_kpa, start.backbone}};
  RandomStream random(8, 0);
  for (int k = 0; k < 4; ++k) {
    const Pressures to = random_pressures(s.arm, random);
    MotionState end;
    simulator.move_unchecked(state, to, end);
    state = end;
    simulator.append_motion(to, frames);
    EXPECT_TRUE(state == state_after(frames, s.motion)) << "motion " << k;
  }
}

}  // namespace
}  // namespace limber
