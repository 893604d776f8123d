#include "arm_space.hpp"

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/control/DirectedControlSampler.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

constexpr double kMaxAngleRad = 100.0;
constexpr double kOvershoot = 1.05;  // × the limit: OMPL asks for bounds, the arm keeps its own
constexpr double kGoalSpread = 0.1;  // of the limits, about a goal configuration

const double* values(const ob::State* state) {
  return state->as<ob::RealVectorStateSpace::StateType>()->values;
}
double* values(ob::State* state) {
  return state->as<ob::RealVectorStateSpace::StateType>()->values;
}
double* values(oc::Control* control) {
  return control->as<oc::RealVectorControlSpace::ControlType>()->values;
}
const double* values(const oc::Control* control) {
  return control->as<oc::RealVectorControlSpace::ControlType>()->values;
}

const PressureLimits& limits_of(const ArmWorld& world, int segment) {
  return world.limits[segment];
}

/// What distances between set points are measured in.
double scale_kpa(const ArmWorld& world, int segment) {
  return world.problem.arm.segments[segment].pressure_limit_kpa.half_width_kpa();
}

/// Draws set points; the shape is the no-load model's, so that distances to it mean something.
class ArmSampler final : public ob::StateSampler {
 public:
  ArmSampler(const ob::StateSpace* space, ArmWorld& world) : StateSampler(space), world_(world) {}

  void sampleUniform(ob::State* state) override {
    Pressures kpa(world_.segments());
    for (int i = 0; i < kpa.size(); ++i) {
      const PressureLimits limits = limits_of(world_, i);
      kpa[i] = float(world_.random.uniform(limits.lower_kpa, limits.upper_kpa));
    }
    world_.write_target(kpa, state);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    sampleGaussian(state, near, distance);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    Pressures kpa = world_.setpoint_kpa(mean);
    for (int i = 0; i < kpa.size(); ++i) {
      const double shift = scale_kpa(world_, i) * deviation * world_.random.normal();
      kpa[i] = float(limits_of(world_, i).clamped(double(kpa[i]) + shift));
    }
    world_.write_target(kpa, state);
  }

 private:
  ArmWorld& world_;
};

/// The tip in the plane, for planners that keep grids.
class TipProjection final : public ob::ProjectionEvaluator {
 public:
  TipProjection(const ob::StateSpace* space, const ArmWorld& world)
      : ProjectionEvaluator(space), tip_(world.backbone_index() + world.poses() - kPoseSize) {
    constexpr double kCells = 20.0;  // an arm's length
    cellSizes_ = {world.problem.arm.length_m() / kCells, world.problem.arm.length_m() / kCells};
  }
  unsigned int getDimension() const override { return 2; }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    projection << values(state)[tip_], values(state)[tip_ + 1];
  }

 private:
  int tip_;
};

/// Of a segment's set points and pressures. A start in motion may have more than planning allows,
/// and OMPL takes no start that is out of bounds.
PressureLimits valve_range(const ArmWorld& world, const MotionState& start, int segment) {
  PressureLimits range = limits_of(world, segment).widened(kOvershoot);
  for (Eigen::Index i = segment; i < start.valves.size(); i += world.segments()) {
    range.lower_kpa = std::min(range.lower_kpa, double(start.valves[i]));
    range.upper_kpa = std::max(range.upper_kpa, double(start.valves[i]));
  }
  return range;
}

class ArmSpace final : public ob::RealVectorStateSpace {
 public:
  explicit ArmSpace(ArmWorld& world)
      : RealVectorStateSpace(static_cast<unsigned>(world.size())), world_(world) {
    ob::RealVectorBounds bounds(static_cast<unsigned>(world.size()));
    const double reach = 4.0 * world.problem.arm.length_m();
    const MotionState start = start_of(world.problem);
    for (int i = 0; i < world.size(); ++i) {
      const auto index = static_cast<unsigned>(i);
      const bool angle = (i - world.valves()) % kPoseSize == 2;
      const double most = i == world.cost_index()   ? 1e9
                          : i == world.free_index() ? 1.0
                          : angle                   ? kMaxAngleRad
                                                    : reach;
      const PressureLimits range = i < world.valves()
                                       ? valve_range(world, start, i % world.segments())
                                       : PressureLimits(most);
      bounds.setLow(index, range.lower_kpa);
      bounds.setHigh(index, range.upper_kpa);
    }
    setBounds(bounds);
  }

  double distance(const ob::State* a, const ob::State* b) const override {
    double squares = 0.0;
    for (int i = 0; i < world_.segments(); ++i) {
      const double change = (values(a)[i] - values(b)[i]) / scale_kpa(world_, i);
      squares += change * change;
    }
    const int tip = world_.backbone_index() + world_.poses() - kPoseSize;
    const double distance =
        std::hypot(values(a)[tip] - values(b)[tip], values(a)[tip + 1] - values(b)[tip + 1]) *
        world_.settings.tip_weight / world_.problem.arm.length_m();
    return std::sqrt(squares + distance * distance);
  }
  ob::State* allocState() const override {
    ++world_.states;
    return RealVectorStateSpace::allocState();
  }
  void freeState(ob::State* state) const override {
    --world_.states;
    RealVectorStateSpace::freeState(state);
  }
  ob::StateSamplerPtr allocDefaultStateSampler() const override {
    return std::make_shared<ArmSampler>(this, world_);
  }
  void registerProjections() override {
    registerDefaultProjection(std::make_shared<TipProjection>(this, world_));
  }

 private:
  ArmWorld& world_;
};

/// Δp of a frame, each within the rate.
class ArmControlSampler final : public oc::ControlSampler {
 public:
  ArmControlSampler(const oc::ControlSpace* space, ArmWorld& world)
      : ControlSampler(space), world_(world) {}
  void sample(oc::Control* control) override {
    const double step = world_.step_kpa();
    for (int i = 0; i < world_.segments(); ++i) {
      values(control)[i] = world_.random.uniform(-step, step);
    }
  }
  unsigned int sampleStepCount(unsigned int min, unsigned int max) override {
    return min + world_.random.index(max - min + 1);
  }

 private:
  ArmWorld& world_;
};

/// Steers straight at the wanted pressures, as fast as the rate allows.
class StraightSampler final : public oc::DirectedControlSampler {
 public:
  StraightSampler(const oc::SpaceInformation* si, ArmWorld& world)
      : DirectedControlSampler(si), world_(world) {}

  unsigned int sampleTo(oc::Control* control, const ob::State* source, ob::State* dest) override {
    const double step = world_.step_kpa();
    double largest = 0.0;
    for (int i = 0; i < world_.segments(); ++i) {
      largest = std::max(largest, std::abs(values(dest)[i] - values(source)[i]));
    }
    const int wanted = std::max(1, int(std::ceil(largest / step)));
    for (int i = 0; i < world_.segments(); ++i) {
      values(control)[i] = (values(dest)[i] - values(source)[i]) / wanted;
    }
    const auto frames = static_cast<unsigned>(std::min(wanted, world_.settings.frames));
    return si_->propagateWhileValid(source, control, int(frames), dest);
  }
  unsigned int sampleTo(oc::Control* control, const oc::Control*, const ob::State* source,
                        ob::State* dest) override {
    return sampleTo(control, source, dest);
  }

 private:
  ArmWorld& world_;
};

/// One frame of the forward model, with the swept collision check.
class FramePropagator final : public oc::StatePropagator {
 public:
  FramePropagator(const oc::SpaceInformationPtr& si, ArmWorld& world)
      : StatePropagator(si), world_(world) {}

  void propagate(const ob::State* state, const oc::Control* control, double /*one frame*/,
                 ob::State* result) const override {
    const Pressures from = world_.setpoint_kpa(state);
    const Pressures to = world_.next_setpoint(from, values(control));
    MotionState next;
    const bool free = world_.simulator.move(world_.motion_state(state), to, next);
    const double cost = values(state)[world_.cost_index()] + motion_cost_kpa(from, to);
    const bool was_free = values(state)[world_.free_index()] > 0.5;
    world_.write(next, cost, free && was_free, result);
  }
  bool canPropagateBackward() const override { return false; }

 private:
  ArmWorld& world_;
};

class ArmGoal final : public ob::GoalSampleableRegion {
 public:
  ArmGoal(const ob::SpaceInformationPtr& si, ArmWorld& world)
      : GoalSampleableRegion(si), world_(world) {}

  double distanceGoal(const ob::State* state) const override {
    return excess(settled_tip(world_.motion_state(state)));
  }

  bool isSatisfied(const ob::State* state) const override {
    double distance = 0.0;
    return isSatisfied(state, &distance);
  }
  bool isSatisfied(const ob::State* state, double* distance) const override {
    const PoseGoal& goal = world_.problem.environment.goal;
    const MotionState now = world_.motion_state(state);
    *distance = excess(settled_tip(now));
    MotionState held;
    if (!HoldRange().reaches(goal, settled_tip(now)) || !world_.simulator.hold(now, held)) {
      return false;
    }
    const Pose tip = tip_pose(held.backbone);
    *distance = excess(tip);
    return is_within(goal, pose_error(goal, tip));
  }

  void sampleGoal(ob::State* state) const override {
    const auto count = std::uint32_t(world_.goal_configurations.size());
    world_.write_target(world_.goal_configurations[world_.random.index(count)], state);
    ArmSampler(si_->getStateSpace().get(), world_).sampleGaussian(state, state, kGoalSpread);
  }
  unsigned int maxSampleCount() const override {
    return world_.goal_configurations.empty() ? 0 : std::numeric_limits<unsigned>::max();
  }

 private:
  Pose settled_tip(const MotionState& state) const {
    return world_.problem.model.settled_tip(state.valves, state.backbone);
  }

  /// Metres beyond the region, a radian counted as a tenth of one; 0 inside.
  double excess(const Pose& tip) const {
    constexpr double kMetresPerRad = 0.1;
    const PoseGoal& goal = world_.problem.environment.goal;
    const PoseError error = pose_error(goal, tip);
    const double turned =
        goal.theta_rad ? std::max(0.0, error.orientation_rad - goal.orientation_tolerance_rad)
                       : 0.0;
    return std::max(0.0, error.position_m - goal.position_tolerance_m) + kMetresPerRad * turned;
  }

  ArmWorld& world_;
};

class PressureObjective final : public ob::OptimizationObjective {
 public:
  PressureObjective(const ob::SpaceInformationPtr& si, const ArmWorld& world)
      : OptimizationObjective(si), world_(world) {}
  ob::Cost stateCost(const ob::State*) const override { return ob::Cost(0.0); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(values(to)[world_.cost_index()] - values(from)[world_.cost_index()]);
  }

 private:
  const ArmWorld& world_;
};

}  // namespace

Pressures ArmWorld::setpoint_kpa(const ob::State* state) const {
  return Eigen::Map<const Eigen::VectorXd>(values(state), segments()).cast<float>();
}

MotionState ArmWorld::motion_state(const ob::State* state) const {
  const Eigen::Index n = segments();
  const double* numbers = values(state);
  const auto backbone_at = [&](int index) {
    return Eigen::Map<const BackboneD>(numbers + index, problem.arm.point_count(), kPoseSize)
        .cast<float>();
  };
  MotionState result = problem.model.moving_state(
      Eigen::Map<const Eigen::VectorXd>(numbers, valves()).cast<float>(),
      backbone_at(backbone_index()), backbone_at(before() > 0 ? valves() : backbone_index()));
  result.valves.head(n).swap(result.valves.segment(n, n));  // set points first in OMPL's state
  return result;
}

void ArmWorld::write(const MotionState& motion_state, double cost_kpa, bool free,
                     ob::State* state) const {
  double* numbers = values(state);
  const Eigen::Index n = segments();
  std::copy(motion_state.valves.begin(), motion_state.valves.end(), numbers);
  std::swap_ranges(numbers, numbers + n, numbers + n);
  std::copy_n(motion_state.before.data(), motion_state.before.size(), numbers + valves());
  std::copy_n(motion_state.backbone.data(), motion_state.backbone.size(),
              numbers + backbone_index());
  numbers[cost_index()] = cost_kpa;
  numbers[free_index()] = free ? 1.0 : 0.0;
}

void ArmWorld::write_target(const Pressures& kpa, ob::State* state) const {
  Backbone shape(problem.arm.point_count(), kPoseSize);
  problem.model.no_load().backbone(kpa, shape);
  write(problem.model.settled_state(kpa, shape), 0.0, true, state);
}

Pressures ArmWorld::next_setpoint(const Pressures& kpa, const double* change_kpa) const {
  Pressures next = kpa;
  for (int i = 0; i < segments(); ++i) {
    next[i] = float(limits_of(*this, i).clamped(double(kpa[i]) + change_kpa[i]));
  }
  return next;
}

ob::StateSpacePtr make_arm_space(ArmWorld& world) {
  return std::make_shared<ArmSpace>(world);
}

oc::SpaceInformationPtr make_space_information(ArmWorld& world) {
  const ob::StateSpacePtr space = make_arm_space(world);
  const auto controls =
      std::make_shared<oc::RealVectorControlSpace>(space, static_cast<unsigned>(world.segments()));
  ob::RealVectorBounds bounds(static_cast<unsigned>(world.segments()));
  bounds.setLow(-world.step_kpa());
  bounds.setHigh(world.step_kpa());
  controls->setBounds(bounds);
  controls->setControlSamplerAllocator([&world](const oc::ControlSpace* s) {
    return std::make_shared<ArmControlSampler>(s, world);
  });
  auto si = std::make_shared<oc::SpaceInformation>(space, controls);
  si->setStateValidityChecker(
      [&world](const ob::State* state) { return values(state)[world.free_index()] > 0.5; });
  si->setStatePropagator(std::make_shared<FramePropagator>(si, world));
  si->setPropagationStepSize(world.problem.arm.frame_period_s());
  si->setMinMaxControlDuration(1, static_cast<unsigned>(world.settings.frames));
  if (world.settings.directed) {
    si->setDirectedControlSamplerAllocator([&world](const oc::SpaceInformation* s) {
      return std::make_shared<StraightSampler>(s, world);
    });
  }
  si->setup();
  return si;
}

ob::GoalPtr make_arm_goal(ArmWorld& world, const ob::SpaceInformationPtr& si) {
  return std::make_shared<ArmGoal>(si, world);
}

ob::OptimizationObjectivePtr make_pressure_objective(ArmWorld& world,
                                                     const ob::SpaceInformationPtr& si,
                                                     double threshold_kpa) {
  auto objective = std::make_shared<PressureObjective>(si, world);
  objective->setCostThreshold(ob::Cost(threshold_kpa));
  return objective;
}

}  // namespace limber
