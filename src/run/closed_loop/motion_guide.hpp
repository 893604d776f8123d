#pragma once

#include <memory>
#include <optional>
#include <string>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "limber/run/arm_estimate.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/run/plan_controller.hpp"
#include "limber/world/collision.hpp"
#include "plan_repair.hpp"
#include "shape_feedback.hpp"

namespace limber {

/// What becomes of an arm that follows set points from a state.
struct RestForecast {
  Pose end;               ///< of the tip, after the last of them
  int unsafe_frame = -1;  ///< first whose motion keeps less than was asked for, from 0; −1: none
  int unsafe_obstacle = -1;  ///< the obstacle it is too near to

  bool is_safe() const { return unsafe_frame < 0; }
};

/// Says what an arm in mid-motion does after its next frame (docs/planning.md, Closed loop). One
/// that is led goes on where the plan is free, also for an arm as far beside it as this one is, and
/// slower where one several times as far beside it is not. Else what is left of the plan is
/// simulated from the state that the next frame leads to. If that is safe and ends where the plan
/// promised, or nearer to the goal, the arm goes on. If not, the guide looks for a plan that starts
/// in that state: the rest of the present one with its end shifted, and then, if the rest is not
/// safe or would miss the goal, whatever a planner finds within its queries. It takes one that is
/// certified and better. If there is none and the way is not free for a second, the arm is halted.
///
/// Threads: one guide, one thread at a time. All arguments are borrowed.
class MotionGuide {
 public:
  MotionGuide(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
              const ErrorRoom& room, const ClosedLoopSettings& settings, Planner& planner,
              PlanCheck check, std::uint64_t seed);

  /// Of the room for the model's error, what the rest of a plan has to keep in motion: that error
  /// is one of whole motions, and what is left of one starts where the arm was just measured.
  static constexpr double kShareInMotion = 0.25;
  /// Another share, from the next question on.
  void keep(double share) { share_ = share; }

  /// @param at    the plan, and the frame and set points of it that are sent next, whatever is said
  /// @param aim   the goal that the plan was made for
  /// @param now   after the last frame
  /// @param miss  of the model, since this motion began; none in corrections
  /// @param feedback  that leads the arm; it has said these set points. None: the arm has
  ///   the plan's
  MotionAdvice advise(const PlanProgress& at, const PoseGoal& aim, const MotionState& now,
                      const ModelMiss& miss,
                      const std::optional<ShapeFeedback>& feedback = std::nullopt);

 private:
  /// A share of the plan's tube, if it has one.
  PlateRoom room_in_motion(const Plan& plan) const;
  /// Obstacles and clearance that the rest of a plan is asked for.
  CollisionChecker checker_for(const Plan& plan, const ModelMiss& miss) const;
  double needed_m(const Plan& plan) const;
  PlanningProblem problem_from(const Environment& from_here, const Plan& plan) const;
  /// Where the next frame leads, and what is kept from obstacles from there on.
  struct Ahead {
    const MotionState& from;
    const CollisionChecker& checker;
    double needed_m;

    RestForecast forecast_of(const MotionModel& model,
                             const std::vector<Pressures>& setpoints_kpa) const;
  };
  /// Whether an arm that is led goes on or waits. None: it needs another way.
  std::optional<MotionAdvice> lead(const Plan& plan, std::size_t next,
                                   const ShapeFeedback& feedback);
  /// Whether so many frames of a plan are, from `next` on.
  /// @param off  that the arm is beside the plan in all of them
  bool is_free(const Plan& plan, std::size_t next, std::size_t frames, const Backbone& off) const;
  /// What becomes of an arm that is led along the rest of a plan.
  RestForecast led_forecast(const Plan& plan, std::size_t next, const Ahead& way,
                            ShapeFeedback feedback) const;
  /// The best of what is found that is free as the rest of a plan has to be, and better than it.
  std::optional<FollowedPlan> find(const PlanProgress& at, const Ahead& way, const PoseGoal& goal,
                                   bool is_safe, double error_m);
  std::optional<Plan> searched(const Plan& plan, const Environment& from_here);

  const ArmDescription& arm_;
  MotionModel model_;
  const Environment& environment_;
  ErrorRoom room_;
  ClosedLoopSettings settings_;
  Planner& planner_;
  PlanCheck check_;
  std::uint64_t seed_;
  double share_ = kShareInMotion;
  bool has_waited_ = false;  // in the frame before
  bool strikes_ = false;     // as the last forecast has it
};

}  // namespace limber
