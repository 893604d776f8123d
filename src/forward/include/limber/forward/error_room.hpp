#pragma once
// For those who plan.

#include <optional>
#include <string>

#include "limber/forward/motion_model.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// The room that plans keep because the arm will not be quite where the model says: clearance from
/// obstacles, and distance to the goal's rim.
struct ErrorRoom {
  /// One amount for the whole arm; of a tube, its largest radius.
  double margin_m = 0.0;
  PoseError goal_margin;
  /// The calibrated tube; plans that keep it free need no margin beside it. None: the model carries
  /// none, or a flag asks for a margin instead.
  std::optional<PlanTube> tube = std::nullopt;
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
  std::optional<double> tube_level;  ///< of those that the model carries
};

/// For a network that carries a tube (docs/tube.md), the room is that tube, at the level asked for
/// or at its default level; unless a margin is asked for.
/// For another network that stores its error on unseen motions (PredictionError), the room is that
/// error. For a network that does not, it is kUnknownErrorM. For the no-load model it is none: its
/// error is far larger than any room that a plan could keep.
/// @throws InputError if the model does not carry the level asked for, naming those that it does.
ErrorRoom error_room(const ForwardModel& model, const AskedRoom& asked = {});

inline constexpr double kUnknownErrorM = 0.005;

}  // namespace limber
