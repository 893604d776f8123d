#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/utf8.hpp"
#include "recording_hdf5.hpp"

namespace limber {

/// A file's bytes, mapped: what is read of them comes from the disk then.
class MappedFile {
 public:
  /// @throws InputError, SystemFault as read_file does
  explicit MappedFile(const fs::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  const std::string& name() const { return name_; }
  std::size_t size() const { return size_; }
  /// nullptr where the file is empty. Not const, as HDF5 wants it; writing ends the process.
  char* data() const { return data_; }

 private:
  std::string name_;
  std::size_t size_ = 0;
  char* data_ = nullptr;
};

/// A recording's file, of which nothing is believed: what is missing, of another type, size or
/// unit, or not in the file itself is refused by an InputError that names the file and the place.
class CheckedHdf5 {
 public:
  /// @param file  outlives this
  explicit CheckedHdf5(const MappedFile& file);

  [[noreturn]] void refuse(const std::string& where, const std::string& message) const;

  /// A text of the file: an attribute or, a long one, a data set.
  std::string text(const char* name) const;
  std::string text_if_there(const char* name) const;
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

  /// @throws InputError for a link to other data: it may name any file, or a pipe.
  bool exists(const std::string& path) const;
  /// A data set that exists, holds numbers and has the dimensions wanted (0: any).
  H5::DataSet data_set(const std::string& path, const Shape& wanted, const char* meaning,
                       const char* unit) const;
  void read_into(const std::string& path, const H5::DataSet& found, void* data,
                 const H5::PredType& type) const;
  FrameMatrix matrix(const std::string& path, const Shape& wanted, const std::string& meaning,
                     const char* unit) const;

 private:
  H5::H5File open(const MappedFile& file) const;
  H5::Attribute attribute(const char* name) const;
  /// HDF5 reads as many values as an attribute holds, however many there is room for.
  template <class Object>
  void require_single(const Object& found, const std::string& where) const {
    const hssize_t count = found.getSpace().getSimpleExtentNpoints();
    if (count != 1) {
      refuse(where, fmt::format("{} values found; expected a single value", count));
    }
  }

  /// Refuses data of which the file holds only the shape, before memory is allocated for them, and
  /// those that HDF5 would look for elsewhere or need a plugin for.
  void require_stored(const std::string& path, const H5::DataSet& found) const;
  void require_known_filters(const std::string& path, const H5::DSetCreatPropList& how) const;
  /// The name carries the unit; an attribute that says another is refused.
  void require_unit(const std::string& path, const H5::DataSet& found, const char* unit) const;

 protected:
  std::string name_;
  hsize_t size_;  ///< of the file, in bytes
  H5::H5File file_;
};

}  // namespace limber
