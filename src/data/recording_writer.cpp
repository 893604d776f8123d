#include <algorithm>

#include <fmt/format.h>

#include "episode_path.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/version.hpp"
#include "recording_hdf5.hpp"

namespace limber {

namespace {

constexpr hsize_t kChunkFrames = 1024;
constexpr std::size_t kMemoryStep = std::size_t{1} << 20U;  // by which a file in memory grows
// HDF5 wants a name and checks whether such a file exists; none can exist below a device.
constexpr const char* kNoFile = "/dev/null/recording";
constexpr int kDeflateLevel = 1;  // level 1 after shuffle: half the size at 4× level 6's speed

constexpr std::size_t kLongestAttribute = 64'000;  // bytes; HDF5 keeps 64 kB with name and type

/// Of fixed length: texts of variable length lie in a heap that HDF5 reads without any check, so
/// that a flipped bit in it makes it crash or hang.
H5::StrType text_type(const std::string& text) {
  H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(text.size(), 1));
  type.setStrpad(H5T_STR_NULLPAD);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

void write_attribute(const H5::H5Object& object, const char* name, const std::string& text) {
  const H5::StrType type = text_type(text);
  object.createAttribute(name, type, H5::DataSpace()).write(type, text);
}

/// Data set properties: in chunks that are deflated, with checksums.
H5::DSetCreatPropList compressed(const Shape& chunk) {
  H5::DSetCreatPropList properties;
  properties.setChunk(static_cast<int>(chunk.size()), chunk.data());
  properties.setShuffle();
  properties.setDeflate(kDeflateLevel);
  properties.setFletcher32();
  // Without times of day, equal recordings are equal bytes.
  H5Pset_obj_track_times(properties.getId(), false);
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
  chunk[0] = std::min(chunk[0], kChunkFrames);
  const H5::DataSpace space(static_cast<int>(shape.size()), shape.data());
  H5::DataSet data_set = group.createDataSet(name, type, space, compressed(chunk));
  data_set.write(data, type);
  write_attribute(data_set, "unit", unit);
}

void write_episode(const H5::Group& group, const Episode& episode, const Recording& recording) {
  const auto frames = static_cast<hsize_t>(episode.frame_count());
  const auto segments = static_cast<hsize_t>(recording.segment_count);
  const auto points = static_cast<hsize_t>(recording.point_count);
  const std::vector<std::uint8_t> tracked =
      episode.tracked.empty() ? std::vector<std::uint8_t>(frames, 1) : episode.tracked;
  const H5::PredType& real = H5::PredType::NATIVE_FLOAT;
  write_data_set(group, "time_s", "s", H5::PredType::NATIVE_DOUBLE, episode.time_s.data(),
                 {frames});
  const Command& command = recording.command;
  if (!episode.setpoints_only) {
    write_data_set(group, measured_name(command), command.unit.c_str(), real,
                   episode.pressure_kpa.data(), {frames, segments});
  }
  write_data_set(group, setpoint_name(command), command.unit.c_str(), real,
                 episode.setpoint_kpa.data(), {frames, segments});
  write_data_set(group, "backbone", "m, m, rad", real, episode.backbone.data(),
                 {frames, points, kPoseSize});
  write_data_set(group, "motion_index", "1", H5::PredType::NATIVE_INT, episode.motion_index.data(),
                 {frames});
  write_data_set(group, "tracked", "1", H5::PredType::NATIVE_UINT8, tracked.data(), {frames});
  if (!episode.physics.empty()) {
    write_attribute(group, kPhysics, episode.physics);
  }
}

/// The whole file, made in memory, so that HDF5 never meets a full disk. After one it can neither
/// close its file nor end the process properly.
std::string file_image(const Recording& recording) {
  H5::FileAccPropList in_memory;
  in_memory.setCore(kMemoryStep, false);
  H5::H5File file(kNoFile, H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
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
  write_number(file, "seed", H5::PredType::NATIVE_UINT64, recording.seed);
  file.createGroup("episodes");
  for (std::size_t i = 0; i < recording.episodes.size(); ++i) {
    write_episode(file.createGroup(episode_path(i)), recording.episodes[i], recording);
  }
  file.flush(H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
  std::string image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  if (size <= 0 || H5Fget_file_image(file.getId(), image.data(), image.size()) != size) {
    throw H5::FileIException("file_image", "H5Fget_file_image failed");
  }
  file.close();
  return image;
}

}  // namespace

void write_recording(const std::filesystem::path& path, const Recording& recording) {
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

}  // namespace limber
