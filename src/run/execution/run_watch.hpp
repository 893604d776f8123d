#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>

#include "limber/run/appearing_obstacle.hpp"
#include "limber/run/arm_estimate.hpp"
#include "limber/run/collision_watch.hpp"
#include "limber/run/episode_recorder.hpp"
#include "limber/run/executor.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// An obstacle that appears during a run: when, where, and what the arm does beside it.
class ObstacleAppearance {
 public:
  /// Borrows all. @param obstacle  null: none appears
  ObstacleAppearance(const ArmDescription& arm, const Environment& environment,
                     const AppearingObstacle* obstacle)
      : arm_(arm), environment_(environment), obstacle_(obstacle) {}

  /// After each frame of the run, with the arm's shape if it is known. @return the environment with
  /// the obstacle, if it has just appeared
  const Environment* advance(int frame, double time_s, const std::optional<BackboneD>& shape);

  /// From when on it is there: as CollisionWatch::observe.
  void observe(double time_s, const Eigen::Ref<const BackboneD>& backbone) {
    if (watch_) {
      watch_->observe(time_s, backbone);
    }
  }

  /// When and where; none if it has not appeared.
  const std::optional<AppearedObstacle>& appeared() const { return appeared_; }

  /// Of the contacts with the obstacles of before and with this one, the nearer or the earlier one.
  std::optional<Contact> nearer(const std::optional<Contact>& before) const;
  std::optional<Contact> earlier(const std::optional<Contact>& before) const;

 private:
  std::optional<Contact> of_this(std::optional<Contact> contact) const;

  const ArmDescription& arm_;
  const Environment& environment_;
  const AppearingObstacle* obstacle_;
  std::optional<AppearedObstacle> appeared_;
  Environment now_;                      // with the obstacle
  std::optional<CollisionWatch> watch_;  // of the obstacle alone
};

/// When a tip came into the goal's region for good.
class GoalTime {
 public:
  explicit GoalTime(const PoseGoal& goal) : goal_(goal) {}

  void see(double time_s, const Pose& tip) {
    if (!is_within(goal_, pose_error(goal_, tip))) {
      inside_since_s_.reset();
    } else if (!inside_since_s_) {
      inside_since_s_ = time_s;
    }
  }

  /// None: it is not in there.
  std::optional<double> inside_since_s() const { return inside_since_s_; }

 private:
  const PoseGoal& goal_;
  std::optional<double> inside_since_s_;
};

/// Of a plan's predicted tip.
inline std::optional<double> planned_goal_time_s(const PoseGoal& goal, const Plan& plan) {
  GoalTime time(goal);
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    time.see(double(k) / plan.frame_rate_hz,
             tip_pose(plan.frames[k].backbone.cast<double>().eval()));
  }
  return time.inside_since_s();
}

/// Compares the tip with where a plan has it, frame by frame.
class PredictionWatch {
 public:
  void compare(const Plan& plan, std::size_t frame, const BackboneD& shape) {
    const double distance_m =
        (tip_position_m(plan.frames[frame].backbone) - tip_position_m(shape)).norm();
    error_.max_m = std::max(error_.max_m, distance_m);
    error_.final_m = distance_m;
    sum_m_ += distance_m;
    ++count_;
    if (int(frame) < plan.frame_count() - plan.hold_frame_count) {
      moving_sum_m_ += distance_m;
      error_.before_hold_m = moving_sum_m_ / ++moving_count_;
    }
  }

  /// None if nothing was compared.
  std::optional<ExecutedError> error() const {
    if (count_ == 0) {
      return std::nullopt;
    }
    ExecutedError error = error_;
    error.mean_m = sum_m_ / count_;
    return error;
  }

 private:
  ExecutedError error_;
  double sum_m_ = 0.0;
  int count_ = 0;
  double moving_sum_m_ = 0.0;
  int moving_count_ = 0;
};

/// What is seen of an execution, frame by frame, and what it amounts to in the end: contacts, the
/// goal, the prediction's error, the recording.
class RunWatch {
 public:
  /// The arm's shape now, where it is known: measured, or the truth of a virtual arm.
  using Look = std::function<std::optional<BackboneD>()>;

  /// Borrows arm, environment, driver, estimate and settings.
  RunWatch(const ArmDescription& arm, const Environment& environment, const ArmDriver& driver,
           const ArmEstimate& estimate, Look look, const ExecutionSettings& settings);

  /// The arm stands where the plan starts; what came before does not count.
  void start(const Plan& plan);
  /// Takes in the arm between frames.
  void observe(double time_s, const BackboneD& backbone);
  /// Takes in what the driver says after a frame at these set points.
  /// @param motion  which edge of the plan that was
  /// @return the environment with the obstacle, if it has appeared now
  const Environment* take_in(const Pressures& setpoint_kpa, int motion);
  /// Compares the last frame, where the arm was tracked in it, with the plan's that it shows.
  /// @param frame  of the plan that was commanded last; those after its end are held
  void compare(const Plan& plan, std::size_t frame);

  int frames() const { return frames_; }
  /// From the plan's first shape to where the arm was then: the farthest plate. 0 if unseen.
  double start_error_m() const { return start_error_m_; }
  /// The arm's shape when it was tracked last.
  const std::optional<BackboneD>& shape() const { return shape_; }
  /// Whether it is seen with its tip in the goal, held for as long as at a plan's end.
  bool rests_in_goal(double held_s) const;

  /// Fills in all that was seen. `result.status` is known by then.
  void judge(ExecutionResult& result);

 private:
  void see();
  bool is_in_goal() const;
  /// Whether it was seen in the last 0.25 s before the last frame; while it vents nobody looks.
  bool is_seen() const;

  const Environment& environment_;
  const ArmDriver& driver_;
  const ArmEstimate& estimate_;
  Look look_;
  CollisionWatch contacts_;
  ObstacleAppearance appearance_;
  EpisodeRecorder recorder_;
  GoalTime goal_time_;
  PredictionWatch prediction_;
  std::optional<BackboneD> shape_;
  int frames_ = 0;
  int frames_not_seen_ = 0;
  int shape_frame_ = -1;
  double shape_time_s_ = 0.0;
  double now_s_ = 0.0;  // of the last frame
  bool started_ = false;
  double start_time_s_ = 0.0;
  double start_error_m_ = 0.0;
};

}  // namespace limber
