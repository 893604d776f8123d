#include "src/planning/ompl/arm_space.hpp"

#include <ompl/base/ScopedState.h>
#include <ompl/control/DirectedControlSampler.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"

namespace limber {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

constexpr double kRounding = 1e-9;   // of distances about 1, in double
constexpr double kSingleKpa = 1e-3;  // set points are float32, and add up over a motion

double* numbers(const ob::State* state) {
  return state->as<ob::RealVectorStateSpace::StateType>()->values;
}

/// Slow, with a dead time of one frame and a half: set points are under way.
ValveModel slow_valves(const ArmDescription& arm) {
  return {arm, {true, std::vector<SegmentValves>(3, {{0.2, 100.0}, {0.3, 100.0}, 0.075, 0.1})}};
}

/// An arm in front of pillars, as OMPL's planners see it.
class ArmSpace : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { ompl::msg::noOutputHandler(); }

  ob::ScopedState<> sample(const ob::StateSpacePtr& space) {
    ob::ScopedState<> state(space);
    space->allocDefaultStateSampler()->sampleUniform(state.get());
    return state;
  }

  /// A state in the middle of a motion: pressures lag behind set points.
  MotionState moving_state() {
    MotionState state = start_of(problem_);
    MotionModel::Workspace workspace;
    for (const float kpa : {4.0F, -3.0F, 7.0F, 1.5F}) {
      const Pressures next = (state.setpoint_kpa().array() + kpa).matrix();
      problem_.model.step(next, state, workspace);
    }
    return state;
  }

  Setting setting_{true};
  PlanningProblem problem_{setting_.arm, MotionModel(setting_.model, slow_valves(setting_.arm)),
                           setting_.environment};
  CollisionChecker checker_{setting_.arm, setting_.environment.obstacles};
  MotionSimulator simulator_{setting_.arm, problem_.model, checker_};
  ArmWorld world_{problem_, checker_, simulator_, {}, RandomStream(3, 1)};
};

TEST_F(ArmSpace, DistanceIsThatOfScaledSetPointsAndTips) {
  const ob::StateSpacePtr space = make_arm_space(world_);
  for (const double tip_weight : {0.0, 2.0}) {
    world_.settings.tip_weight = tip_weight;
    for (int k = 0; k < 20; ++k) {
      const auto a = sample(space);
      const auto b = sample(space);
      const MotionState from = world_.motion_state(a.get());
      const MotionState to = world_.motion_state(b.get());
      double squares = 0.0;
      for (int i = 0; i < 3; ++i) {
        const double limit =
            setting_.arm.segments[std::size_t(i)].pressure_limit_kpa.half_width_kpa();
        squares +=
            std::pow((double(from.setpoint_kpa()[i]) - double(to.setpoint_kpa()[i])) / limit, 2);
      }
      const Pose tip_a = tip_pose(from.backbone);
      const Pose tip_b = tip_pose(to.backbone);
      const double apart = std::hypot(tip_a.x_m - tip_b.x_m, tip_a.y_m - tip_b.y_m);
      EXPECT_NEAR(space->distance(a.get(), b.get()),
                  std::hypot(std::sqrt(squares), tip_weight * apart / setting_.arm.length_m()),
                  kRounding);
    }
  }
}

TEST_F(ArmSpace, DistanceIsAMetric) {
  const ob::StateSpacePtr space = make_arm_space(world_);
  world_.settings.tip_weight = 1.0;
  for (int k = 0; k < 50; ++k) {
    const auto a = sample(space);
    const auto b = sample(space);
    const auto c = sample(space);
    EXPECT_EQ(space->distance(a.get(), a.get()), 0.0);
    EXPECT_GT(space->distance(a.get(), b.get()), 0.0);
    EXPECT_EQ(space->distance(a.get(), b.get()), space->distance(b.get(), a.get()));
    EXPECT_LE(space->distance(a.get(), c.get()),
              space->distance(a.get(), b.get()) + space->distance(b.get(), c.get()) + kRounding);
  }
}

TEST_F(ArmSpace, InterpolationDividesDistances) {
  const ob::StateSpacePtr space = make_arm_space(world_);
  world_.settings.tip_weight = 1.0;
  ob::ScopedState<> between(space);
  for (int k = 0; k < 20; ++k) {
    const auto a = sample(space);
    const auto b = sample(space);
    const double whole = space->distance(a.get(), b.get());
    for (const double t : {0.0, 0.3, 1.0}) {
      space->interpolate(a.get(), b.get(), t, between.get());
      EXPECT_NEAR(space->distance(a.get(), between.get()), t * whole, kRounding);
      EXPECT_NEAR(space->distance(between.get(), b.get()), (1.0 - t) * whole, kRounding);
    }
    space->interpolate(a.get(), b.get(), 1.0, between.get());
    EXPECT_TRUE(space->equalStates(between.get(), b.get()));
  }
}

TEST_F(ArmSpace, AStateKeepsEveryBitOfAMotion) {
  const ob::StateSpacePtr space = make_arm_space(world_);
  ob::ScopedState<> state(space);
  const MotionState motion = moving_state();
  ASSERT_NE(Pressures(motion.pressure_kpa()), Pressures(motion.setpoint_kpa()));
  world_.write(motion, 12.5, true, state.get());
  EXPECT_TRUE(world_.motion_state(state.get()) == motion);
  EXPECT_EQ(world_.setpoint_kpa(state.get()), Pressures(motion.setpoint_kpa()));
  EXPECT_EQ(numbers(state.get())[world_.cost_index()], 12.5);
  EXPECT_TRUE(space->satisfiesBounds(state.get()));
}

// What is measured in motion may be beyond the limits, and more so beyond those to plan within.
TEST_F(ArmSpace, AStartInMotionIsInBoundsWhateverItsValvesHave) {
  const Backbone straight = start_of(problem_).backbone;
  setting_.environment.start =
      ArmStart{Eigen::Vector3f(108.0F, -60.0F, 20.0F),
               straight,
               {Eigen::Vector3f(40.0F, -50.0F, 20.0F), Eigen::Vector3f(70.0F, -55.0F, 10.0F)}};
  world_.limits.assign(3, PressureLimits(50.0));
  const ob::StateSpacePtr space = make_arm_space(world_);
  ob::ScopedState<> state(space);
  world_.write(start_of(problem_), 0.0, true, state.get());
  EXPECT_TRUE(space->satisfiesBounds(state.get()));
  numbers(state.get())[0] = 109.0;
  EXPECT_FALSE(space->satisfiesBounds(state.get()));
}

TEST_F(ArmSpace, SamplesAreTargetsAtRestWithinTheLimits) {
  const ob::StateSpacePtr space = make_arm_space(world_);
  Pressures lowest = Pressures::Zero(3);
  Pressures highest = Pressures::Zero(3);
  const ob::StateSamplerPtr sampler = space->allocDefaultStateSampler();
  ob::ScopedState<> near(space);
  for (int k = 0; k < 300; ++k) {
    const auto state = sample(space);
    const MotionState target = world_.motion_state(state.get());
    const Pressures kpa = target.setpoint_kpa();
    EXPECT_EQ(kpa, Pressures(target.pressure_kpa()));
    Backbone shape(setting_.arm.point_count(), 3);
    problem_.model.no_load().backbone(kpa, shape);
    EXPECT_EQ(target.backbone, shape);
    lowest = lowest.cwiseMin(kpa);
    highest = highest.cwiseMax(kpa);
    sampler->sampleGaussian(near.get(), state.get(), 0.5);
    EXPECT_TRUE(space->satisfiesBounds(near.get()));
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(std::abs(world_.setpoint_kpa(near.get())[i]),
                float(setting_.arm.segments[std::size_t(i)].pressure_limit_kpa.upper_kpa));
    }
  }
  for (int i = 0; i < 3; ++i) {
    const auto limit = float(setting_.arm.segments[std::size_t(i)].pressure_limit_kpa.upper_kpa);
    EXPECT_LE(highest[i], limit);
    EXPECT_GE(lowest[i], -limit);
    EXPECT_GT(highest[i], 0.9F * limit) << "samples reach all there is";
    EXPECT_LT(lowest[i], -0.9F * limit);
  }
}

TEST_F(ArmSpace, CountsTheStatesThatOmplHolds) {
  const ob::StateSpacePtr space = make_arm_space(world_);
  const std::uint64_t before = world_.states;
  ob::State* a = space->allocState();
  ob::State* b = space->cloneState(a);
  EXPECT_EQ(world_.states, before + 2);
  space->freeState(a);
  space->freeState(b);
  EXPECT_EQ(world_.states, before);
}

TEST_F(ArmSpace, APropagationIsOneFrameOfTheModel) {
  const oc::SpaceInformationPtr si = make_space_information(world_);
  ob::ScopedState<> from(si->getStateSpace());
  ob::ScopedState<> to(si->getStateSpace());
  oc::Control* control = si->allocControl();
  double* change = control->as<oc::RealVectorControlSpace::ControlType>()->values;
  MotionState expected = moving_state();
  world_.write(expected, 3.0, true, from.get());
  double cost = 3.0;
  MotionModel::Workspace workspace;
  for (const double kpa : {1.0, -2.0, 0.5}) {
    std::fill_n(change, 3, kpa);
    si->propagate(from.get(), control, 1, to.get());
    const Pressures before = expected.setpoint_kpa();
    const Pressures now = world_.next_setpoint(before, change);
    problem_.model.step(now, expected, workspace);
    cost += (now - before).cwiseAbs().cast<double>().sum();
    EXPECT_TRUE(world_.motion_state(to.get()) == expected);
    EXPECT_NEAR(numbers(to.get())[world_.cost_index()], cost, kSingleKpa);
    EXPECT_TRUE(si->isValid(to.get()));
    from = to;
  }
  numbers(from.get())[world_.free_index()] = 0.0;
  si->propagate(from.get(), control, 1, to.get());
  EXPECT_FALSE(si->isValid(to.get())) << "what follows a collision is no motion either";
  si->freeControl(control);
}

TEST_F(ArmSpace, SetPointsStayWithinTheLimits) {
  const double far[] = {1e4, -1e4, 0.0};
  const Pressures next = world_.next_setpoint(Pressures::Constant(3, 5.0F), far);
  EXPECT_EQ(next[0], float(setting_.arm.segments[0].pressure_limit_kpa.upper_kpa));
  EXPECT_EQ(next[1], -float(setting_.arm.segments[1].pressure_limit_kpa.upper_kpa));
  EXPECT_EQ(next[2], 5.0F);
}

TEST_F(ArmSpace, StraightControlsArriveInAsFewFramesAsTheRateAllows) {
  world_.settings.frames = 100;
  const oc::SpaceInformationPtr si = make_space_information(world_);
  const oc::DirectedControlSamplerPtr sampler = si->allocDirectedControlSampler();
  oc::Control* control = si->allocControl();
  const double* change = control->as<oc::RealVectorControlSpace::ControlType>()->values;
  ob::ScopedState<> from(si->getStateSpace());
  ob::ScopedState<> to(si->getStateSpace());
  world_.write(start_of(problem_), 0.0, true, from.get());
  const Pressures wanted = (Pressures(3) << 9.0F, -4.0F, 0.5F).finished();
  world_.write_target(wanted, to.get());
  const unsigned frames = sampler->sampleTo(control, from.get(), to.get());
  const double step = world_.step_kpa();
  EXPECT_EQ(frames, unsigned(std::ceil(9.0 / step)));
  for (int i = 0; i < 3; ++i) {
    EXPECT_LE(std::abs(change[i]), step);
    EXPECT_NEAR(double(world_.setpoint_kpa(to.get())[i]), double(wanted[i]), kSingleKpa);
  }
  si->freeControl(control);
}

// Satisfied means: held there, the tip comes to rest in the goal.
TEST_F(ArmSpace, TheGoalIsJudgedAfterTheHold) {
  const oc::SpaceInformationPtr si = make_space_information(world_);
  const PoseGoal& goal = setting_.environment.goal;
  const PlanResult solved = setting_.plan("default", 1500);
  ASSERT_TRUE(solved.plan);
  world_.goal_configurations = {solved.plan->frames.back().setpoint_kpa};
  const ob::GoalPtr region = make_arm_goal(world_, si);
  auto* samples = region->as<ob::GoalSampleableRegion>();
  ob::ScopedState<> state(si->getStateSpace());
  int satisfied = 0;
  for (int k = 0; k < 40; ++k) {
    samples->sampleGoal(state.get());
    MotionState held;
    const bool free = simulator_.hold(world_.motion_state(state.get()), held);
    double distance = -1.0;
    const bool is_satisfied = region->isSatisfied(state.get(), &distance);
    const bool inside = free && is_within(goal, pose_error(goal, tip_pose(held.backbone)));
    // Far from the goal nothing is held, so only those near it have to agree.
    EXPECT_LE(is_satisfied, inside) << k;
    EXPECT_GE(samples->distanceGoal(state.get()), 0.0);
    if (is_satisfied) {
      EXPECT_EQ(distance, 0.0);
      ++satisfied;
    }
  }
  world_.write(start_of(problem_), 0.0, true, state.get());
  EXPECT_FALSE(region->isSatisfied(state.get()));
  EXPECT_GT(satisfied, 0);
  EXPECT_GT(samples->distanceGoal(state.get()), 0.0);
}

TEST_F(ArmSpace, TheObjectiveReadsCostsOffTheStates) {
  const oc::SpaceInformationPtr si = make_space_information(world_);
  const ob::OptimizationObjectivePtr objective = make_pressure_objective(world_, si, 42.0);
  ob::ScopedState<> a(si->getStateSpace());
  ob::ScopedState<> b(si->getStateSpace());
  world_.write(start_of(problem_), 10.0, true, a.get());
  world_.write(start_of(problem_), 17.5, true, b.get());
  EXPECT_EQ(objective->motionCost(a.get(), b.get()).value(), 7.5);
  EXPECT_EQ(objective->stateCost(a.get()).value(), 0.0);
  EXPECT_TRUE(objective->isSatisfied(ob::Cost(41.9)));
  EXPECT_FALSE(objective->isSatisfied(ob::Cost(42.1)));
}

}  // namespace
}  // namespace limber
