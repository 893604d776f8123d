#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/common/filesystem.hpp"

namespace limber {

/// Where the tip is to be over time, straight between the points. Times start at 0.
struct TipPath {
  std::vector<double> time_s;            ///< increasing, from 0
  std::vector<Eigen::Vector2d> point_m;  ///< in frame B, one for each time
  std::vector<std::size_t> line;         ///< of the file that each point came from
  int laps = 1;                          ///< how often it is run; more than one only if it closes

  double lap_s() const { return time_s.back(); }
  double duration_s() const { return laps * lap_s(); }
  /// File and line that it came from, for messages.
  std::string source_of(const std::string& file, std::size_t point) const;
  /// Of one lap.
  double length_m() const;
  /// Before the start the first point, after the end the last.
  Eigen::Vector2d at(double seconds) const;
  /// @throws InputError naming file and line of the first point that the arm is too short for.
  void require_within(double arm_length_m, const std::string& file) const;
  /// Whether it ends where it starts, to a millimetre.
  bool closes() const;
};

/// Reads a CSV file whose columns are time_s, x_m and y_m, in any order; others are refused. Times
/// may start anywhere, and are counted from the first.
/// @throws InputError naming file and line: a column missing, a number not finite, a time not later
/// than the one before or over an hour after the first, fewer than two points.
TipPath read_tip_path(const fs::path& path);

}  // namespace limber
