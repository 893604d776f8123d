#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// Frames × columns, a frame's numbers contiguous: the layout of the file and of the network's
/// inputs.
using FrameMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One unbroken run of the arm at its frame rate: T frames, n segments, m backbone points.
struct Episode {
  Eigen::VectorXd time_s;    ///< T, strictly increasing
  FrameMatrix pressure_kpa;  ///< T×n, measured, gauge, signed
  FrameMatrix setpoint_kpa;  ///< T×n, what was commanded
  FrameMatrix
      backbone;  ///< T×3m, poses (x_m, y_m, theta_rad) of the points, base first, θ unwrapped
  std::vector<int> motion_index;  ///< T, number of the commanded motion a frame belongs to, from 0

  int frame_count() const { return static_cast<int>(time_s.size()); }
};

/// Recorded motion of an arm (docs/formats.md, schema limber/recording/1).
struct Recording {
  std::string arm_name;
  std::string arm_hash;
  int segment_count = 0;
  int point_count = 0;
  double rate_hz = 0.0;
  std::uint64_t seed = 0;
  std::string source;           ///< "virtual arm", "motive log.csv", …
  std::string program_version;  ///< of the program that wrote it
  std::vector<Episode> episodes;

  std::int64_t frame_count() const;
  double duration_s() const;
};

/// Writes atomically. @throws SystemFault where the disk refuses.
void write_recording(const std::filesystem::path& path, const Recording& recording);

/// Reads and validates: shapes agree, times increase, everything is finite.
/// @throws InputError naming the file, the episode and the data set.
Recording read_recording(const std::filesystem::path& path);

/// @throws InputError where the recording's segments, points or rate are not the arm's.
void require_recording_of(const Recording& recording, const ArmDescription& arm,
                          const std::string& file);

}  // namespace limber
