#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <H5Cpp.h>
#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_recording.hpp"

namespace limber {

/// A recording on disk, which tests damage.
class RecordingFile : public ::testing::Test {
 protected:
  void SetUp() override { write_recording(path_, test_recording()); }

  /// Breaks the file by `damage` and expects the refusal to name the file and all of `parts`.
  void expect_refusal(const std::function<void(H5::H5File&)>& damage,
                      const std::vector<std::string>& parts) {
    {
      H5::H5File file(path_.string(), H5F_ACC_RDWR);
      damage(file);
    }
    expect_refused(parts);
  }

  void expect_refused(const std::vector<std::string>& parts) const {
    try {
      read_recording(path_);
      FAIL() << "read, though broken";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(path_.string()));
      for (const std::string& part : parts) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
      }
    }
  }

  static void replace_data_set(H5::H5File& file, const char* path, const H5::PredType& type,
                               const std::vector<hsize_t>& shape) {
    file.unlink(path);
    file.createDataSet(path, type, H5::DataSpace(static_cast<int>(shape.size()), shape.data()));
  }

  template <class Value>
  static void overwrite(H5::H5File& file, const char* path, const H5::PredType& type,
                        std::size_t index, Value value) {
    H5::DataSet data_set = file.openDataSet(path);
    std::vector<Value> values(
        static_cast<std::size_t>(data_set.getSpace().getSimpleExtentNpoints()));
    data_set.read(values.data(), type);
    values.at(index) = value;
    data_set.write(values.data(), type);
  }

  static void set_attribute(H5::H5Object& object, const char* name, const std::string& text) {
    if (object.attrExists(name)) {
      object.removeAttr(name);
    }
    const H5::StrType type(H5::PredType::C_S1, text.size());
    object.createAttribute(name, type, H5::DataSpace()).write(type, text);
  }

  template <class Value>
  static void set_number(H5::H5File& file, const char* name, const H5::PredType& type,
                         Value value) {
    file.removeAttr(name);
    file.createAttribute(name, type, H5::DataSpace()).write(type, &value);
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "run.h5";
};

}  // namespace limber
