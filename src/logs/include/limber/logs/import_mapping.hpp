#pragma once
// For those who read or write recordings.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

/// A log's clock.
struct TimeColumn {
  std::string column = "time_s";  ///< empty: rows follow each other at a nominal rate
  double seconds_per_unit = 1.0;
  std::string unit = "s";  ///< as the mapping has it; "frame" with a rate

  bool operator==(const TimeColumn&) const = default;
};

/// Where a log holds commands: either `columns`, signed, or one column per side. In space there are
/// n channels in place of n segments, and no sides.
struct CommandColumns {
  TimeColumn time;
  /// True: `columns` and `setpoint` are those of the arm file's M `commands`, and are summed to
  /// those of its n segments (limber/arm/arm_commands.hpp).
  bool summed = false;
  std::vector<std::string> columns;  ///< n, or M; a '-' before a name turns its sign
  std::vector<std::string> right;    ///< n; the side that a positive pressure inflates
  std::vector<std::string> left;     ///< n
  /// False: nothing was measured; `columns`, or `right` and `left`, hold set points, and there is
  /// no `setpoint`. They are held from row to row and never interpolated.
  bool measured = true;
  std::vector<std::string> setpoint;  ///< as many as `columns`, or none
  bool setpoint_optional = false;     ///< left out if the log has no such columns
  std::string unit = "kPa";
  double factor = 1.0;  ///< to the arm's unit
  /// Added to what the log holds, in its own unit, after a column's '-': one for all columns, one
  /// for each, or none.
  std::vector<double> offsets;

  double offset_of(Eigen::Index column) const {
    return offsets.empty() ? 0.0 : offsets.size() == 1 ? offsets.front() : offsets[column];
  }
};

/// Where a log holds one point of the backbone. Generic CSV names columns; Motive a rigid body
/// (position and heading), a marker (position), or a marker on each side (middle and heading).
struct PointSource {
  int plate = 0;
  std::string x, y, theta;  ///< columns; a '-' before a name turns its sign; theta may be empty
  std::string body;
  std::string marker;
  std::string right, left;
  std::string z;                           ///< of an arm in space
  std::vector<std::string> rotation = {};  ///< of one: qx, qy, qz, qw; or Euler angles; or none
};

/// How frame B is found in the log's plane.
struct BaseAlignment {
  enum class Kind {
    base,      ///< the base point's place; its heading, or the tangent of the first two gaps
    straight,  ///< a time in which the arm lay straight gives direction and heading offsets
    fixed,     ///< `pose`
    none,      ///< the log is in frame B
  };
  Kind kind = Kind::base;
  double straight_from_s = 0.0;  ///< on the motion log's clock
  double straight_to_s = 0.0;
  Pose pose;
};

/// Turns about the axes named in `order`, each about the axis as the turns before left it
/// (intrinsic): the rotation is their product from left to right.
struct EulerAngles {
  std::string order;    ///< three of x, y and z; empty: rotations are quaternions
  double factor = 1.0;  ///< to radians
};

/// How frame B of an arm in space is found in the log's frame.
struct SpaceAlignment {
  enum class Kind {
    base,   ///< the base body's place and rotation; bodies' axes are limber's
    none,   ///< the log is in frame B, and so are bodies' axes
    given,  ///< what follows
  };
  Kind kind = Kind::base;
  std::optional<Eigen::Vector3d> position_m;  ///< of the base; none: where plate 0 is tracked
  std::optional<Eigen::Vector3d> x_axis;      ///< along the straight arm; none: from the rest
  std::optional<Eigen::Vector3d> y_axis;      ///< to its left; none: any perpendicular
  /// When the arm hung straight, on the motion log's clock: from and to. Bodies' rotations count
  /// from what they were then; without it, from the axes of the log.
  std::optional<Eigen::Vector2d> rest_s;
};

/// What is bridged in time, and marked as not tracked.
struct LongestGap {
  std::optional<double> given_s;  ///< none: by the steps of each log (docs/importing.md)
};

/// How a log becomes a recording of an arm (docs/importing.md, schema limber/import/1).
struct ImportMapping {
  char separator = ',';
  bool decimal_comma = false;
  int skip_lines = 0;                ///< before the header
  std::vector<std::string> columns;  ///< names, where the file has no header
  TimeColumn time;
  std::string recording;  ///< column whose texts tell recordings apart; may be empty
  std::string motion;     ///< column that numbers motions; may be empty
  CommandColumns commands;
  std::vector<PointSource> points;  ///< base first; empty: Motive's own order
  double length_factor = 1.0;       ///< of generic CSV, to metres
  std::string length_unit = "m";
  double angle_factor = 1.0;      ///< to radians
  std::string up = "y";           ///< Motive's axis out of the plane: x, y, z, -x, -y or -z
  bool headings_measured = true;  ///< false: from the tangent, whatever the log has
  BaseAlignment alignment;
  EulerAngles euler;               ///< of an arm in space
  SpaceAlignment space_alignment;  ///< of one, in place of `alignment`
  LongestGap longest_gap_s;        ///< of points and commands that are missing
};

/// Reads a mapping for `arm`. @throws InputError naming file, line and field.
ImportMapping read_import_mapping(const std::filesystem::path& path, const ArmDescription& arm);

/// The mapping if none is given: time_s, and pressure_0_kpa … (command_0 … for another command),
/// one per channel, with setpoint_0_kpa … if there are such columns. A log that has
/// setpoint_0_kpa … and no other holds set points only; so does one of command_0 … alone. Of an arm
/// with `commands`, their names, with setpoint_NAME … if there are such columns; a log without any
/// of them is one of segments' commands.
ImportMapping default_import_mapping(const ArmDescription& arm);

/// Default columns as a log has them: counted from 0, or from 1 if it has no column 0, as limber
/// wrote them before; with what it measured, or set points only. @param names  the log's columns
CommandColumns as_counted_in(const std::vector<std::string>& names, CommandColumns commands,
                             const ArmDescription& arm);

}  // namespace limber
