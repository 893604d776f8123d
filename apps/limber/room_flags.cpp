#include "room_flags.hpp"

#include "limber/planning/problem_check.hpp"

namespace limber {

void RoomFlags::add_to(CLI::App& app) {
  auto* margin =
      app.add_option("--margin-m", asked_.margin_m,
                     "Clearance kept from every obstacle; by default the model's tube, or its "
                     "largest error in 95 % of its unseen runs (limber inspect MODEL)")
          ->check(CLI::Range(0.0, kMaxMarginM));
  app.add_option("--tube", asked_.tube_level,
                 "Keep the tube free that held this share of runs, of those that limber calibrate "
                 "put into the model; by default 0.95, where the model carries one")
      ->check(CLI::Range(0.0, 1.0))
      ->excludes(margin);
  app.add_option("--goal-margin-m", asked_.goal_margin_m,
                 "How far inside the goal's rim plans end; by default the model's error at the "
                 "end of 95 % of those runs")
      ->check(CLI::Range(0.0, kMaxMarginM));
  app.add_option("--goal-margin-rad", asked_.goal_margin_rad,
                 "The same for the goal's heading, if it asks for one")
      ->check(CLI::Range(0.0, kMaxMarginM));
}

ErrorRoom RoomFlags::room(const ForwardModel& model, const CommonFlags& flags) const {
  ErrorRoom room = error_room(model, asked_);
  if (!room.note.empty()) {
    say(flags, "{}: {}", model.has_network() ? "note" : "warning", room.note);
  }
  return room;
}

}  // namespace limber
