#include "limber/forward/error_room.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

ErrorRoom default_room(const ForwardModel& model) {
  ErrorRoom room;
  if (!model.has_network()) {
    room.note =
        "the no-load model's error is not known, so no clearance is kept for it: its plans mostly "
        "miss and may collide; --margin-m asks for a clearance";
    return room;
  }
  const std::optional<PredictionError>& error = model.compensation().prediction_error;
  if (!error) {
    room.margin_m = kUnknownErrorM;
    room.goal_margin = {kUnknownErrorM, 0.0};
    room.note = fmt::format(
        "the model's error was not measured: {:.1f} cm of clearance are kept, and as much to "
        "the goal's rim; limber train measures the error",
        kUnknownErrorM * kCmPerM);
    return room;
  }
  room.margin_m = error->off_path_m;
  room.goal_margin = {error->end_position_m, error->end_orientation_rad.value_or(0.0)};
  return room;
}

/// The level that plans keep; none where they keep a margin instead.
const TubeLevel* level_of(const ForwardModel& model, const AskedRoom& asked) {
  const Tube* tube =
      model.has_network() && model.compensation().tube ? &*model.compensation().tube : nullptr;
  if (!asked.tube_level) {
    return tube == nullptr || asked.margin_m ? nullptr : &tube->default_level();
  }
  if (tube == nullptr) {
    throw InputError(
        fmt::format("a tube of {} is asked for (--tube); the model carries none: limber "
                    "calibrate measures one",
                    *asked.tube_level));
  }
  const TubeLevel* level = tube->find(*asked.tube_level);
  if (level == nullptr) {
    throw InputError(fmt::format("a tube of {} is asked for (--tube); the model carries {}",
                                 *asked.tube_level, names_of_levels(*tube)));
  }
  return level;
}

ErrorRoom room_of(const Tube& tube, const TubeLevel& level) {
  PlanTube radii;
  radii.level = level.level;
  for (const double scale : tube.plate_scale_m) {
    radii.plate_radius_m.push_back(level.factor * scale);
  }
  radii.growth = tube.growth;
  radii.end_radius_m = level.factor * tube.end_scale_m;
  radii.end_heading_rad = level.factor * tube.end_heading_scale_rad;
  const double largest =
      *std::max_element(radii.plate_radius_m.begin(), radii.plate_radius_m.end());
  return {largest, {radii.end_radius_m, radii.end_heading_rad}, std::move(radii), true, ""};
}

}  // namespace

ErrorRoom error_room(const ForwardModel& model, const AskedRoom& asked) {
  const TubeLevel* level = level_of(model, asked);
  ErrorRoom room =
      level == nullptr ? default_room(model) : room_of(*model.compensation().tube, *level);
  room.margin_yields_to_start = !asked.tube_level && !asked.margin_m;
  if (asked.margin_m) {
    room.note.clear();
  }
  room.margin_m = asked.margin_m.value_or(room.margin_m);
  room.goal_margin.position_m = asked.goal_margin_m.value_or(room.goal_margin.position_m);
  room.goal_margin.orientation_rad =
      asked.goal_margin_rad.value_or(room.goal_margin.orientation_rad);
  return room;
}

}  // namespace limber
