#include <algorithm>
#include <functional>
#include <new>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "episode_path.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/large_file.hpp"
#include "limber/common/version.hpp"
#include "limber/data/recording_part.hpp"
#include "recording_hdf5.hpp"

namespace limber {

namespace {

constexpr hsize_t kChunkFrames = 1024;
constexpr std::uintmax_t kSpareBytes = std::uintmax_t{64} << 20U;  // structure, and other writers
constexpr int kDeflateLevel = 1;  // level 1 after shuffle: half the size at 4× level 6's speed

constexpr std::size_t kPartsPerOpenFile = 64;  // HDF5 keeps 30 kB for each until it closes the file

constexpr std::size_t kLongestAttribute = 64'000;  // bytes; HDF5 keeps 64 kB with name and type

/// Of fixed length: texts of variable length lie in a heap that HDF5 reads without any check, so
/// that a flipped bit in it makes it crash or hang.
H5::StrType text_type(const std::string& text) {
  H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(text.size(), 1));
  type.setStrpad(H5T_STR_NULLPAD);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

/// Without times of day, equal recordings are equal bytes.
template <class Properties>
Properties without_times(Properties properties) {
  H5Pset_obj_track_times(properties.getId(), false);
  return properties;
}

/// C++ has no way to say how a group is made.
H5::Group make_group(const H5::H5File& file, const std::string& path) {
  const H5::PropList how = without_times(H5::PropList(H5P_GROUP_CREATE));
  const hid_t made = H5Gcreate2(file.getId(), path.c_str(), H5P_DEFAULT, how.getId(), H5P_DEFAULT);
  if (made < 0) {
    throw H5::GroupIException("make_group", "H5Gcreate2 failed");
  }
  H5::Group group(made);
  H5Idec_ref(made);  // the group holds it
  return group;
}

void write_attribute(const H5::H5Object& object, const char* name, const std::string& text) {
  const H5::StrType type = text_type(text);
  object.createAttribute(name, type, H5::DataSpace()).write(type, text);
}

/// Data set properties: in chunks that are deflated, with checksums.
H5::DSetCreatPropList compressed(const Shape& chunk) {
  H5::DSetCreatPropList properties = without_times(H5::DSetCreatPropList());
  properties.setChunk(int(chunk.size()), chunk.data());
  properties.setShuffle();
  properties.setDeflate(kDeflateLevel);
  properties.setFletcher32();
  return properties;
}

/// An attribute of the file, or a data set of that name where the text is too long for one.
void write_text(const H5::H5File& file, const char* name, const std::string& text) {
  if (text.size() <= kLongestAttribute) {
    write_attribute(file, name, text);
    return;
  }
  const hsize_t one = 1;
  const H5::StrType type = text_type(text);
  file.createDataSet(name, type, H5::DataSpace(1, &one), compressed({one})).write(text, type);
}

template <class Value>
void write_number(const H5::H5Object& object, const char* name, const H5::PredType& type,
                  const Value& value) {
  object.createAttribute(name, type, H5::DataSpace()).write(type, &value);
}

void write_data_set(const H5::Group& group, const std::string& name, const char* unit,
                    const H5::PredType& type, const void* data, const Shape& shape) {
  Shape chunk = shape;
  const hsize_t per_frame =
      std::reduce(shape.begin() + 1, shape.end(), hsize_t{1}, std::multiplies{});
  chunk[0] = std::min({chunk[0], kChunkFrames, std::max(kMaxChunk / per_frame, hsize_t{1})});
  const H5::DataSpace space(int(shape.size()), shape.data());
  H5::DataSet data_set = group.createDataSet(name, type, space, compressed(chunk));
  data_set.write(data, type);
  write_attribute(data_set, "unit", unit);
}

void write_episode(const H5::Group& group, const Episode& episode, const Recording& recording) {
  const auto frames = static_cast<hsize_t>(episode.frame_count());
  const auto channels = static_cast<hsize_t>(recording.channel_count());
  const auto points = static_cast<hsize_t>(recording.point_count);
  const std::vector<std::uint8_t> tracked =
      episode.tracked.empty() ? std::vector<std::uint8_t>(frames, 1) : episode.tracked;
  const H5::PredType& real = H5::PredType::NATIVE_FLOAT;
  write_data_set(group, "time_s", "s", H5::PredType::NATIVE_DOUBLE, episode.time_s.data(),
                 {frames});
  const Command& command = recording.command;
  if (!episode.setpoints_only) {
    write_data_set(group, followed_key(command), command.unit.c_str(), real,
                   episode.pressure_kpa.data(), {frames, channels});
  }
  write_data_set(group, setpoint_name(command), command.unit.c_str(), real,
                 episode.setpoint_kpa.data(), {frames, channels});
  const bool in_space = recording.dimension == Dimension::space;
  write_data_set(group, "backbone", in_space ? kSpacePoseUnits : kPoseUnits, real,
                 episode.backbone.data(),
                 {frames, points, static_cast<hsize_t>(pose_size(recording.dimension))});
  write_data_set(group, "motion_index", "1", H5::PredType::NATIVE_INT, episode.motion_index.data(),
                 {frames});
  write_data_set(group, "tracked", "1", H5::PredType::NATIVE_UINT8, tracked.data(), {frames});
  for (const auto& [name, text] : {std::pair(kPhysics, &episode.physics), {kLog, &episode.log}}) {
    if (!text->empty()) {
      write_attribute(group, name, *text);
    }
  }
}

/// All but the episodes.
void write_header(const H5::H5File& file, const Recording& recording) {
  write_text(file, "schema", kRecordingSchema);
  write_text(file, "arm_name", recording.arm_name);
  write_text(file, "arm_hash", recording.arm_hash);
  if (!recording.arm_description.empty()) {
    write_text(file, "arm_description", recording.arm_description);
  }
  if (!recording.command.is_pressure_kpa()) {
    write_text(file, "command_name", recording.command.name);
    write_text(file, "command_unit", recording.command.unit);
  }
  if (recording.setpoints_only()) {
    write_text(file, kCommandsAre, commands_are(true));
  }
  write_text(file, "source", recording.source);
  write_text(file, "settings", recording.settings);
  write_text(file, "program_version", version());
  write_number(file, "rate_hz", H5::PredType::NATIVE_DOUBLE, recording.rate_hz);
  write_number(file, "segments", H5::PredType::NATIVE_INT, recording.segment_count);
  write_number(file, "points", H5::PredType::NATIVE_INT, recording.point_count);
  if (recording.dimension == Dimension::space) {
    write_number(file, kDimension, H5::PredType::NATIVE_INT, position_size(recording.dimension));
    write_number(file, kChambers, H5::PredType::NATIVE_INT, recording.chamber_count);
    write_text(file, kRotations, recording.lifted() ? kLifted : kMeasured);
  }
  write_number(file, "seed", H5::PredType::NATIVE_UINT64, recording.seed);
  make_group(file, "episodes");
}

/// @return the number of the next episode
std::size_t write_episodes(const H5::H5File& file, const Recording& recording, std::size_t first) {
  for (const Episode& episode : recording.episodes) {
    write_episode(make_group(file, episode_path(first++)), episode, recording);
  }
  return first;
}

/// HDF5 believes what a file says of its own structure, and crashes where that is damaged. In this
/// format every piece of it has a checksum.
void use_checksums(H5::FileAccPropList& access) {
  access.setLibverBounds(H5F_LIBVER_V110, H5F_LIBVER_V110);
  // No space is set aside: what HDF5 gives back as it closes the file would be left behind its end.
  H5Pset_meta_block_size(access.getId(), 0);
  H5Pset_small_data_block_size(access.getId(), 0);
}

/// Gives HDF5 the memory of a text to keep its file in. @return null where there is no more
void* resize_image(void* /*old*/, std::size_t size, H5FD_file_image_op_t /*why*/, void* image) {
  auto& bytes = *static_cast<std::string*>(image);
  try {
    bytes.resize(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  return bytes.data();
}

/// The whole file, made in memory, so that HDF5 never meets a full disk. After one it can neither
/// close its file nor end the process properly.
std::string file_image(const Recording& recording) {
  std::string image;
  H5FD_file_image_callbacks_t memory{};
  memory.image_realloc = resize_image;
  // The text outlives the file that is closed in it.
  memory.image_free = [](void*, H5FD_file_image_op_t, void*) -> herr_t { return 0; };
  memory.udata_copy = [](void* own) { return own; };
  memory.udata_free = [](void*) -> herr_t { return 0; };
  memory.udata = &image;
  H5::FileAccPropList in_memory;
  in_memory.setCore(kMemoryStep, false);
  if (H5Pset_file_image_callbacks(in_memory.getId(), &memory) < 0) {
    throw H5::FileIException("file_image", "H5Pset_file_image_callbacks failed");
  }
  use_checksums(in_memory);
  const auto how = without_times(H5::FileCreatPropList());
  H5::H5File file(kNoFile, H5F_ACC_TRUNC, how, in_memory);
  write_header(file, recording);
  write_episodes(file, recording, 0);
  file.flush(H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
  if (size <= 0) {
    throw H5::FileIException("file_image", "H5Fget_file_image failed");
  }
  file.close();
  image.resize(size);  // HDF5 took its memory by steps
  return image;
}

/// What recordings have in common that may be joined.
std::string origin_of(const Recording& recording) {
  return fmt::format("arm {} {}, {} segments, {} points{}, {} Hz, {} [{}], {}, {}",
                     recording.arm_name, recording.arm_hash, recording.segment_count,
                     recording.point_count, recording.lifted() ? " without rotations" : "",
                     recording.rate_hz, recording.command.name, recording.command.unit,
                     commands_are(recording.setpoints_only()), recording.source);
}

/// After a full disk HDF5 can't close its file, nor end the process: so it never meets one.
void require_space(const fs::path& folder, const std::vector<fs::path>& parts) {
  std::uintmax_t bytes = kSpareBytes;
  for (const fs::path& part : parts) {
    bytes += fs::file_size(part);
  }
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (!error && space.available < bytes) {
    throw SystemFault(fmt::format("{}: {} bytes are free; joining {} recordings takes {}",
                                  folder.string(), space.available, parts.size(), bytes));
  }
}

}  // namespace

void write_recording(const fs::path& path, const Recording& recording) {
  validate(recording, path.string());
  std::string image;
  {
    const Hdf5Section section;
    try {
      image = file_image(recording);
    } catch (const H5::Exception& error) {
      throw SystemFault(fmt::format("{}: can't be written: {} ({})", path.string(),
                                    error.getDetailMsg(), error.getFuncName()));
    }
  }
  write_file_atomically(path, image);
}

void join_recordings(const fs::path& path, const std::vector<fs::path>& parts, std::uint64_t seed) {
  make_file_atomically(path, [&](const fs::path& temporary) {
    require_space(temporary.parent_path(), parts);
    try {
      H5::FileAccPropList access;
      use_checksums(access);
      std::optional<H5::H5File> file;
      std::string origin;
      std::size_t episodes = 0;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const fs::path& part = parts[i];
        Recording recording = read_recording(part);
        const std::string own = origin_of(recording);
        if (!file) {
          origin = own;
          recording.seed = seed;
        } else if (own != origin) {
          throw InputError(
              fmt::format("{}: {}; {} is of {}: expected recordings of one arm, made in one way",
                          part.string(), own, parts.front().string(), origin));
        }
        const Hdf5Section section;
        if (!file) {
          file.emplace(temporary.string(), H5F_ACC_EXCL, without_times(H5::FileCreatPropList()),
                       access);
          write_header(*file, recording);
        } else if (i % kPartsPerOpenFile == 0) {
          file->close();
          file.emplace(temporary.string(), H5F_ACC_RDWR, H5::FileCreatPropList::DEFAULT, access);
        }
        episodes = write_episodes(*file, recording, episodes);
      }
      const Hdf5Section section;
      file->close();
    } catch (const H5::Exception& error) {
      throw SystemFault(fmt::format("{}: can't be written: {} ({})", path.string(),
                                    error.getDetailMsg(), error.getFuncName()));
    }
    sync_file(temporary);
  });
}

}  // namespace limber
