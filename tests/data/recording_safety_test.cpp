// Recordings made to harm, and disks that fail: nothing is overrun, nothing is lost.
#include <sys/stat.h>

#include <filesystem>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/data/recording.hpp"
#include "recording_file.hpp"
#include "support/file_size_limit.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// HDF5 reads as many texts as an attribute holds, whatever there is room for.
TEST_F(RecordingFile, RefusesTextsThatAreNotASingleOne) {
  const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  for (const char* name :
       {"schema", "arm_name", "arm_hash", "source", "settings", "program_version"}) {
    write_recording(path_, test_recording());
    expect_refusal(
        [&](H5::H5File& f) {
          f.removeAttr(name);
          const hsize_t count = 3000;
          const std::vector<const char*> texts(count, "x");
          f.createAttribute(name, type, H5::DataSpace(1, &count)).write(type, texts.data());
        },
        {std::string("attribute '") + name + "': 3000 values found; expected a single value"});
    write_recording(path_, test_recording());
    expect_refusal(
        [&](H5::H5File& f) {
          f.removeAttr(name);
          f.createAttribute(name, type, H5::DataSpace(H5S_NULL));
        },
        {std::string("attribute '") + name + "': 0 values found; expected a single value"});
  }
  write_recording(path_, test_recording());
  expect_refusal(
      [&](H5::H5File& f) {
        H5::DataSet data_set = f.openDataSet("episodes/000000/backbone");
        data_set.removeAttr("unit");
        const hsize_t count = 2;
        const std::vector<const char*> texts(count, "m, m, rad");
        data_set.createAttribute("unit", type, H5::DataSpace(1, &count)).write(type, texts.data());
      },
      {"episodes/000000/backbone, attribute 'unit': 2 values found; expected a single value"});
  write_recording(path_, test_recording());
  expect_refusal(
      [&](H5::H5File& f) {
        H5::DataSet data_set = f.openDataSet("episodes/000000/backbone");
        data_set.removeAttr("unit");
        data_set.createAttribute("unit", type, H5::DataSpace(H5S_NULL));
      },
      {"episodes/000000/backbone, attribute 'unit': 0 values found"});
}

// What damages files: flipped bits, zeroed or repeated pieces, an end cut off. libhdf5 crashed or
// hung at one in seventy while texts lay in its heap, at one in 750 while nothing in a file but its
// numbers had checksums.
TEST_F(RecordingFile, ReadsOrRefusesWhateverHappenedToItsBytes) {
  Recording recording = test_recording(2, 40);
  recording.arm_description = std::string(700, 'x');
  write_recording(path_, recording);
  const std::string whole = read_file(path_);
  constexpr int kDamaged = 400;
  int refused = 0;
  for (int i = 0; i < kDamaged; ++i) {
    RandomStream random(38, static_cast<std::uint64_t>(i));
    const auto place = [&] { return random.index(static_cast<std::uint32_t>(whole.size())); };
    std::string bytes = whole;
    for (std::uint32_t k = 0; k <= random.index(4); ++k) {
      const std::size_t at = place();
      const std::size_t length = std::min<std::size_t>(1 + random.index(16), whole.size() - at);
      switch (random.index(4)) {
        case 0:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.index(8)));
          break;
        case 1:
          bytes.replace(at, length, length, random.index(2) == 0 ? '\0' : '\xff');
          break;
        case 2:
          bytes.replace(at, length, whole, place(), length);
          break;
        default:
          bytes[at] = static_cast<char>(random.index(256));
      }
    }
    bytes.resize(random.index(10) == 0 ? place() : bytes.size());
    write_file_atomically(path_, bytes);
    try {
      (void)read_recording(path_);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, kDamaged / 4);
  EXPECT_LT(refused, kDamaged) << "some damage is in bytes that nobody reads";
}

TEST_F(RecordingFile, ReadsATextInAnArrayOfOne) {
  {
    H5::H5File file(path_.string(), H5F_ACC_RDWR);
    file.removeAttr("arm_name");
    const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
    const hsize_t count = 1;
    const char* text = "one";
    file.createAttribute("arm_name", type, H5::DataSpace(1, &count)).write(type, &text);
  }
  EXPECT_EQ(read_recording(path_).arm_name, "one");
}

// By its shapes the file would take 15 GB; it holds 10 kB.
TEST_F(RecordingFile, RefusesDataThatWereNeverWritten) {
  const auto unwritten = [](H5::H5File& file, const std::string& name, const H5::PredType& type,
                            const std::vector<hsize_t>& shape) {
    const std::string path = "episodes/000000/" + name;
    file.unlink(path);
    H5::DSetCreatPropList chunked;
    std::vector<hsize_t> chunk = shape;
    chunk[0] = 1024;
    chunked.setChunk(static_cast<int>(chunk.size()), chunk.data());
    file.createDataSet(path, type, H5::DataSpace(static_cast<int>(shape.size()), shape.data()),
                       chunked);
  };
  constexpr hsize_t kFrames = hsize_t{1} << 28U;
  expect_refusal(
      [&](H5::H5File& f) {
        unwritten(f, "time_s", H5::PredType::NATIVE_DOUBLE, {kFrames});
        unwritten(f, "backbone", H5::PredType::NATIVE_FLOAT, {kFrames, 4, 3});
      },
      {"episodes/000000/time_s: its shape says 268435456 numbers, but the file holds 0 bytes"});
  write_recording(path_, test_recording());
  expect_refusal(
      [&](H5::H5File& f) {
        replace_data_set(f, "episodes/000000/backbone", H5::PredType::NATIVE_FLOAT, {5, 4, 3});
      },
      {"episodes/000000/backbone: its shape says 60 numbers, but the file holds 0 bytes"});
}

TEST_F(RecordingFile, RefusesDataInOtherFiles) {
  write_recording(folder_.path() / "other.h5", test_recording());
  for (const char* name : {"episodes/000000", "episodes/000001/time_s", "episodes"}) {
    write_recording(path_, test_recording());
    expect_refusal(
        [&](H5::H5File& f) {
          f.unlink(name);
          ASSERT_GE(H5Lcreate_external("other.h5", name, f.getId(), name, H5P_DEFAULT, H5P_DEFAULT),
                    0);
        },
        {std::string(name) + ": a link to other data; expected the data themselves"});
    write_recording(path_, test_recording());
    expect_refusal(
        [&](H5::H5File& f) {
          f.unlink(name);
          ASSERT_GE(H5Lcreate_soft("/nowhere", f.getId(), name, H5P_DEFAULT, H5P_DEFAULT), 0);
        },
        {std::string(name) + ": a link to other data"});
  }
  write_recording(path_, test_recording());
  expect_refusal(
      [&](H5::H5File& f) {
        f.unlink("episodes/000000/time_s");
        H5::DSetCreatPropList elsewhere;
        elsewhere.setExternal("/proc/self/exe", 0, 5 * sizeof(double));
        const hsize_t frames = 5;
        f.createDataSet("episodes/000000/time_s", H5::PredType::NATIVE_DOUBLE,
                        H5::DataSpace(1, &frames), elsewhere);
      },
      {"episodes/000000/time_s: data in another file; expected the data themselves"});
}

TEST_F(RecordingFile, RefusesSizesBelowOneBeforeItsDataSets) {
  expect_refusal([](H5::H5File& f) { set_number(f, "segments", H5::PredType::NATIVE_INT, 0); },
                 {"attribute 'segments' is 0; expected a whole number ≥ 1"});
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_number(f, "points", H5::PredType::NATIVE_INT, 0); },
                 {"attribute 'points' is 0; expected a whole number ≥ 2"});
}

TEST_F(RecordingFile, IsKeptAsItWasWhereTheDiskIsFull) {
  const std::string before = read_file(path_);
  for (const rlim_t bytes : {0, 100, 2000, 8000, 20000}) {
    const FileSizeLimit limit(bytes);
    EXPECT_THAT([&] { write_recording(path_, test_recording(10, 500)); },
                ThrowsMessage<SystemFault>(HasSubstr("can't be written: File too large")));
  }
  EXPECT_EQ(read_file(path_), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(RecordingFile, RefusesAPipeAtOnce) {
  const fs::path pipe = folder_.path() / "pipe.h5";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT([&] { read_recording(pipe); },
              ThrowsMessage<InputError>(HasSubstr("is a pipe or a device")));
}

}  // namespace
}  // namespace limber
