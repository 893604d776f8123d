#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "goal_time.hpp"
#include "limber/run/arm_estimate.hpp"
#include "limber/run/episode_recorder.hpp"
#include "limber/run/executor.hpp"
#include "obstacle_appearance.hpp"
#include "prediction_watch.hpp"

namespace limber {

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
  /// Whether it was seen in the last 0.25 s.
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
  bool started_ = false;
  // Whether some frame was measured; a virtual arm knows its shape even if none was delivered.
  bool measured_ = false;
  double start_time_s_ = 0.0;
  double start_error_m_ = 0.0;
};

}  // namespace limber
