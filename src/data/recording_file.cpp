// The HDF5 side of recordings; the only source that includes HDF5.
#include <mutex>
#include <optional>
#include <set>

#include <H5Cpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/version.hpp"
#include "limber/data/episode_path.hpp"
#include "limber/data/recording.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/recording/1";
constexpr hsize_t kChunkFrames = 1024;
constexpr int kDeflateLevel = 1;  // level 1 after shuffle: half the size at 4× level 6's speed
constexpr hsize_t kLargestCount = 1U << 28;  // frames of an episode; above it, the file is damaged

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

/// Data sets of what was measured and of what was asked for: their names carry the unit, if it is
/// that of pressures; of another command, the attribute `unit` alone does.
const char* measured_name(const Command& command) {
  return command.is_pressure_kpa() ? "pressure_kpa" : "command";
}
const char* setpoint_name(const Command& command) {
  return command.is_pressure_kpa() ? "setpoint_kpa" : "command_setpoint";
}

std::string text_of(const Shape& shape) {
  return shape.empty() ? "a single value" : fmt::format("{}", fmt::join(shape, " × "));
}

// ---- writing
// -------------------------------------------------------------------------------------

H5::StrType text_type() {
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

void write_text(const H5::H5Object& object, const char* name, const std::string& text) {
  object.createAttribute(name, text_type(), H5::DataSpace()).write(text_type(), text);
}

template <class Value>
void write_number(const H5::H5Object& object, const char* name, const H5::PredType& type,
                  const Value& value) {
  object.createAttribute(name, type, H5::DataSpace()).write(type, &value);
}

void write_data_set(const H5::Group& group, const char* name, const char* unit,
                    const H5::PredType& type, const void* data, const Shape& shape) {
  Shape chunk = shape;
  chunk[0] = std::min(chunk[0], kChunkFrames);
  H5::DSetCreatPropList properties;
  properties.setChunk(static_cast<int>(chunk.size()), chunk.data());
  properties.setShuffle();
  properties.setDeflate(kDeflateLevel);
  properties.setFletcher32();
  // Without times of day, equal recordings are equal bytes.
  H5Pset_obj_track_times(properties.getId(), false);
  const H5::DataSpace space(static_cast<int>(shape.size()), shape.data());
  H5::DataSet data_set = group.createDataSet(name, type, space, properties);
  data_set.write(data, type);
  write_text(data_set, "unit", unit);
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
  write_data_set(group, measured_name(command), command.unit.c_str(), real,
                 episode.pressure_kpa.data(), {frames, segments});
  write_data_set(group, setpoint_name(command), command.unit.c_str(), real,
                 episode.setpoint_kpa.data(), {frames, segments});
  write_data_set(group, "backbone", "m, m, rad", real, episode.backbone.data(),
                 {frames, points, 3});
  write_data_set(group, "motion_index", "1", H5::PredType::NATIVE_INT, episode.motion_index.data(),
                 {frames});
  write_data_set(group, "tracked", "1", H5::PredType::NATIVE_UINT8, tracked.data(), {frames});
}

void write_file(const std::filesystem::path& path, const Recording& recording) {
  const H5::H5File file(path.string(), H5F_ACC_TRUNC);
  write_text(file, "schema", kSchema);
  write_text(file, "arm_name", recording.arm_name);
  write_text(file, "arm_hash", recording.arm_hash);
  if (!recording.command.is_pressure_kpa()) {
    write_text(file, "command_name", recording.command.name);
    write_text(file, "command_unit", recording.command.unit);
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
}

// ---- reading
// -------------------------------------------------------------------------------------

/// One recording file; every refusal names it.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : name_(path.string()), file_(open(path)) {}

  Recording read() {
    Recording recording;
    require_schema();
    recording.arm_name = text("arm_name");
    recording.arm_hash = text("arm_hash");
    if (file_.attrExists("command_unit")) {
      recording.command = {text("command_name"), text("command_unit")};
    }
    recording.source = text("source");
    recording.settings = file_.attrExists("settings") ? text("settings") : std::string();
    recording.program_version = text("program_version");
    recording.rate_hz = number<double>("rate_hz", H5::PredType::NATIVE_DOUBLE);
    recording.segment_count = number<int>("segments", H5::PredType::NATIVE_INT);
    recording.point_count = number<int>("points", H5::PredType::NATIVE_INT);
    recording.seed = number<std::uint64_t>("seed", H5::PredType::NATIVE_UINT64);
    const hsize_t episodes = episode_count();
    for (hsize_t i = 0; i < episodes; ++i) {
      recording.episodes.push_back(read_episode(episode_path(i), recording));
    }
    return recording;
  }

 private:
  H5::H5File open(const std::filesystem::path& path) const {
    bool is_hdf5 = false;
    try {
      is_hdf5 = H5::H5File::isHdf5(path.string());
    } catch (const H5::Exception&) {
      is_hdf5 = false;
    }
    if (!is_hdf5) {
      throw InputError(
          fmt::format("{}: not an HDF5 file; expected a recording, schema '{}' (docs/formats.md)",
                      name_, kSchema));
    }
    try {
      return H5::H5File(path.string(), H5F_ACC_RDONLY);
    } catch (const H5::Exception&) {
      throw InputError(fmt::format(
          "{}: an HDF5 file that can't be opened: damaged or cut short; expected a whole recording",
          name_));
    }
  }

  [[noreturn]] void refuse(const std::string& place, const std::string& message) const {
    throw InputError(fmt::format("{}: {}: {}", name_, place, message));
  }

  H5::Attribute attribute(const char* name) const {
    if (!file_.attrExists(name)) {
      refuse(fmt::format("attribute '{}'", name), "missing");
    }
    return file_.openAttribute(name);
  }

  std::string text(const char* name) const {
    const H5::Attribute found = attribute(name);
    if (found.getTypeClass() != H5T_STRING) {
      refuse(fmt::format("attribute '{}'", name), "not a text; expected a text");
    }
    std::string value;
    found.read(found.getStrType(), value);
    if (!is_utf8(value)) {
      refuse(fmt::format("attribute '{}'", name), "not a text in UTF-8; expected one");
    }
    return value;
  }

  template <class Value>
  Value number(const char* name, const H5::PredType& type) const {
    const H5::Attribute found = attribute(name);
    const H5T_class_t kind = found.getTypeClass();
    const bool whole = std::is_integral_v<Value>;
    if ((kind != H5T_INTEGER && (whole || kind != H5T_FLOAT)) ||
        found.getSpace().getSimpleExtentNpoints() != 1) {
      refuse(fmt::format("attribute '{}'", name),
             whole ? "not a whole number; expected one" : "not a number; expected one");
    }
    Value value{};
    found.read(type, &value);
    return value;
  }

  void require_schema() const {
    if (!file_.attrExists("schema")) {
      refuse("attribute 'schema'", fmt::format("missing; this program reads '{}'", kSchema));
    }
    const std::string schema = text("schema");
    if (schema != kSchema) {
      refuse("attribute 'schema'",
             fmt::format("'{}' found; this program reads '{}'", schema, kSchema));
    }
  }

  bool exists(const std::string& path) const { return file_.nameExists(path); }

  hsize_t episode_count() const {
    if (!exists("episodes") || file_.childObjType("episodes") != H5O_TYPE_GROUP) {
      refuse("episodes", "group missing");
    }
    const H5::Group group = file_.openGroup("episodes");
    const hsize_t count = group.getNumObjs();
    for (hsize_t i = 0; i < count; ++i) {
      if (!exists(episode_path(i))) {
        refuse(episode_path(i), fmt::format("missing; 'episodes' holds {} entries, expected to be "
                                            "named 000000, 000001, …",
                                            count));
      }
      if (file_.childObjType(episode_path(i)) != H5O_TYPE_GROUP) {
        refuse(episode_path(i), "not a group; expected an episode");
      }
    }
    return count;
  }

  /// A data set that exists, holds numbers and has the dimensions wanted (0: any).
  H5::DataSet data_set(const std::string& path, const Shape& wanted, const char* meaning,
                       const char* unit) const {
    if (!exists(path) || file_.childObjType(path) != H5O_TYPE_DATASET) {
      refuse(path, fmt::format("data set missing; expected {}", meaning));
    }
    H5::DataSet found = file_.openDataSet(path);
    const H5T_class_t kind = found.getTypeClass();
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
      refuse(path, fmt::format("holds no numbers; expected {}", meaning));
    }
    const H5::DataSpace space = found.getSpace();
    const int rank = space.getSimpleExtentNdims();
    Shape shape(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) {
      space.getSimpleExtentDims(shape.data());
    }
    bool fits = shape.size() == wanted.size();
    for (std::size_t i = 0; fits && i < shape.size(); ++i) {
      fits = shape[i] <= kLargestCount && (wanted[i] == 0 || shape[i] == wanted[i]);
    }
    if (!fits) {
      refuse(path, fmt::format("shape {} found; expected {}", text_of(shape), meaning));
    }
    require_unit(path, found, unit);
    return found;
  }

  /// The name carries the unit; an attribute that says another is refused.
  void require_unit(const std::string& path, const H5::DataSet& found, const char* unit) const {
    if (!found.attrExists("unit")) {
      return;
    }
    const H5::Attribute attribute = found.openAttribute("unit");
    std::string value;
    if (attribute.getTypeClass() == H5T_STRING) {
      attribute.read(attribute.getStrType(), value);
    }
    if (value != unit) {
      refuse(path, fmt::format("unit '{}' found; expected '{}'", value, unit));
    }
  }

  void read_into(const std::string& path, const H5::DataSet& found, void* data,
                 const H5::PredType& type) const {
    try {
      found.read(data, type);
    } catch (const H5::Exception&) {
      refuse(path, "can't be read: the file is damaged or cut short");
    }
  }

  FrameMatrix matrix(const std::string& path, const Shape& wanted, const std::string& meaning,
                     const char* unit) const {
    const H5::DataSet found = data_set(path, wanted, meaning.c_str(), unit);
    hsize_t extents[3] = {};
    const int rank = found.getSpace().getSimpleExtentDims(extents);
    const hsize_t columns = rank == 3 ? extents[1] * extents[2] : extents[1];
    FrameMatrix result(static_cast<Eigen::Index>(extents[0]), static_cast<Eigen::Index>(columns));
    read_into(path, found, result.data(), H5::PredType::NATIVE_FLOAT);
    return result;
  }

  Episode read_episode(const std::string& group, const Recording& recording) const {
    Episode episode;
    const std::string time_path = group + "/time_s";
    const H5::DataSet times = data_set(time_path, {0}, "one time a frame", "s");
    const auto frames = static_cast<hsize_t>(times.getSpace().getSimpleExtentNpoints());
    if (frames == 0) {
      refuse(time_path, "no frames; expected at least one");
    }
    episode.time_s.resize(static_cast<Eigen::Index>(frames));
    read_into(time_path, times, episode.time_s.data(), H5::PredType::NATIVE_DOUBLE);

    const auto n = static_cast<hsize_t>(std::max(recording.segment_count, 0));
    const auto m = static_cast<hsize_t>(std::max(recording.point_count, 0));
    const std::string pressures = fmt::format("{} × {}: frames × segments", frames, n);
    const Command& command = recording.command;
    const auto commands = [&](const char* name) {
      return matrix(group + "/" + name, {frames, n}, pressures, command.unit.c_str());
    };
    episode.pressure_kpa = commands(measured_name(command));
    episode.setpoint_kpa = commands(setpoint_name(command));
    episode.backbone =
        matrix(group + "/backbone", {frames, m, 3},
               fmt::format("{} × {} × 3: frames × points × [x_m, y_m, theta_rad]", frames, m),
               "m, m, rad");

    const std::string each = fmt::format("{}: one a frame", frames);
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
    return episode;
  }

  std::string name_;
  H5::H5File file_;
};

}  // namespace

void write_recording(const std::filesystem::path& path, const Recording& recording) {
  validate(recording, path.string());
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    const Hdf5Section section;
    try {
      write_file(temporary, recording);
    } catch (const H5::Exception& error) {
      throw SystemFault(fmt::format("{}: can't be written: {} ({})", path.string(),
                                    error.getDetailMsg(), error.getFuncName()));
    }
  });
}

Recording read_recording(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(fmt::format("{}: no such file; expected a recording", path.string()));
  }
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder; expected a recording file", path.string()));
  }
  Recording recording;
  {
    const Hdf5Section section;
    try {
      recording = Reader(path).read();
    } catch (const H5::Exception& failure) {
      throw InputError(fmt::format("{}: can't be read: {} ({}); the file is damaged or cut short",
                                   path.string(), failure.getDetailMsg(), failure.getFuncName()));
    }
  }
  validate(recording, path.string());
  return recording;
}

}  // namespace limber
