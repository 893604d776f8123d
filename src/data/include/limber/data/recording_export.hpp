#pragma once
// For those who read or write recordings.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "limber/data/recording.hpp"

namespace limber {

/// The faults of real logs that logs written from a recording get.
struct LogExportSettings {
  double rate_hz = 0.0;  ///< of the motion log, between frames on straight lines; 0: as recorded
  double time_offset_s = 0.0;  ///< to be added to the pressure log's times to get the motion log's
  double noise_m = 0.0;        ///< standard deviation of each position coordinate
  double noise_rad = 0.0;      ///< of each heading, in space about each axis
  int occlusions = 0;          ///< in each episode: a plate is hidden, at a random time …
  double occlusion_s = 0.1;    ///< … for this long
  /// Motive: markers instead of rigid bodies, on each side of a plate, in space at its middle.
  bool markers = false;
  std::uint64_t seed = 1;  ///< of noise and occlusions; episode e samples from stream e

  static constexpr double kMaxRateHz = 2000.0;  ///< no tracker of points is faster by much
  static constexpr double kMaxOffsetS = 1e10;   ///< clocks from 1970 and from 0 are 2e9 s apart
  static constexpr int kMaxOcclusions = 10'000;
};

/// Writes each episode as one table, episode_000.csv … (time_s, pressures, set points, poses,
/// motion), and mapping.yaml, with which `limber import csv` reads them back. Frames that were not
/// tracked have empty pose cells. Rotations that were made from places have no columns. Folder and
/// files are made as needed.
/// @return the files, the mapping last. @throws InputError for settings out of range; SystemFault.
std::vector<std::filesystem::path> export_csv(const Recording& recording,
                                              const std::filesystem::path& folder);

/// Writes each episode as OptiTrack Motive's CSV (format 1.23, y up, metres, quaternions),
/// episode_000_motive.csv …, with its pressures on a clock of their own,
/// episode_000_pressures.csv …, and mapping.yaml, with which `limber import motive` reads them
/// back. In space poses stay in the arm's frame. @return the files, the mapping last.
std::vector<std::filesystem::path> export_motive(const Recording& recording,
                                                 const std::filesystem::path& folder,
                                                 const LogExportSettings& settings);

}  // namespace limber
