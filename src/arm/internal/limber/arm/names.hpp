#pragma once

#include <string>

#include <Eigen/Core>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"

// What messages call an arm's parts. All of them are counted from 0 at the base, as in YAML paths,
// in JSON and in the columns of CSV files.
namespace limber {

inline std::string segment_name(Eigen::Index segment) {
  return fmt::format("segment {}", segment);
}

inline std::string plate_name(Eigen::Index plate) {
  return fmt::format("plate {}", plate);
}

/// "plates 3 and 4", on both sides of a gap.
inline std::string plates_of_gap(Eigen::Index gap) {
  return fmt::format("plates {} and {}", gap, gap + 1);
}

/// "between plates 3 and 4 (segment 0)".
inline std::string gap_name(const ArmDescription& arm, int gap) {
  return fmt::format("between {} ({})", plates_of_gap(gap), segment_name(arm.segment_of_gap(gap)));
}

// What files and JSON call a quantity that is a pressure where the arm is driven by pressures.

/// "cost_kpa" of pressures; of any other command "cost", in the command's unit.
inline std::string quantity_key(const Command& command, const std::string& stem) {
  return command.is_pressure_kpa() ? stem + "_kpa" : stem;
}

/// The commands as they were followed, or are predicted to be: "pressure" or "command".
inline std::string followed_name(const Command& command) {
  return command.is_pressure_kpa() ? "pressure" : "command";
}

/// "pressure_kpa" or "command".
inline std::string followed_key(const Command& command) {
  return quantity_key(command, followed_name(command));
}

/// What a recording holds and a network has learnt from, as files and JSON have it: pressures (or
/// another command) as they were measured, or set points alone.
inline const char* commands_are(bool setpoints_only) {
  return setpoints_only ? "setpoints" : "measured";
}

/// A segment's column in CSV files: "setpoint_0_kpa", or "setpoint_0".
inline std::string quantity_column(const Command& command, const std::string& what, int segment) {
  return quantity_key(command, fmt::format("{}_{}", what, segment));
}

}  // namespace limber
