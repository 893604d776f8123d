#pragma once
// For those who plan.

#include <optional>
#include <string>

#include "limber/forward/motion_model.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// What plans keep in hand, since the arm will not be quite where the model says: clearance from
/// obstacles, and way to the goal's rim.
struct ErrorRoom {
  double margin_m = 0.0;
  PoseError goal_margin;
  /// PlanningProblem::margin_yields_to_start: nobody has asked for this very amount.
  bool margin_yields_to_start = true;
  /// Where the amounts are no measured ones, why, and what to do about it.
  std::string note;
};

/// Amounts that somebody asks for instead.
struct AskedRoom {
  std::optional<double> margin_m;
  std::optional<double> goal_margin_m;
  std::optional<double> goal_margin_rad;
};

/// Of a network that knows its error on motions it has not seen (PredictionError): that error. Of
/// one that does not, kUnknownErrorM. Of the no-load model none: it errs by far more than any plan
/// could keep.
ErrorRoom error_room(const ForwardModel& model, const AskedRoom& asked = {});

inline constexpr double kUnknownErrorM = 0.005;

}  // namespace limber
