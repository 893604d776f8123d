#pragma once

#include <deque>
#include <optional>

#include "forecast_check.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/state_lag.hpp"
#include "limber/world/environment.hpp"
#include "pressure_lag.hpp"
#include "shape_filter.hpp"

namespace limber {

/// Where a start in motion is: what MotionState holds, as an environment says it.
ArmStart start_at(const MotionState& state);

/// What a model has missed since a motion began, as far as it was measured: measured beside
/// predicted from the frame before. Zero where nothing was measured.
struct ModelMiss {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();     ///< of the tip over all frames: x, y, theta
  Eigen::Vector3d latest = Eigen::Vector3d::Zero();  ///< of the frame measured last
  double travelled_kpa = 0.0;                        ///< Σ|Δp| of the set points meanwhile
  Eigen::VectorXd plate_m;                           ///< ForecastCheck::missed_m
};

/// The arm's state from frame to frame: predicted by the model, corrected by what is measured.
/// Pressures are measured in each frame; a frame without a backbone is bridged by prediction.
/// Behind ideal valves pressures are the set points, as plans for such a model have it. Where a
/// driver's states are behind its set points, as they say themselves (StateLag) or their pressures
/// show (PressureLag), the model says what these lead to.
///
/// Threads: one estimate, one thread. One query per frame, one for each that states are behind, and
/// those of a ForecastCheck.
class ArmEstimate {
 public:
  /// @param check_frames  of the ForecastCheck
  ArmEstimate(const MotionModel& model, std::size_t check_frames)
      : model_(model), pressure_lag_(model_.valves()), check_(check_frames) {}
  ArmEstimate(const ArmEstimate&) = delete;  // the lag borrows the model's valves
  ArmEstimate& operator=(const ArmEstimate&) = delete;

  /// Measured shapes count as much as their noise allows, beside predicted ones from where the arm
  /// starts; without this, as they are.
  void filter_noise(const ShapeFilter& filter, const Backbone& start) {
    filter_ = filter;
    start_ = start;
  }

  /// The first call is the start, where the arm has long had these set points.
  void observe(const Pressures& setpoint_kpa, const ArmState& measured);

  /// Whether it was tracked at least once; before that there is no state.
  bool has_state() const { return state_.has_value(); }
  /// After the set points that were observed last. @pre has_state()
  const MotionState& state() const { return *ahead_; }
  /// The farthest that a plate came in the frame observed last. [m]
  double moved_m() const { return moved_m_; }
  /// Frames since it was tracked last.
  int frames_unseen() const { return frames_unseen_; }

  /// Of the frames since the last `forget_miss`.
  const ModelMiss& miss() const { return miss_; }
  void forget_miss() {
    miss_ = {};
    check_.forget();
  }

 private:
  void take_next(const Pressures& pressure_kpa);
  void predict(const Pressures& setpoint_kpa, const Pressures& pressure_kpa);
  void look_ahead();
  void note_miss(const Backbone& measured);

  MotionModel model_;
  MotionModel::Workspace workspace_;
  Eigen::VectorXf valves_;  // followed from the start on, tracked or not
  StateLag lag_;
  PressureLag pressure_lag_;
  std::deque<Pressures> coming_kpa_;  // set points whose frames no state has shown yet
  std::optional<MotionState> state_;  // in the frame that the last state shows
  std::optional<MotionState> ahead_;  // after those that are coming
  std::optional<ShapeFilter> filter_;
  std::optional<Backbone> start_;
  double moved_m_ = 0.0;
  int frames_unseen_ = 0;
  ModelMiss miss_;
  ForecastCheck check_;
};

}  // namespace limber
