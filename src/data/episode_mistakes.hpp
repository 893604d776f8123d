#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/data/simple_model.hpp"

namespace limber {

/// What would explain episodes that err more than the others: two of a log's columns exchanged, one
/// of the other sign, commands by another clock. For each episode a sentence, empty where nothing
/// of that explains it: "moves as if the columns of segment 0 and segment 2 were exchanged".
///
/// The simple model predicts the segments' turns under the commands as they are and as they would
/// be. A mistake is one that leaves less than kExplained of the error. On logs of stand-ins nothing
/// leaves less than 1.07 in whole ones, and the true mistake 0.10 to 0.56 in broken ones.
/// @param judged  one for each episode: whether it moves, or should
std::vector<std::string> likely_mistakes(const SimpleModel& model, const ArmDescription& arm,
                                         const std::vector<Episode>& episodes,
                                         const std::vector<bool>& judged);

}  // namespace limber
