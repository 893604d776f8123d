#pragma once

#include <cstddef>
#include <deque>

#include "limber/forward/motion_model.hpp"

namespace limber {

/// How far the plates came from where the model had them a moment before. In each frame a forecast
/// starts where the arm is, follows the pressures that the arm has then, and counts as long as it
/// is the oldest one. Frames in which the arm was not seen make forecasts older, and drop the
/// oldest.
///
/// Threads: one check, one thread. One query per frame and forecast.
class ForecastCheck {
 public:
  /// @param frames      the oldest that a forecast becomes, ≥ 1
  /// @param tip_frames  the age of those whose tips are compared, at most `frames`
  ForecastCheck(std::size_t frames, std::size_t tip_frames)
      : frames_(frames), tip_frames_(tip_frames) {}

  /// All forecasts go on by a frame, in which the pressures change from one to the other.
  void step(const MotionModel& model, const Pressures& before_kpa, const Pressures& pressure_kpa,
            MotionModel::Workspace& workspace);
  /// Compares with where the arm is, and starts a forecast there.
  void compare(const MotionState& now);
  void forget();

  /// Per plate, the most that was seen recently: it counts a tenth less with every frame. Empty
  /// before anything was compared. [m]
  const Eigen::VectorXd& missed_m() const { return missed_m_; }
  /// Where tips were, less where forecasts of `tip_frames` had them: low-passed, at most 5 cm.
  const Eigen::Vector2d& missed_tip_m() const { return missed_tip_m_; }
  std::size_t tip_frames() const { return tip_frames_; }

 private:
  struct Forecast {
    Backbone before;
    Backbone now;
    std::size_t age = 0;
  };

  std::size_t frames_;
  std::size_t tip_frames_;
  std::deque<Forecast> forecasts_;  // the oldest first
  Eigen::VectorXd missed_m_;
  Eigen::Vector2d missed_tip_m_ = Eigen::Vector2d::Zero();
};

}  // namespace limber
