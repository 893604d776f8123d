#include "recording_kinds.hpp"

#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/data/recording_part.hpp"

namespace limber {

namespace {

const char* kind(bool setpoints_only) {
  return setpoints_only ? "set points only" : "what was measured";
}

}  // namespace

void RecordingKinds::add(const std::string& file, bool setpoints_only) {
  if (first_.empty()) {
    first_ = file;
    setpoints_only_ = setpoints_only;
  } else if (setpoints_only != setpoints_only_) {
    throw InputError(
        fmt::format("{}: {}; {}: {}. What is learnt from the one is wrong of the other: give "
                    "files of one kind. 'limber train --setpoints' leaves out what was measured",
                    first_, kind(setpoints_only_), file, kind(setpoints_only)));
  }
}

Recording RecordingKinds::read(const std::string& file, const ArmDescription& arm,
                               bool leave_out_measured, std::span<const int> episodes) {
  Recording recording =
      episodes.empty() ? read_recording(file) : read_recording_part(file, episodes);
  require_recording_of(recording, arm, file);
  if (leave_out_measured) {
    recording.episodes = with_setpoints_only(std::move(recording.episodes));
  }
  add(file, recording.setpoints_only());
  return recording;
}

Recording as_learnt_from(const CompensationModel& network, const std::string& model_file,
                         Recording recording, const std::string& file) {
  if (network.learnt_from_setpoints && !recording.setpoints_only()) {
    recording.episodes = with_setpoints_only(std::move(recording.episodes));
  } else if (!network.learnt_from_setpoints && recording.setpoints_only()) {
    throw InputError(fmt::format(
        "{}: holds set points only; {} learnt from measured {}s and can't be asked without them. "
        "Train a network on recordings of set points (limber train --setpoints)",
        file, model_file, recording.command.name));
  }
  return recording;
}

}  // namespace limber
