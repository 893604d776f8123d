#pragma once
// For those who read or write recordings.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

class NoLoadModel;

/// Frames × columns, a frame's numbers contiguous: the layout of the file and of the network's
/// inputs.
using FrameMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The shape of one frame (m×3) in `backbones` (T×3m), borrowed.
inline Eigen::Map<const Backbone> backbone_at(const FrameMatrix& backbones, Eigen::Index frame) {
  return {backbones.row(frame).data(), backbones.cols() / kPoseSize, kPoseSize};
}

/// Where its plates are (m×2, in space m×3), borrowed; in space `backbones` is T×7m.
using Places = Eigen::Map<const FrameMatrix, Eigen::Unaligned, Eigen::OuterStride<>>;
inline Places places_at(const FrameMatrix& backbones, Eigen::Index frame, Dimension dimension) {
  const int size = pose_size(dimension);
  return {backbones.row(frame).data(), backbones.cols() / size, position_size(dimension),
          Eigen::OuterStride<>(size)};
}

/// One unbroken run of the arm at its frame rate: T frames, n channels (in the plane: segments), m
/// backbone points.
struct Episode {
  Eigen::VectorXd time_s;    ///< T, strictly increasing
  FrameMatrix pressure_kpa;  ///< T×n, measured, gauge, signed; or see `setpoints_only`
  FrameMatrix setpoint_kpa;  ///< T×n, what was commanded
  FrameMatrix
      backbone;  ///< T×3m, poses (x_m, y_m, theta_rad) of the points, base first, θ unwrapped;
                 ///< of an arm in space T×7m, (x_m, y_m, z_m, qx, qy, qz, qw)
  std::vector<int> motion_index;  ///< T, number of the commanded motion a frame belongs to, from 0

  /// T, 1 if the backbone was tracked, 0 if it was not and is filled in between its tracked
  /// neighbours; empty: all were tracked. `read_recording` never leaves it empty.
  std::vector<std::uint8_t> tracked;

  /// Nothing was measured: `pressure_kpa` holds the set points. Whoever learns from such an episode
  /// learns what the arm does under set points, its valves included.
  bool setpoints_only = false;

  Dimension dimension = Dimension::plane;
  /// In space: rotations were made from positions (docs/space.md). No error is measured of them.
  bool lifted = false;

  /// JSON of what a virtual arm that was varied has other than its file; empty: nothing was. Those
  /// who want to know read it; no network ever does.
  std::string physics;

  /// File name of the log that it was imported from; empty: of none. Messages name it.
  std::string log;

  int frame_count() const { return int(time_s.size()); }
  /// m.
  int point_count() const { return int(backbone.cols()) / pose_size(dimension); }
  int untracked_count() const;
  /// Whether the backbone of frame `t` was tracked. @pre 0 ≤ t < frame_count()
  bool was_tracked(int t) const { return tracked.empty() || tracked[t] != 0; }
  /// Where a plate is in frame `t`; in the plane z is 0.
  Eigen::Vector3d position_m(Eigen::Index t, Eigen::Index plate) const;
  /// The first tracked frame at or after `t` and before `end`; `end` if there is none. @pre end ≤
  /// frame_count()
  int next_tracked(int t, int end) const {
    while (t < end && !was_tracked(t)) {
      ++t;
    }
    return t;
  }
};

/// Recorded motion of an arm (docs/formats.md, schema limber/recording/1).
struct Recording {
  std::string arm_name;
  std::string arm_hash;
  std::string arm_description;  ///< arm_keys_to_yaml(); empty in files of before it was kept
  Command command;              ///< what the numbers named pressure and set point are
  Dimension dimension = Dimension::plane;
  int segment_count = 0;
  int chamber_count = 0;  ///< of an arm in space: a command each; else 0
  int point_count = 0;
  double rate_hz = 0.0;
  std::uint64_t seed = 0;
  std::string source;           ///< "virtual arm", "motive log.csv", …
  std::string settings;         ///< how it was collected: schedule, holds, noise; may be empty
  std::string program_version;  ///< of the program that wrote it; `write_recording` fills it in
  std::vector<Episode> episodes;
  std::vector<int> numbers = {};  ///< of the episodes in the file; empty: all are there

  /// What messages call an episode by.
  std::size_t number(std::size_t episode) const {
    return numbers.empty() ? episode : std::size_t(numbers[episode]);
  }
  /// Columns of commands.
  int channel_count() const {
    return dimension == Dimension::space ? chamber_count : segment_count;
  }
  bool lifted() const { return !episodes.empty() && episodes.front().lifted; }
  /// Whose arm this is (arm/arm_identity.hpp).
  ArmIdentity arm() const { return {arm_name, arm_hash, arm_description}; }
  /// Whether nothing was measured (Episode::setpoints_only): true of all episodes or of none.
  bool setpoints_only() const { return !episodes.empty() && episodes.front().setpoints_only; }
  std::int64_t frame_count() const;
  std::int64_t untracked_count() const;
  /// Sum over episodes of frames / rate.
  double duration_s() const;
};

/// An empty recording of `arm`: name, hash, sizes and rate filled in.
Recording make_recording(const ArmDescription& arm, const std::string& source, std::uint64_t seed);

/// The same motions with what was measured left out: set points alone.
std::vector<Episode> with_setpoints_only(std::vector<Episode> episodes);

/// Refuses a recording that has no episode or frame, whose sizes disagree, whose times do not
/// increase, that holds a number that is not finite, or whose episodes were partly measured and
/// partly not.
/// @throws InputError naming `file`, the episode and the data set, what was found and is allowed.
void validate(const Recording& recording, const std::string& file);

/// Writes atomically, after `validate`. Threads: any; HDF5 itself is entered by one at a time.
/// @throws InputError as `validate`; SystemFault if the disk refuses.
void write_recording(const std::filesystem::path& path, const Recording& recording);

/// Reads, in a child process that can do nothing else (SECURITY.md), and validates. Threads: any.
/// @throws InputError naming the file, the episode and the data set or attribute, what was found
/// and what is allowed: also where the file is no HDF5, damaged or cut short.
Recording read_recording(const std::filesystem::path& path);

/// @throws InputError if the recording's segments, points, rate or command are not the arm's.
void require_sizes_of(const Recording& recording, const ArmDescription& arm,
                      const std::string& file);

/// Requires what training and evaluation need. @throws InputError as `require_sizes_of`; if it is
/// another arm by its name and by its keys (why_another_arm; one alone may differ, because a
/// recording outlives small edits of the arm file); if commands lie far beyond the arm's limits; if
/// nothing was ever tracked; if the plates' distances are not the arm's or its end stands still
/// while commands change.
void require_recording_of(const Recording& recording, const ArmDescription& arm,
                          const std::string& file);

/// What every function asks first that is given an arm, or a model of one, and episodes: the arm's
/// sizes, what `validate` asks of an episode, and numbers in its units. Commands and the plates'
/// distances are less than ten times off the arm's, so that broken logs pass but millimetres and Pa
/// do not, and no tracked plate is where no arm gets. require_recording_of is stricter.
/// @param where  stands for the recordings' file in messages
/// @throws InputError naming the episode, what was found and is allowed.
void require_episodes_of(const std::vector<Episode>& episodes, const ArmDescription& arm,
                         const std::string& where = "the recording");
void require_episodes_of(const std::vector<Episode>& episodes, const NoLoadModel& model,
                         const std::string& where = "the recording");

/// The same where no arm is given: frames of equal sizes, of finite numbers, at increasing times.
/// @param channel_count,point_count  expected of each; 0: those of the first
void require_alike(const std::vector<Episode>& episodes, int channel_count = 0, int point_count = 0,
                   const std::string& where = "the recording");

}  // namespace limber
