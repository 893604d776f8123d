#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "episode_path.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/utf8.hpp"
#include "recording_hdf5.hpp"
#include "recording_header.hpp"

namespace limber {

namespace {

constexpr hsize_t kMaxCount = 1U << 28;  // frames of an episode; above it, the file is damaged

// Deflate makes data at most 1032 times smaller; less than this on disk were never written.
constexpr hsize_t kMaxCompression = 1100;
constexpr hsize_t kSmallData = hsize_t{1} << 26U;  // bytes; up to here other filters may do better

std::string text_of(const Shape& shape) {
  return shape.empty() ? "a single value" : fmt::format("{}", fmt::join(shape, " × "));
}

/// One recording file; every refusal names it.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : name_(path.string()), file_(open(path)) {}

  Recording read() {
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
    validate_header(recording, name_);  // sizes decide what the data sets must hold
    const bool setpoints_only = holds_setpoints_only();
    const hsize_t episodes = episode_count();
    for (hsize_t i = 0; i < episodes; ++i) {
      recording.episodes.push_back(read_episode(episode_path(i), recording, setpoints_only));
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
                      name_, kRecordingSchema));
    }
    try {
      return H5::H5File(path.string(), H5F_ACC_RDONLY);
    } catch (const H5::Exception&) {
      throw InputError(fmt::format(
          "{}: an HDF5 file that can't be opened: damaged or cut short; expected a whole recording",
          name_));
    }
  }

  [[noreturn]] void refuse(const std::string& where, const std::string& message) const {
    throw InputError(fmt::format("{}: {}: {}", name_, where, message));
  }

  H5::Attribute attribute(const char* name) const {
    if (!file_.attrExists(name)) {
      refuse(fmt::format("attribute '{}'", name), "missing");
    }
    return file_.openAttribute(name);
  }

  /// A text of the file: an attribute or, a long one, a data set.
  std::string text(const char* name) const {
    if (!file_.attrExists(name) && exists(name)) {
      if (file_.childObjType(name) != H5O_TYPE_DATASET) {
        refuse(name, "not a text; expected a text");
      }
      const H5::DataSet found = file_.openDataSet(name);
      require_stored(name, found);
      return text_in(found, name);
    }
    return text_in(attribute(name), fmt::format("attribute '{}'", name));
  }

  std::string text_if_there(const char* name) const {
    return file_.attrExists(name) || exists(name) ? text(name) : std::string();
  }

  /// The text of any attribute or data set.
  template <class Object>
  std::string text_in(const Object& found, const std::string& where) const {
    if (found.getTypeClass() != H5T_STRING) {
      refuse(where, "not a text; expected a text");
    }
    require_single(found, where);
    const H5::StrType type = found.getStrType();
    if (type.getSize() > kLongestText) {
      refuse(where,
             fmt::format("a text of {} bytes; expected up to {}", type.getSize(), kLongestText));
    }
    std::string value;
    if constexpr (std::is_same_v<Object, H5::Attribute>) {
      found.read(type, value);
    } else {
      found.read(value, type);
    }
    if (!is_utf8(value)) {
      refuse(where, "not a text in UTF-8; expected a text in UTF-8");
    }
    return value;
  }

  /// HDF5 reads as many values as an attribute holds, however many there is room for.
  template <class Object>
  void require_single(const Object& found, const std::string& where) const {
    const hssize_t count = found.getSpace().getSimpleExtentNpoints();
    if (count != 1) {
      refuse(where, fmt::format("{} values found; expected a single value", count));
    }
  }

  template <class Value>
  Value number(const char* name, const H5::PredType& type) const {
    const H5::Attribute found = attribute(name);
    const H5T_class_t kind = found.getTypeClass();
    const bool whole = std::is_integral_v<Value>;
    if (kind != H5T_INTEGER && (whole || kind != H5T_FLOAT)) {
      refuse(fmt::format("attribute '{}'", name),
             whole ? "not a whole number; expected one" : "not a number; expected one");
    }
    require_single(found, fmt::format("attribute '{}'", name));
    Value value{};
    found.read(type, &value);
    return value;
  }

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

  bool holds_setpoints_only() const {
    if (!file_.attrExists(kCommandsAre)) {
      return false;
    }
    const std::string found = text(kCommandsAre);
    if (found != commands_are(false) && found != commands_are(true)) {
      refuse(fmt::format("attribute '{}'", kCommandsAre),
             fmt::format("'{}' found; expected '{}' or '{}'", found, commands_are(false),
                         commands_are(true)));
    }
    return found == commands_are(true);
  }

  /// @throws InputError for a link to other data: it may name any file, or a pipe.
  bool exists(const std::string& path) const {
    if (!file_.nameExists(path)) {
      return false;
    }
    H5L_info_t link{};
    if (H5Lget_info(file_.getId(), path.c_str(), &link, H5P_DEFAULT) < 0 ||
        link.type != H5L_TYPE_HARD) {
      refuse(path, "a link to other data; expected the data themselves");
    }
    return true;
  }

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

  /// Integers and IEEE's floats of the usual sizes. A damaged type may be larger than its chunks
  /// hold, and HDF5 reads beyond them without a check.
  static bool is_number_of_machines(const H5::DataType& type) {
    const H5T_class_t kind = type.getClass();
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
      return false;
    }
    static const std::vector<hid_t> known = {
        H5T_STD_I8LE,  H5T_STD_I16LE,  H5T_STD_I32LE,  H5T_STD_I64LE,  H5T_STD_I8BE,
        H5T_STD_I16BE, H5T_STD_I32BE,  H5T_STD_I64BE,  H5T_STD_U8LE,   H5T_STD_U16LE,
        H5T_STD_U32LE, H5T_STD_U64LE,  H5T_STD_U8BE,   H5T_STD_U16BE,  H5T_STD_U32BE,
        H5T_STD_U64BE, H5T_IEEE_F32LE, H5T_IEEE_F64LE, H5T_IEEE_F32BE, H5T_IEEE_F64BE};
    return std::ranges::any_of(known, [&](hid_t one) { return H5Tequal(type.getId(), one) > 0; });
  }

  /// A data set that exists, holds numbers and has the dimensions wanted (0: any).
  H5::DataSet data_set(const std::string& path, const Shape& wanted, const char* meaning,
                       const char* unit) const {
    if (!exists(path) || file_.childObjType(path) != H5O_TYPE_DATASET) {
      refuse(path, fmt::format("data set missing; expected {}", meaning));
    }
    H5::DataSet found = file_.openDataSet(path);
    if (!is_number_of_machines(found.getDataType())) {
      refuse(path, fmt::format("holds no numbers that a machine has; expected {}", meaning));
    }
    const H5::DataSpace space = found.getSpace();
    const int rank = space.getSimpleExtentNdims();
    Shape shape(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) {
      space.getSimpleExtentDims(shape.data());
    }
    bool fits = shape.size() == wanted.size();
    for (std::size_t i = 0; fits && i < shape.size(); ++i) {
      fits = shape[i] <= kMaxCount && (wanted[i] == 0 || shape[i] == wanted[i]);
    }
    if (!fits) {
      refuse(path, fmt::format("shape {} found; expected {}", text_of(shape), meaning));
    }
    require_unit(path, found, unit);
    require_stored(path, found);
    return found;
  }

  /// Refuses data of which the file holds only the shape, before memory is allocated for them.
  void require_stored(const std::string& path, const H5::DataSet& found) const {
    const H5::DSetCreatPropList properties = found.getCreatePlist();
    if (properties.getLayout() == H5D_VIRTUAL ||
        (properties.getLayout() == H5D_CONTIGUOUS && properties.getExternalCount() > 0)) {
      refuse(path, "data in another file; expected the data themselves");
    }
    const auto numbers = static_cast<hsize_t>(found.getSpace().getSimpleExtentNpoints());
    const hsize_t bytes = numbers * found.getDataType().getSize();
    const hsize_t stored = found.getStorageSize();
    if (numbers > 0 && (stored == 0 || (bytes > kSmallData && bytes / kMaxCompression > stored))) {
      refuse(path, fmt::format("its shape says {} numbers, but the file holds {} "
                               "bytes: they were never written, or the file is damaged",
                               numbers, stored));
    }
  }

  /// The name carries the unit; an attribute that says another is refused.
  void require_unit(const std::string& path, const H5::DataSet& found, const char* unit) const {
    if (!found.attrExists("unit")) {
      return;
    }
    const std::string value = text_in(found.openAttribute("unit"), path + ", attribute 'unit'");
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

  Episode read_episode(const std::string& group, const Recording& recording,
                       bool setpoints_only) const {
    Episode episode;
    episode.setpoints_only = setpoints_only;
    const std::string time_path = group + "/time_s";
    const H5::DataSet times = data_set(time_path, {0}, "one time a frame", "s");
    const auto frames = static_cast<hsize_t>(times.getSpace().getSimpleExtentNpoints());
    if (frames == 0) {
      refuse(time_path, "no frames; expected at least one");
    }
    episode.time_s.resize(static_cast<Eigen::Index>(frames));
    read_into(time_path, times, episode.time_s.data(), H5::PredType::NATIVE_DOUBLE);

    const auto n = static_cast<hsize_t>(recording.segment_count);
    const auto m = static_cast<hsize_t>(recording.point_count);
    const std::string pressures = fmt::format("{} × {}: frames × segments", frames, n);
    const Command& command = recording.command;
    const auto commands = [&](const std::string& name) {
      return matrix(group + "/" + name, {frames, n}, pressures, command.unit.c_str());
    };
    episode.setpoint_kpa = commands(setpoint_name(command));
    const std::string measured = group + "/" + measured_name(command);
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
    episode.pressure_kpa = setpoints_only ? episode.setpoint_kpa : commands(measured_name(command));
    episode.backbone =
        matrix(group + "/backbone", {frames, m, kPoseSize},
               fmt::format("{} × {} × 3: frames × points × [x_m, y_m, theta_rad]", frames, m),
               "m, m, rad");
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
    for (const auto& [name, text] : {std::pair(kPhysics, &episode.physics), {kLog, &episode.log}}) {
      if (const H5::Group own = file_.openGroup(group); own.attrExists(name)) {
        *text = text_in(own.openAttribute(name), fmt::format("{}, attribute '{}'", group, name));
      }
    }
    return episode;
  }

  std::string name_;
  H5::H5File file_;
};

Recording read(const std::filesystem::path& path) {
  Hdf5Section section;
  try {
    return Reader(path).read();
  } catch (const H5::Exception&) {
    section.stay_quiet();
    throw InputError(fmt::format(
        "{}: can't be read: damaged or cut short; expected a whole recording", path.string()));
  } catch (const InputError&) {
    section.stay_quiet();
    throw;
  }
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(fmt::format("{}: no such file; expected a recording", path.string()));
  }
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder; expected a recording file", path.string()));
  }
  require_plain_file(path);
  Recording recording;
  try {
    recording = read(path);
  } catch (const InputError&) {
    (void)read_file(path);  // tells a failing disk from a damaged file; HDF5 does not
    throw;
  }
  validate(recording, path.string());
  return recording;
}

}  // namespace limber
