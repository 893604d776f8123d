#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace limber {

/// A file's bytes, mapped: what is read of them comes from the disk then.
class MappedFile {
 public:
  /// @throws InputError, SystemFault as read_file does
  explicit MappedFile(const std::filesystem::path& path);
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

}  // namespace limber
