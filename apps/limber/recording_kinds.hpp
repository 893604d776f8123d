#pragma once

#include <span>
#include <string>

#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Recordings that are learnt from together: all of them measured pressures (or the arm's other
/// command), or all hold set points only.
class RecordingKinds {
 public:
  /// @throws InputError that names this file and the first one, if they are of different kinds.
  void add(const std::string& file, bool setpoints_only);
  /// Reads a recording of `arm` (require_recording_of) and adds it.
  /// @param leave_out_measured  takes its set points alone
  /// @param episodes  reads these alone (read_recording_part); none: all
  Recording read(const std::string& file, const ArmDescription& arm,
                 bool leave_out_measured = false, std::span<const int> episodes = {});

  bool setpoints_only() const { return setpoints_only_; }

 private:
  std::string first_;
  bool setpoints_only_ = false;
};

/// A recording as a network has to be asked with it: one that learnt from set points is given set
/// points, whatever was measured beside them.
/// @throws InputError where it learnt from what was measured, and nothing was.
Recording as_learnt_from(const CompensationModel& network, const std::string& model_file,
                         Recording recording, const std::string& file);

}  // namespace limber
