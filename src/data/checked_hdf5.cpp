#include "checked_hdf5.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/descriptor.hpp"
#include "limber/common/file_error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr hsize_t kMaxCount = 1U << 28;  // frames of an episode; above it, the file is damaged

constexpr hsize_t kSmallData = hsize_t{1} << 26U;  // bytes; up to here other filters may do better

std::string text_of(const Shape& shape) {
  return shape.empty() ? "a single value" : fmt::format("{}", fmt::join(shape, " × "));
}

/// Integers and IEEE's floats of the usual sizes. A damaged type may be larger than its chunks
/// hold, and HDF5 reads beyond them without a check.
bool is_number_of_machines(const H5::DataType& type) {
  const H5T_class_t kind = type.getClass();
  if (kind == H5T_ENUM) {  // NumPy's booleans
    return is_number_of_machines(type.getSuper());
  }
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

/// HDF5's own eight bytes: at the beginning, or behind a block of the user's of 512 bytes times a
/// power of two.
bool starts_as_hdf5(const MappedFile& file) {
  constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n", 8);
  for (std::size_t at = 0; at + kSignature.size() <= file.size();
       at = std::max<std::size_t>(512, 2 * at)) {
    if (std::memcmp(file.data() + at, kSignature.data(), kSignature.size()) == 0) {
      return true;
    }
  }
  return false;
}

/// How HDF5 opens a file that is in memory: it copies nothing, and opens no other.
H5::FileAccPropList borrowing(const MappedFile& file) {
  H5FD_file_image_callbacks_t calls = {};
  calls.image_malloc = [](size_t, H5FD_file_image_op_t, void* data) { return data; };
  calls.image_memcpy = [](void* to, const void*, size_t, H5FD_file_image_op_t, void*) {
    return to;
  };
  calls.image_realloc = [](void*, size_t, H5FD_file_image_op_t, void*) {
    return static_cast<void*>(nullptr);
  };
  calls.image_free = [](void*, H5FD_file_image_op_t, void*) -> herr_t { return 0; };
  calls.udata_copy = [](void* data) { return data; };
  calls.udata_free = [](void*) -> herr_t { return 0; };
  calls.udata = file.data();
  H5::FileAccPropList how;
  how.setCore(kMemoryStep, false);
  if (H5Pset_file_image_callbacks(how.getId(), &calls) < 0 ||
      H5Pset_file_image(how.getId(), file.data(), file.size()) < 0) {
    throw H5::FileIException("borrowing", "H5Pset_file_image failed");
  }
  return how;
}

}  // namespace

MappedFile::MappedFile(const fs::path& path) : name_(path.string()) {
  require_plain_file(path);
  const Descriptor file(path, O_RDONLY | O_NOCTTY | O_NONBLOCK);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.get(), &status) != 0) {
    throw_file_error(path, "can't be read", errno);
  }
  size_ = std::size_t(status.st_size);
  void* found = nullptr;
  if (size_ > 0) {
    found = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.get(), 0);
  }
  if (found == MAP_FAILED) {
    throw_fault(path, "can't be read", errno);
  }
  data_ = static_cast<char*>(found);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) {
    (void)::munmap(data_, size_);
  }
}

CheckedHdf5::CheckedHdf5(const MappedFile& file)
    : name_(file.name()), size_(file.size()), file_(open(file)) {}

H5::H5File CheckedHdf5::open(const MappedFile& file) const {
  refuse_if(!starts_as_hdf5(file),
            "{}: not an HDF5 file; expected a recording, schema '{}' (docs/formats.md)", name_,
            kRecordingSchema);
  try {
    return H5::H5File(kNoFile, H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, borrowing(file));
  } catch (const H5::Exception&) {
    throw InputError(fmt::format(
        "{}: an HDF5 file that can't be opened: damaged or cut short; expected a whole recording",
        name_));
  }
}

void CheckedHdf5::refuse(const std::string& where, const std::string& message) const {
  throw InputError(fmt::format("{}: {}: {}", name_, where, message));
}

H5::Attribute CheckedHdf5::attribute(const char* name) const {
  if (!file_.attrExists(name)) {
    refuse(fmt::format("attribute '{}'", name), "missing");
  }
  return file_.openAttribute(name);
}

std::string CheckedHdf5::text(const char* name) const {
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

std::string CheckedHdf5::text_if_there(const char* name) const {
  return file_.attrExists(name) || exists(name) ? text(name) : std::string();
}

bool CheckedHdf5::exists(const std::string& path) const {
  for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    if (!file_.nameExists(part)) {
      return false;
    }
    H5L_info_t link{};
    if (H5Lget_info(file_.getId(), part.c_str(), &link, H5P_DEFAULT) < 0 ||
        link.type != H5L_TYPE_HARD) {
      refuse(part, "a link to other data; expected the data themselves");
    }
    if (end == std::string::npos) {
      return true;
    }
  }
}

H5::DataSet CheckedHdf5::data_set(const std::string& path, const Shape& wanted, const char* meaning,
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
  Shape shape(std::size_t(std::max(rank, 0)));
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

void CheckedHdf5::require_stored(const std::string& path, const H5::DataSet& found) const {
  const H5::DSetCreatPropList properties = found.getCreatePlist();
  if (properties.getLayout() == H5D_VIRTUAL ||
      (properties.getLayout() == H5D_CONTIGUOUS && properties.getExternalCount() > 0)) {
    refuse(path, "data in another file; expected the data themselves");
  }
  require_known_filters(path, properties);
  const auto numbers = static_cast<hsize_t>(found.getSpace().getSimpleExtentNpoints());
  const hsize_t bytes = numbers * found.getDataType().getSize();
  const hsize_t stored = found.getStorageSize();
  if (stored > size_) {
    refuse(path, fmt::format("said to take {} bytes of a file of {}: the file is damaged", stored,
                             size_));
  }
  if (numbers > 0 && (stored == 0 || (bytes > kSmallData && bytes / kMaxCompression > stored))) {
    refuse(path, fmt::format("its shape says {} numbers, but the file holds {} "
                             "bytes: they were never written, or the file is damaged",
                             numbers, stored));
  }
}

void CheckedHdf5::require_known_filters(const std::string& path,
                                        const H5::DSetCreatPropList& how) const {
  for (int i = 0; i < how.getNfilters(); ++i) {
    unsigned flags = 0;
    std::size_t none = 0;
    unsigned config = 0;
    const H5Z_filter_t found = how.getFilter(i, flags, none, nullptr, 0, nullptr, config);
    if (found != H5Z_FILTER_DEFLATE && found != H5Z_FILTER_SHUFFLE &&
        found != H5Z_FILTER_FLETCHER32) {
      refuse(path, fmt::format("HDF5 filter {} found; expected no filter, or deflate (gzip), "
                               "shuffle and fletcher32",
                               int(found)));
    }
  }
  if (how.getLayout() != H5D_CHUNKED) {
    return;
  }
  constexpr int kMaxRank = H5S_MAX_RANK;
  hsize_t extents[kMaxRank] = {};
  hsize_t numbers = 1;
  for (int i = how.getChunk(kMaxRank, extents); i > 0; --i) {
    numbers = std::min(numbers * std::min(extents[i - 1], kMaxCount), kMaxCount);
  }
  if (numbers > kMaxChunk) {
    refuse(path, fmt::format("chunks of more than {} numbers; expected smaller ones", kMaxChunk));
  }
}

void CheckedHdf5::require_unit(const std::string& path, const H5::DataSet& found,
                               const char* unit) const {
  if (!found.attrExists("unit")) {
    return;
  }
  const std::string value = text_in(found.openAttribute("unit"), path + ", attribute 'unit'");
  if (value != unit) {
    refuse(path, fmt::format("unit '{}' found; expected '{}'", value, unit));
  }
}

void CheckedHdf5::read_into(const std::string& path, const H5::DataSet& found, void* data,
                            const H5::PredType& type) const {
  try {
    found.read(data, type);
  } catch (const H5::Exception&) {
    refuse(path, "can't be read: the file is damaged or cut short");
  }
}

FrameMatrix CheckedHdf5::matrix(const std::string& path, const Shape& wanted,
                                const std::string& meaning, const char* unit) const {
  const H5::DataSet found = data_set(path, wanted, meaning.c_str(), unit);
  hsize_t extents[3] = {};
  const int rank = found.getSpace().getSimpleExtentDims(extents);
  const hsize_t columns = rank == 3 ? extents[1] * extents[2] : extents[1];
  FrameMatrix result(extents[0], columns);
  read_into(path, found, result.data(), H5::PredType::NATIVE_FLOAT);
  return result;
}

}  // namespace limber
