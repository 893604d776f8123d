#pragma once

#include <algorithm>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// @throws SystemFault if a state has other sizes than the arm, or a number that is not finite: a
/// driver's fault.
void require_state_of(const ArmDescription& arm, const ArmState& state);

/// Collects the frames of one run into an Episode whose time starts at 0. If a frame came without a
/// backbone (lost, occluded), its backbone is filled in on the straight line between the tracked
/// frames before and after it (at the ends: the nearest), and marked in `Episode::tracked`. So
/// windows stay unbroken, and the backbone is not taken for a measurement. A sample that a driver
/// sends again, as it has no newer one, is such a frame too, and its time is filled in likewise. In
/// space the signs of quaternions go on from one tracked frame to the next.
class EpisodeRecorder {
 public:
  explicit EpisodeRecorder(const ArmDescription& arm) : arm_(arm) {}

  /// @return whether the arm was seen in that frame
  /// @throws SystemFault as require_state_of: such a state is kept out of the recording.
  bool add(const ArmState& state, const Pressures& setpoint_kpa, int motion_index);

  int frame_count() const { return int(time_s_.size()); }
  /// Frames that had a backbone.
  int tracked_count() const { return int(std::count(tracked_.begin(), tracked_.end(), 1)); }

  /// The episode; the recorder is empty afterwards. @throws SystemFault if no frame had a
  /// backbone.
  Episode finish();

 private:
  std::vector<double> sample_times() const;

  ArmDescription arm_;
  std::vector<double> time_s_;  // of samples; a repeated one has the same
  std::vector<float> pressure_kpa_;
  std::vector<float> setpoint_kpa_;
  std::vector<float> backbone_;
  std::vector<int> motion_index_;
  std::vector<std::uint8_t> tracked_;
};

/// Makes the quaternions of filled rows unit again: `poses` in space, T×7m. Rows that were tracked
/// stay as they are.
void normalise_filled_rotations(const std::vector<std::uint8_t>& tracked, FrameMatrix& poses);

/// Fills the rows of `values` whose `tracked` is 0: linearly between the tracked rows around them,
/// with the nearest at the ends. @pre one row is tracked.
void fill_missing_rows(const std::vector<double>& time_s, const std::vector<std::uint8_t>& tracked,
                       FrameMatrix& values);

}  // namespace limber
