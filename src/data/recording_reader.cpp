#include <optional>
#include <span>

#include <fmt/format.h>

#include "checked_hdf5.hpp"
#include "confined_child.hpp"
#include "episode_path.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/recording_part.hpp"
#include "recording_pipe.hpp"

namespace limber {

namespace {

/// What is read of a file.
struct Wanted {
  bool outline = false;
  std::optional<std::span<const int>> episodes = {};  ///< none: all
};

/// One recording file; every refusal names it.
class Reader : private CheckedHdf5 {
 public:
  using CheckedHdf5::CheckedHdf5;

  /// All but the episodes.
  Recording read_header(const Wanted& wanted) {
    Recording recording;
    require_schema();
    recording.arm_name = text("arm_name");
    recording.arm_hash = text("arm_hash");
    recording.arm_description = text_if_there("arm_description");
    if (file_.attrExists("command_unit")) {
      recording.command = {text("command_name"), text("command_unit")};
    }
    recording.source = text("source");
    recording.settings = text_if_there("settings");
    recording.program_version = text("program_version");
    recording.rate_hz = number<double>("rate_hz", H5::PredType::NATIVE_DOUBLE);
    recording.segment_count = number<int>("segments", H5::PredType::NATIVE_INT);
    recording.point_count = number<int>("points", H5::PredType::NATIVE_INT);
    recording.seed = number<std::uint64_t>("seed", H5::PredType::NATIVE_UINT64);
    lifted_ = read_space(recording);
    validate_header(recording, name_);  // sizes decide what the data sets must hold
    setpoints_only_ = file_.attrExists(kCommandsAre) &&
                      is_second(kCommandsAre, commands_are(false), commands_are(true));
    if (wanted.episodes) {
      recording.numbers.assign(wanted.episodes->begin(), wanted.episodes->end());
    }
    return recording;
  }

  std::size_t count(const Wanted& wanted) const {
    return wanted.episodes ? wanted.episodes->size() : episode_count();
  }

  /// The i-th of those wanted.
  Episode read_episode(const Recording& recording, const Wanted& wanted, std::size_t i) const {
    const std::string group = episode_path(recording.number(i));
    if (wanted.episodes) {
      require_group(group, "no such episode");
    }
    Episode episode;
    episode.setpoints_only = setpoints_only_;
    episode.dimension = recording.dimension;
    episode.lifted = lifted_;
    read_outline(group, episode);
    if (!wanted.outline) {
      read_frames(group, recording, episode);
    }
    return episode;
  }

 private:
  void require_schema() const {
    if (!file_.attrExists("schema")) {
      refuse("attribute 'schema'",
             fmt::format("missing; this program reads '{}'", kRecordingSchema));
    }
    const std::string schema = text("schema");
    if (schema != kRecordingSchema) {
      refuse("attribute 'schema'",
             fmt::format("'{}' found; this program reads '{}'", schema, kRecordingSchema));
    }
  }

  /// What recordings of arms in space say of themselves. Whether rotations were made of positions.
  bool read_space(Recording& recording) const {
    if (!file_.attrExists(kDimension)) {
      return false;
    }
    const int dimension = number<int>(kDimension, H5::PredType::NATIVE_INT);
    if (dimension != position_size(Dimension::space)) {
      refuse(fmt::format("attribute '{}'", kDimension),
             fmt::format("{} found; expected 3, or no such attribute", dimension));
    }
    recording.dimension = Dimension::space;
    recording.chamber_count = number<int>(kChambers, H5::PredType::NATIVE_INT);
    return is_second(kRotations, kMeasured, kLifted);
  }

  /// Which of two words a text is. @throws InputError if it is neither
  bool is_second(const char* name, const char* first, const char* second) const {
    const std::string found = text(name);
    if (found != first && found != second) {
      refuse(fmt::format("attribute '{}'", name),
             fmt::format("'{}' found; expected '{}' or '{}'", found, first, second));
    }
    return found == second;
  }

  void require_group(const std::string& path, const std::string& missing) const {
    if (!exists(path)) {
      refuse(path, missing);
    }
    if (file_.childObjType(path) != H5O_TYPE_GROUP) {
      refuse(path, "not a group; expected an episode");
    }
  }

  hsize_t episode_count() const {
    if (!exists("episodes") || file_.childObjType("episodes") != H5O_TYPE_GROUP) {
      refuse("episodes", "group missing");
    }
    const H5::Group group = file_.openGroup("episodes");
    const hsize_t count = group.getNumObjs();
    for (hsize_t i = 0; i < count; ++i) {
      require_group(episode_path(i),
                    fmt::format("missing; 'episodes' holds {} entries, expected to "
                                "be named 000000, 000001, …",
                                count));
    }
    return count;
  }

  /// Times and texts.
  void read_outline(const std::string& group, Episode& episode) const {
    const std::string time_path = group + "/time_s";
    const H5::DataSet times = data_set(time_path, {0}, "one time a frame", "s");
    const auto frames = static_cast<hsize_t>(times.getSpace().getSimpleExtentNpoints());
    if (frames == 0) {
      refuse(time_path, "no frames; expected at least one");
    }
    episode.time_s.resize(Eigen::Index(frames));
    read_into(time_path, times, episode.time_s.data(), H5::PredType::NATIVE_DOUBLE);
    for (const auto& [name, text] : {std::pair(kPhysics, &episode.physics), {kLog, &episode.log}}) {
      if (const H5::Group own = file_.openGroup(group); own.attrExists(name)) {
        *text = text_in(own.openAttribute(name), fmt::format("{}, attribute '{}'", group, name));
      }
    }
  }

  /// All else of an episode whose times are known.
  void read_frames(const std::string& group, const Recording& recording, Episode& episode) const {
    const auto frames = static_cast<hsize_t>(episode.time_s.size());
    const bool setpoints_only = episode.setpoints_only;
    const auto n = static_cast<hsize_t>(recording.channel_count());
    const auto m = static_cast<hsize_t>(recording.point_count);
    const std::string pressures = fmt::format(
        "{} × {}: frames × {}", frames, n, recording.chamber_count > 0 ? "chambers" : "segments");
    const Command& command = recording.command;
    const auto commands = [&](const std::string& name) {
      return matrix(group + "/" + name, {frames, n}, pressures, command.unit.c_str());
    };
    episode.setpoint_kpa = commands(setpoint_name(command));
    const std::string measured = group + "/" + followed_key(command);
    const bool is_there = exists(measured);
    if (setpoints_only && is_there) {
      refuse(measured, fmt::format("found, though the attribute '{}' says '{}': nothing was "
                                   "measured; remove one of them",
                                   kCommandsAre, commands_are(true)));
    }
    if (!setpoints_only && !is_there) {
      refuse(measured, fmt::format("data set missing; expected {}. Where nothing was measured, the "
                                   "attribute '{}' of the file says '{}'",
                                   pressures, kCommandsAre, commands_are(true)));
    }
    episode.pressure_kpa = setpoints_only ? episode.setpoint_kpa : commands(followed_key(command));
    const bool in_space = recording.dimension == Dimension::space;
    const int size = pose_size(recording.dimension);
    episode.backbone =
        matrix(group + "/backbone", {frames, m, static_cast<hsize_t>(size)},
               fmt::format("{} × {} × {}: frames × points × {}", frames, m, size,
                           in_space ? "[x_m, y_m, z_m, qx, qy, qz, qw]" : "[x_m, y_m, theta_rad]"),
               in_space ? kSpacePoseUnits : kPoseUnits);
    if (in_space) {
      make_signs_continuous(episode.backbone);
    }
    const std::string each = fmt::format("{}: one per frame", frames);
    const std::string motion_path = group + "/motion_index";
    episode.motion_index.resize(frames);
    read_into(motion_path, data_set(motion_path, {frames}, each.c_str(), "1"),
              episode.motion_index.data(), H5::PredType::NATIVE_INT);
    const std::string tracked_path = group + "/tracked";
    episode.tracked.assign(frames, 1);
    if (exists(tracked_path)) {
      read_into(tracked_path, data_set(tracked_path, {frames}, each.c_str(), "1"),
                episode.tracked.data(), H5::PredType::NATIVE_UINT8);
    }
  }

  bool lifted_ = false;
  bool setpoints_only_ = false;
};

/// Reads what is wanted and hands it on: the header, then an episode after the other.
template <class TakeHeader, class TakeEpisode>
void read(const MappedFile& file, const Wanted& wanted, const TakeHeader& take_header,
          const TakeEpisode& take_episode) {
  try {
    Reader reader(file);
    Recording recording = reader.read_header(wanted);
    take_header(recording);
    const std::size_t count = reader.count(wanted);
    for (std::size_t i = 0; i < count; ++i) {
      Episode episode = reader.read_episode(recording, wanted, i);
      take_episode(episode);
    }
  } catch (const H5::Exception&) {
    throw InputError(fmt::format(
        "{}: can't be read: damaged or cut short; expected a whole recording", file.name()));
  }
}

#ifdef LIMBER_READ_IN_PROCESS  // sanitizers and coverage see one process

Recording read(const MappedFile& file, const Wanted& wanted) {
  Hdf5Section section;
  Recording recording;
  try {
    read(
        file, wanted, [&](const Recording& header) { recording = header; },
        [&](Episode& episode) { recording.episodes.push_back(std::move(episode)); });
  } catch (const InputError&) {
    section.stay_quiet();
    throw;
  }
  return recording;
}

#else

/// What comes next through the pipe.
enum class Next : std::uint8_t { header, episode, end, refusal };

/// In the child.
void send(const MappedFile& file, const Wanted& wanted, int pipe) {
  PipeWriter out(pipe);
  const auto announce = [&](Next next) { out.bytes(&next, sizeof next); };
  try {
    H5PLset_loading_state(0);  // no filter comes from a file
    read(
        file, wanted,
        [&](Recording& header) {
          announce(Next::header);
          pass_header(out, header);
        },
        [&](Episode& episode) {
          announce(Next::episode);
          pass(out, episode);
        });
    announce(Next::end);
  } catch (const InputError& error) {
    std::string message = error.what();
    announce(Next::refusal);
    pass(out, message);
  }
  out.flush();
}

/// Here.
Recording receive(PipeReader& in) {
  Recording recording;
  while (true) {
    Next next{};
    in.bytes(&next, sizeof next);
    if (next == Next::header) {
      pass_header(in, recording);
    } else if (next == Next::episode) {
      pass(in, recording.episodes.emplace_back());
    } else if (next == Next::end) {
      return recording;
    } else {
      std::string message;
      pass(in, message);
      throw InputError(message);
    }
  }
}

/// libhdf5 reads hostile files at its own risk: in a child that can do nothing else.
Recording read(const MappedFile& file, const Wanted& wanted) {
  constexpr std::uintmax_t kMegabyte = std::uintmax_t{1} << 20U;
  // Room for an episode, and HDF5's own; whole recordings are some three times their file.
  ChildLimits limits;
  limits.memory_bytes = 2048 * kMegabyte + 32 * file.size();
  limits.cpu_s = static_cast<unsigned>(20 + file.size() / (4 * kMegabyte));
  const std::uintmax_t most = 2 * kLongestText + kMaxCompression * file.size();
  // The child begins where no other thread is in HDF5; what it reads may come side by side.
  std::optional<Hdf5Section> section(std::in_place);
  Recording recording;
  run_confined(
      file.name(), limits, [&](int pipe) { send(file, wanted, pipe); },
      [&](int pipe) {
        section.reset();
        PipeReader in(file.name(), pipe, most, int(4000 * limits.cpu_s));
        recording = receive(in);
      });
  if (wanted.episodes) {
    recording.numbers.assign(wanted.episodes->begin(), wanted.episodes->end());
  }
  return recording;
}

#endif

Recording read_wanted(const fs::path& path, const Wanted& wanted) {
  std::error_code error;
  refuse_if(!fs::exists(path, error), "{}: no such file; expected a recording", path.string());
  refuse_if(fs::is_directory(path, error), "{}: is a folder; expected a recording file",
            path.string());
  Recording recording;
  try {
    recording = read(MappedFile(path), wanted);
  } catch (const InputError&) {
    // Tells a failing disk from a damaged file; HDF5 does not.
    read_blocks(path, [](std::string_view) {});
    throw;
  }
  if (!wanted.outline || recording.episodes.empty()) {
    validate(recording, path.string());
  }
  return recording;
}

}  // namespace

Recording read_recording(const fs::path& path) {
  return read_wanted(path, {});
}

Recording read_recording_outline(const fs::path& path) {
  return read_wanted(path, {true});
}

Recording read_recording_part(const fs::path& path, std::span<const int> episodes) {
  return read_wanted(path, {false, episodes});
}

}  // namespace limber
