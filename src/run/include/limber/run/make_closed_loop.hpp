#pragma once
// For those who have plans corrected while they are executed.

#include <cstdint>
#include <memory>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/controller.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// The closed loop, for ExecutionSettings::controller: plans again from where the arm is measured,
/// while it moves and after (docs/planning.md, Closed loop). A search takes 2000 queries while the
/// arm moves, 20 000 when it stands. Without tracking the run is open loop. Borrows arm,
/// environment and what the model borrows. One run. Threads: as Controller.
/// @throws InputError if the model has no network
std::unique_ptr<Controller> make_closed_loop(const ArmDescription& arm, const MotionModel& model,
                                             const Environment& environment, const ErrorRoom& room,
                                             std::uint64_t seed);

}  // namespace limber
