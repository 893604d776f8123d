#pragma once

#include <iterator>
#include <string>

#include <Eigen/Core>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"

// What messages call an arm's parts, and what lies in a row. All of it is counted from 0, parts
// from the base, as in YAML paths and in JSON. Lines of text files alone are counted from 1, as
// editors count them.
namespace limber {

inline std::string segment_name(Eigen::Index segment) {
  return fmt::format("segment {}", segment);
}

/// The same where no arm says which segment's: "segment 1", or in space "chamber 4" of the arm.
inline std::string channel_name(Dimension dimension, Eigen::Index channel) {
  return dimension == Dimension::space ? fmt::format("chamber {}", channel) : segment_name(channel);
}

/// What a command moves: "segment 1", or of an arm in space "chamber 2 of segment 1".
inline std::string channel_name(const ArmDescription& arm, Eigen::Index channel) {
  if (!arm.is_spatial()) {
    return segment_name(channel);
  }
  Eigen::Index segment = 0;
  while (channel >= std::ssize(arm.segments[std::size_t(segment)].chambers)) {
    channel -= std::ssize(arm.segments[std::size_t(segment++)].chambers);
  }
  return fmt::format("chamber {} of {}", channel, segment_name(segment));
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

inline std::string frame_name(Eigen::Index frame) {
  return fmt::format("frame {}", frame);
}

/// Of a plan, or of a list of set points.
inline std::string waypoint_name(Eigen::Index waypoint) {
  return fmt::format("waypoint {}", waypoint);
}

inline std::string motion_name(Eigen::Index motion) {
  return fmt::format("motion {}", motion);
}

/// Of a recording.
/// @param log  that it was imported from; empty: of none
inline std::string episode_name(Eigen::Index episode, const std::string& log = {}) {
  return log.empty() ? fmt::format("episode {}", episode)
                     : fmt::format("episode {} ({})", episode, log);
}

/// Of a CSV file.
inline std::string column_name(Eigen::Index column) {
  return fmt::format("column {}", column);
}

/// Of an arm's mapping, a polygon or a bench test.
inline std::string point_name(Eigen::Index point) {
  return fmt::format("point {}", point);
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
