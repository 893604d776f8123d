#pragma once

#include <cstddef>
#include <deque>
#include <optional>

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
  /// @param frames  the oldest that a forecast becomes, ≥ 1
  explicit ForecastCheck(std::size_t frames) : frames_(frames) {}

  /// All forecasts go on by a frame, in which the pressures change from one to the other.
  void step(const MotionModel& model, const Pressures& before_kpa, const Pressures& pressure_kpa,
            MotionModel::Workspace& workspace);
  /// Compares with where the arm is, and starts a forecast there.
  void compare(const MotionState& now);
  void forget();

  /// Per plate, the most that was seen recently: it counts a tenth less with every frame. Empty
  /// before anything was compared. [m]
  const Eigen::VectorXd& missed_m() const { return missed_m_; }
  /// Where the tip is that was compared last, less where the forecast of that age had it; none if
  /// no forecast has that age.
  std::optional<Eigen::Vector2d> missed_tip_m(std::size_t age) const;

 private:
  struct Forecast {
    Backbone before;
    Backbone now;
    std::size_t age = 0;
  };

  std::size_t frames_;
  std::deque<Forecast> forecasts_;  // the oldest first
  Eigen::VectorXd missed_m_;
};

}  // namespace limber
