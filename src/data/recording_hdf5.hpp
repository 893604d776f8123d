#pragma once

// What the writer and the reader of recordings share. Only sources that include this, and
// hdf5_version.cpp, include HDF5.

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include <H5Cpp.h>

#include "limber/data/recording.hpp"

namespace limber {

/// Deflate makes data at most 1032 times smaller; what is smaller than this was never written.
inline constexpr std::uintmax_t kMaxCompression = 1100;

/// Numbers of a chunk: HDF5 holds whole ones in memory. Readers refuse larger ones.
inline constexpr hsize_t kMaxChunk = hsize_t{1} << 22U;

inline constexpr std::size_t kLongestText = std::size_t{1} << 26U;  // bytes of a recording's text

/// What `validate` says of names, sizes and rate: known before any episode is read.
void validate_header(const Recording& recording, const std::string& file);

inline constexpr const char* kRecordingSchema = "limber/recording/1";

/// Attribute that says what the commands are; a file without it holds measured ones.
inline constexpr const char* kCommandsAre = "commands_are";

/// Attributes of an episode, where it has a text there: Episode::physics, Episode::log.
inline constexpr const char* kPhysics = "physics";
inline constexpr const char* kLog = "log";

/// Attributes of recordings of arms in space: 3; columns of commands; and where rotations are from.
inline constexpr const char* kDimension = "dimension";
inline constexpr const char* kChambers = "chambers";
inline constexpr const char* kRotations = "rotations";
inline constexpr const char* kMeasured = "measured";
inline constexpr const char* kLifted = "lifted";

inline constexpr std::size_t kMemoryStep = std::size_t{1}
                                           << 20U;  ///< by which a file in memory grows
/// HDF5 wants a name and checks whether such a file exists; none can exist below a device.
inline constexpr const char* kNoFile = "/dev/null/recording";

inline constexpr const char* kPoseUnits = "m, m, rad";
inline constexpr const char* kSpacePoseUnits = "m, m, m, 1, 1, 1, 1";

/// One thread inside HDF5, its own error printing off (it would go to standard error).
class Hdf5Section {
 public:
  Hdf5Section() : lock_(mutex()) {
    H5Eget_auto2(H5E_DEFAULT, &print_, &client_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Section() { H5Eset_auto2(H5E_DEFAULT, print_, client_); }
  Hdf5Section(const Hdf5Section&) = delete;
  Hdf5Section& operator=(const Hdf5Section&) = delete;

  /// From now on its printing stays off: when the process ends, libhdf5 would complain once more of
  /// a damaged file, parts of which it never lets go.
  void stay_quiet() { print_ = nullptr; }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }

  std::lock_guard<std::mutex> lock_;
  H5E_auto2_t print_ = nullptr;
  void* client_ = nullptr;
};

using Shape = std::vector<hsize_t>;

/// Data set of what was asked for; that of what was measured is followed_key. Their names carry the
/// unit, if it is that of pressures; of another command, the attribute `unit` alone does.
inline std::string setpoint_name(const Command& command) {
  return command.is_pressure_kpa() ? "setpoint_kpa" : "command_setpoint";
}

}  // namespace limber
