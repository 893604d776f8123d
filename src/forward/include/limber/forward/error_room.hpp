#pragma once
// For those who plan.

#include <optional>
#include <string>

#include "limber/forward/motion_model.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// The room that plans keep because the arm will not be quite where the model says: clearance from
/// obstacles, and distance to the goal's rim.
struct ErrorRoom {
  double margin_m = 0.0;
  PoseError goal_margin;
  /// PlanningProblem::margin_yields_to_start: true if no flag asked for this amount.
  bool margin_yields_to_start = true;
  /// If the amounts were not measured: why, and what to do about it.
  std::string note;
};

/// Amounts that the user asks for instead.
struct AskedRoom {
  std::optional<double> margin_m;
  std::optional<double> goal_margin_m;
  std::optional<double> goal_margin_rad;
};

/// For a network that stores its error on unseen motions (PredictionError), the room is that error.
/// For a network that does not, it is kUnknownErrorM. For the no-load model it is none: its error
/// is far larger than any room that a plan could keep.
ErrorRoom error_room(const ForwardModel& model, const AskedRoom& asked = {});

inline constexpr double kUnknownErrorM = 0.005;

}  // namespace limber
