#include "limber/forward/error_room.hpp"

#include <fmt/format.h>

#include "limber/common/units.hpp"

namespace limber {

namespace {

ErrorRoom default_room(const ForwardModel& model) {
  if (!model.has_network()) {
    return {
        0.0,
        {},
        true,
        "the no-load model's error is not known, so no clearance is kept for it: its plans mostly "
        "miss and may collide; --margin-m asks for a clearance"};
  }
  const std::optional<PredictionError>& error = model.compensation().prediction_error;
  if (!error) {
    return {
        kUnknownErrorM,
        {kUnknownErrorM, 0.0},
        true,
        fmt::format(
            "the model's error was not measured: {:.1f} cm of clearance are kept, and as much to "
            "the goal's rim; limber train measures the error",
            kUnknownErrorM * kCmPerM)};
  }
  return {error->off_path_m, {error->end_position_m, error->end_orientation_rad}, true, ""};
}

}  // namespace

ErrorRoom error_room(const ForwardModel& model, const AskedRoom& asked) {
  ErrorRoom room = default_room(model);
  if (asked.margin_m) {
    room.margin_yields_to_start = false;
    room.note.clear();
  }
  room.margin_m = asked.margin_m.value_or(room.margin_m);
  room.goal_margin.position_m = asked.goal_margin_m.value_or(room.goal_margin.position_m);
  room.goal_margin.orientation_rad =
      asked.goal_margin_rad.value_or(room.goal_margin.orientation_rad);
  return room;
}

}  // namespace limber
