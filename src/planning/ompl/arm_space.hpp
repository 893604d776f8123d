#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/control/SpaceInformation.h>

#include <optional>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "search/goal_seeker.hpp"

namespace limber {

struct OmplSettings {
  int frames = 10;
  double tip_weight = 0.0;
  bool directed = true;
};

/// What every part of the adapter works on during one plan. A state is (valve state, B, cost,
/// free): numbers that are exactly float32, n set points first, then pressures and set points
/// before them, 3m of the backbone, the cost of the path to it, and 1 or, if the motion to it
/// collided, 0.
struct ArmWorld {
  const PlanningProblem& problem;
  const CollisionChecker& checker;
  MotionSimulator& simulator;
  OmplSettings settings;
  RandomStream random;
  std::vector<Pressures> goal_configurations = {};
  std::uint64_t states = 0;  ///< that OMPL holds now
  /// What set points of each segment may be.
  std::vector<PressureLimits> limits = limits_of(problem);

  int segments() const { return problem.arm.segment_count(); }
  int valves() const { return problem.model.valves().state_size(); }
  int poses() const { return kPoseSize * problem.arm.point_count(); }
  /// Numbers of the backbone a frame earlier, behind the valves; 0: no velocities are read.
  int before() const { return problem.model.reads_velocity() ? poses() : 0; }
  int backbone_index() const { return valves() + before(); }
  int cost_index() const { return backbone_index() + poses(); }
  int free_index() const { return cost_index() + 1; }
  int size() const { return cost_index() + 2; }
  /// Largest Δp of a frame, with room for rounding to float32.
  double step_kpa() const { return (1.0 - 1e-5) * problem.arm.pressure_step_limit_kpa(); }

  Pressures setpoint_kpa(const ompl::base::State* state) const;
  MotionState motion_state(const ompl::base::State* state) const;
  void write(const MotionState& motion_state, double cost_kpa, bool free,
             ompl::base::State* state) const;
  /// A state that only serves as a target: settled at `kpa`, with the shape of the no-load model.
  void write_target(const Pressures& kpa, ompl::base::State* state) const;

  /// One frame under a control, Δp of a frame as OMPL holds it; plans are rebuilt by the same rule.
  Pressures next_setpoint(const Pressures& kpa, const double* change_kpa) const;
};

/// Limits, distance and samples of states.
ompl::base::StateSpacePtr make_arm_space(ArmWorld& world);

/// State space, controls, propagation and validity, set up.
ompl::control::SpaceInformationPtr make_space_information(ArmWorld& world);

/// The goal's region after the hold; samples are inverse-kinematics solutions, spread.
ompl::base::GoalPtr make_arm_goal(ArmWorld& world, const ompl::base::SpaceInformationPtr& si);

/// (2), read off the states.
ompl::base::OptimizationObjectivePtr make_pressure_objective(
    ArmWorld& world, const ompl::base::SpaceInformationPtr& si, double threshold_kpa);

}  // namespace limber
