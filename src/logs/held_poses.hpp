#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "log_rows.hpp"

namespace limber {

/// In which rows a tracker hangs, and repeats its last pose at its usual rate. All plates are then
/// equal to the bit, as no measurement of a real arm is twice, while a command moves by more than
/// half of its range, and longer than any arm takes to answer. So an arm without noise that rests,
/// or waits for its valves, hangs in no row.
/// @param motion    and `commands` on one clock
/// @return one for each row of `motion`; false for the pose that is repeated
std::vector<bool> rows_that_hang(const BackboneTrack& motion, const CommandTrack& commands,
                                 const ArmDescription& arm);

}  // namespace limber
