#include "limber/data/recording.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <thread>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/version.hpp"
#include "recording_file.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST_F(RecordingFile, KeepsTheArmsDescription) {
  Recording described = test_recording();
  described.arm_description = "name: \"été\"\nframe_rate_hz: 20\n";
  write_recording(path_, described);
  EXPECT_EQ(read_recording(path_).arm_description, described.arm_description);
}

TEST_F(RecordingFile, ReturnsEveryNumberAndAttributeAsWritten) {
  const Recording written = test_recording();
  const Recording read = read_recording(path_);
  EXPECT_EQ(read.arm_name, written.arm_name);
  EXPECT_EQ(read.arm_hash, written.arm_hash);
  EXPECT_EQ(read.arm_description, "") << "as in files of before arms were described";
  EXPECT_EQ(read.segment_count, written.segment_count);
  EXPECT_EQ(read.point_count, written.point_count);
  EXPECT_EQ(read.rate_hz, written.rate_hz);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.source, written.source);
  EXPECT_EQ(read.settings, written.settings);
  EXPECT_EQ(read.program_version, version());
  ASSERT_EQ(read.episodes.size(), written.episodes.size());
  for (std::size_t i = 0; i < read.episodes.size(); ++i) {
    EXPECT_EQ(read.episodes[i].time_s, written.episodes[i].time_s);
    EXPECT_EQ(read.episodes[i].pressure_kpa, written.episodes[i].pressure_kpa);
    EXPECT_EQ(read.episodes[i].setpoint_kpa, written.episodes[i].setpoint_kpa);
    EXPECT_EQ(read.episodes[i].backbone, written.episodes[i].backbone);
    EXPECT_EQ(read.episodes[i].motion_index, written.episodes[i].motion_index);
    EXPECT_EQ(read.episodes[i].tracked, written.episodes[i].tracked);
  }
  EXPECT_EQ(read.frame_count(), 10);
  EXPECT_EQ(read.untracked_count(), 2);
  EXPECT_DOUBLE_EQ(read.duration_s(), 0.5);
}

TEST_F(RecordingFile, KeepsTheNameOfAnEpisodesLog) {
  Recording imported = test_recording();
  imported.episodes.back().log = "été 3.csv";
  write_recording(path_, imported);
  EXPECT_EQ(read_recording(path_).episodes.front().log, "");
  EXPECT_EQ(read_recording(path_).episodes.back().log, "été 3.csv");
}

TEST_F(RecordingFile, KeepsWhatWasDrawnForAnEpisodeAndWritesNothingWhereNothingWas) {
  Recording varied = test_recording();
  varied.episodes[1].physics = "{\"tip_load_kg\": 0.05}";
  write_recording(path_, varied);
  const Recording read = read_recording(path_);
  EXPECT_EQ(read.episodes[0].physics, "");
  EXPECT_EQ(read.episodes[1].physics, varied.episodes[1].physics);
  const std::string bytes = read_file(path_);
  EXPECT_NE(bytes.find("tip_load_kg"), std::string::npos);
  write_recording(path_, test_recording());
  EXPECT_EQ(read_file(path_).find("physics"), std::string::npos);
}

// Texts of variable length lie in a heap that HDF5 reads unchecked.
TEST_F(RecordingFile, HoldsTextsOfFixedLengthAlone) {
  Recording recording = test_recording();
  recording.arm_description = "name: \"été\"\n";
  recording.settings = "";
  recording.command = {"motor angle", "°"};
  write_recording(path_, recording);
  const H5::H5File file(path_.string(), H5F_ACC_RDONLY);
  int texts = 0;
  const auto look_at = [&](const H5::H5Object& object) {
    for (int i = 0; i < object.getNumAttrs(); ++i) {
      const H5::Attribute attribute = object.openAttribute(static_cast<unsigned>(i));
      if (attribute.getTypeClass() == H5T_STRING) {
        EXPECT_FALSE(attribute.getDataType().isVariableStr()) << attribute.getName();
        ++texts;
      }
    }
  };
  look_at(file);
  const H5::Group episode = file.openGroup("episodes/000000");
  for (hsize_t i = 0; i < episode.getNumObjs(); ++i) {
    look_at(episode.openDataSet(episode.getObjnameByIdx(i)));
  }
  EXPECT_EQ(texts, 9 + 6);
  EXPECT_EQ(read_recording(path_).arm_description, recording.arm_description);
  EXPECT_EQ(read_recording(path_).command.unit, "°");
  EXPECT_EQ(read_recording(path_).settings, "");
}

// An attribute holds 64 kB.
TEST_F(RecordingFile, KeepsLongTexts) {
  for (const std::size_t bytes : {63'999, 64'000, 64'001, 65'536, 3'000'000}) {
    Recording recording = test_recording();
    recording.arm_description = std::string(bytes, 'a');
    recording.settings = std::string(bytes - 1, 'b') + "c";
    write_recording(path_, recording);
    const Recording read = read_recording(path_);
    EXPECT_TRUE(read.arm_description == recording.arm_description) << bytes;
    EXPECT_TRUE(read.settings == recording.settings) << bytes;
    const std::string before = read_file(path_);
    write_recording(path_, recording);
    EXPECT_TRUE(read_file(path_) == before) << bytes;
  }
}

// Readers refuse chunks of over 4 million numbers.
TEST_F(RecordingFile, IsReadOfAnArmOfVeryManyPointsToo) {
  const Recording written = test_recording(1, 1024, 2, 1400);
  write_recording(path_, written);
  EXPECT_TRUE(read_recording(path_).episodes[0].backbone == written.episodes[0].backbone);
}

TEST_F(RecordingFile, IsTheSameToTheByteWhenWrittenLater) {
  const std::string before = read_file(path_);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 stamps whole seconds
  write_recording(path_, test_recording());
  EXPECT_EQ(read_file(path_), before);
}

TEST_F(RecordingFile, CountsEveryFrameAsTrackedWhereNothingElseIsSaid) {
  Recording recording = test_recording(1);
  recording.episodes[0].tracked.clear();
  write_recording(path_, recording);
  EXPECT_EQ(read_recording(path_).episodes[0].tracked, std::vector<std::uint8_t>(5, 1));
  {
    H5::H5File file(path_.string(), H5F_ACC_RDWR);
    file.unlink("episodes/000000/tracked");
  }
  EXPECT_EQ(read_recording(path_).untracked_count(), 0);
}

TEST_F(RecordingFile, IsWrittenAndReadBySeveralThreadsAtOnce) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([this, i] {
      const fs::path path = folder_.path() / (std::to_string(i) + ".h5");
      for (int k = 0; k < 5; ++k) {
        write_recording(path, test_recording(1, 3 + i));
        EXPECT_EQ(read_recording(path).frame_count(), 3 + i);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
}

TEST_F(RecordingFile, PrintsNothingOfItsOwnWhenAFileIsBroken) {
  write_file_atomically(path_, "not HDF5 at all");
  ::testing::internal::CaptureStderr();
  EXPECT_THROW(read_recording(path_), InputError);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(RecordingFile, RefusesWhatIsNoRecording) {
  EXPECT_THAT([this] { read_recording(folder_.path() / "none.h5"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("none.h5"), HasSubstr("no such file"))));
  EXPECT_THAT([this] { read_recording(folder_.path()); },
              ThrowsMessage<InputError>(HasSubstr("is a folder")));
  for (const char* content : {"", "schema: limber/arm/1\n", "\x89HDF"}) {
    write_file_atomically(path_, content);
    expect_refused({"not an HDF5 file; expected a recording, schema 'limber/recording/1'"});
  }
}

TEST_F(RecordingFile, RefusesAFileCutShortAnywhere) {
  const std::string whole = read_file(path_);
  for (const double fraction : {0.01, 0.2, 0.5, 0.9, 0.999}) {
    const auto size = static_cast<std::size_t>(fraction * static_cast<double>(whole.size()));
    write_file_atomically(path_, whole.substr(0, size));
    expect_refused({"cut short"});
  }
}

TEST_F(RecordingFile, RefusesChangedBytesByTheirChecksum) {
  std::string content = read_file(path_);
  hsize_t offset = 0;
  {
    H5::H5File file(path_.string(), H5F_ACC_RDONLY);
    const H5::DataSet data_set = file.openDataSet("episodes/000001/backbone");
    unsigned mask = 0;
    hsize_t size = 0;
    haddr_t address = 0;
    ASSERT_GE(H5Dget_chunk_info(data_set.getId(), data_set.getSpace().getId(), 0, nullptr, &mask,
                                &address, &size),
              0);
    offset = address + size / 2;
  }
  content[offset] = static_cast<char>(content[offset] ^ 0x10);
  write_file_atomically(path_, content);
  expect_refused({"episodes/000001/backbone: can't be read", "damaged"});
}

TEST_F(RecordingFile, RefusesAnotherSchema) {
  expect_refusal([](H5::H5File& f) { set_attribute(f, "schema", "limber/recording/2"); },
                 {"'limber/recording/2' found; this program reads 'limber/recording/1'"});
  expect_refusal([](H5::H5File& f) { f.removeAttr("schema"); },
                 {"attribute 'schema': missing; this program reads 'limber/recording/1'"});
}

TEST_F(RecordingFile, RefusesMissingOrMistypedAttributes) {
  for (const char* name : {"arm_name", "arm_hash", "source", "program_version", "rate_hz",
                           "segments", "points", "seed"}) {
    write_recording(path_, test_recording());
    expect_refusal([&](H5::H5File& f) { f.removeAttr(name); },
                   {std::string("attribute '") + name + "': missing"});
  }
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_attribute(f, "rate_hz", "20 Hz"); },
                 {"attribute 'rate_hz': not a number"});
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_number(f, "segments", H5::PredType::NATIVE_DOUBLE, 2.5); },
                 {"attribute 'segments': not a whole number"});
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_number(f, "arm_name", H5::PredType::NATIVE_INT, 3); },
                 {"attribute 'arm_name': not a text"});
}

TEST_F(RecordingFile, RefusesImpossibleAttributes) {
  for (const double rate : {0.0, -20.0, std::numeric_limits<double>::quiet_NaN()}) {
    write_recording(path_, test_recording());
    expect_refusal(
        [&](H5::H5File& f) { set_number(f, "rate_hz", H5::PredType::NATIVE_DOUBLE, rate); },
        {"attribute 'rate_hz' is", "expected a rate in Hz, > 0"});
  }
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_number(f, "segments", H5::PredType::NATIVE_INT, -1); },
                 {"attribute 'segments' is -1"});
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_number(f, "points", H5::PredType::NATIVE_INT, 3); },
                 {"episodes/000000/backbone: shape 5 × 4 × 3 found; expected 5 × 3 × 3"});
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_number(f, "points", H5::PredType::NATIVE_INT, 1); },
                 {"attribute 'points' is 1; expected a whole number ≥ 2"});
}

TEST_F(RecordingFile, RefusesMissingGroupsAndDataSets) {
  for (const char* name : {"time_s", "pressure_kpa", "setpoint_kpa", "backbone", "motion_index"}) {
    write_recording(path_, test_recording());
    const std::string path = std::string("episodes/000001/") + name;
    expect_refusal([&](H5::H5File& f) { f.unlink(path); }, {path + ": data set missing"});
  }
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { f.unlink("episodes/000000"); },
                 {"episodes/000000: missing; 'episodes' holds 1 entries"});
  expect_refusal([](H5::H5File& f) { f.unlink("episodes/000001"); },
                 {"episodes: none found; expected at least one"});
  expect_refusal([](H5::H5File& f) { f.unlink("episodes"); }, {"episodes: group missing"});
}

TEST_F(RecordingFile, RefusesWrongShapesAndTypes) {
  const H5::PredType& real = H5::PredType::NATIVE_FLOAT;
  expect_refusal(
      [&](H5::H5File& f) {
        replace_data_set(f, "episodes/000000/backbone", real, {5, 3, 3});
      },
      {"episodes/000000/backbone: shape 5 × 3 × 3 found; expected "
       "5 × 4 × 3: frames × points × [x_m, y_m, theta_rad]"});
  write_recording(path_, test_recording());
  expect_refusal(
      [&](H5::H5File& f) {
        replace_data_set(f, "episodes/000000/pressure_kpa", real, {4, 2});
      },
      {"episodes/000000/pressure_kpa: shape 4 × 2 found; expected 5 × 2: frames × segments"});
  write_recording(path_, test_recording());
  expect_refusal(
      [&](H5::H5File& f) {
        replace_data_set(f, "episodes/000001/time_s", real, {5, 1});
      },
      {"episodes/000001/time_s: shape 5 × 1 found; expected one time a frame"});
  write_recording(path_, test_recording());
  expect_refusal([&](H5::H5File& f) { replace_data_set(f, "episodes/000001/time_s", real, {0}); },
                 {"episodes/000001/time_s: no frames"});
  write_recording(path_, test_recording());
  expect_refusal(
      [](H5::H5File& f) {
        replace_data_set(f, "episodes/000000/motion_index", H5::PredType::C_S1, {5});
      },
      {"episodes/000000/motion_index: holds no numbers"});
}

TEST_F(RecordingFile, TrackedMayBeBooleansOfNumPy) {
  {
    H5::H5File file(path_, H5F_ACC_RDWR);
    constexpr const char* kTracked = "episodes/000001/tracked";
    file.unlink(kTracked);
    H5::EnumType boolean(H5::PredType::STD_I8LE);
    std::array<std::int8_t, 2> values{0, 1};
    boolean.insert("FALSE", &values[0]);
    boolean.insert("TRUE", &values[1]);
    const std::vector<std::int8_t> tracked{1, 0, 1, 1, 1};
    const hsize_t frames = tracked.size();
    file.createDataSet(kTracked, boolean, H5::DataSpace(1, &frames)).write(tracked.data(), boolean);
  }
  EXPECT_THAT(read_recording(path_).episodes[1].tracked, testing::ElementsAre(1, 0, 1, 1, 1));
}

TEST_F(RecordingFile, RefusesAnotherUnit) {
  expect_refusal(
      [](H5::H5File& f) {
        H5::DataSet pressures = f.openDataSet("episodes/000000/pressure_kpa");
        set_attribute(pressures, "unit", "psi");
      },
      {"episodes/000000/pressure_kpa: unit 'psi' found; expected 'kPa'"});
}

TEST_F(RecordingFile, RefusesNumbersThatAreNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const char* name : {"pressure_kpa", "setpoint_kpa", "backbone"}) {
    write_recording(path_, test_recording());
    const std::string path = std::string("episodes/000001/") + name;
    expect_refusal(
        [&](H5::H5File& f) { overwrite(f, path.c_str(), H5::PredType::NATIVE_FLOAT, 1, nan); },
        {path + ": frame 0, number 1 is nan; expected a finite number"});
  }
}

TEST_F(RecordingFile, RefusesTimesAndMotionsThatGoBack) {
  expect_refusal(
      [](H5::H5File& f) {
        overwrite(f, "episodes/000001/time_s", H5::PredType::NATIVE_DOUBLE, 3, 0.1);
      },
      {"episodes/000001/time_s: frame 3 at 0.1 s follows frame 2 at 0.1 s"});
  write_recording(path_, test_recording());
  expect_refusal(
      [](H5::H5File& f) {
        overwrite(f, "episodes/000001/motion_index", H5::PredType::NATIVE_INT, 2, -4);
      },
      {"episodes/000001/motion_index: frame 2 is -4; expected 0 or more"});
}

TEST_F(RecordingFile, IsNotTouchedByARefusedOrFailedWrite) {
  const std::string before = read_file(path_);
  Recording broken = test_recording();
  broken.episodes[1].backbone(2, 3) = std::numeric_limits<float>::infinity();
  EXPECT_THAT([&] { write_recording(path_, broken); },
              ThrowsMessage<InputError>(HasSubstr("episodes/000001/backbone: frame 2, number 3")));
  EXPECT_EQ(read_file(path_), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
  EXPECT_THAT([&] { write_recording("/proc/none/run.h5", test_recording()); },
              ThrowsMessage<SystemFault>(HasSubstr("/proc/none")));
}

TEST_F(RecordingFile, KeepsAnotherCommandWithItsNameAndUnit) {
  Recording recording = test_recording();
  recording.command = {"motor angle", "rad"};
  write_recording(path_, recording);
  {
    const H5::H5File file(path_.string(), H5F_ACC_RDONLY);
    EXPECT_TRUE(file.nameExists("episodes/000000/command"));
    EXPECT_FALSE(file.nameExists("episodes/000000/pressure_kpa"));
  }
  const Recording read = read_recording(path_);
  EXPECT_EQ(read.command.name, "motor angle");
  EXPECT_EQ(read.command.unit, "rad");
  EXPECT_EQ(read.episodes[1].pressure_kpa, recording.episodes[1].pressure_kpa);
  expect_refusal(
      [](H5::H5File& f) {
        H5::DataSet commands = f.openDataSet("episodes/000000/command");
        set_attribute(commands, "unit", "deg");
      },
      {"episodes/000000/command: unit 'deg' found; expected 'rad'"});
}

TEST_F(RecordingFile, RefusesNamesThatAreNotUtf8) {
  Recording recording = test_recording();
  recording.arm_name = "caf\xE9";
  EXPECT_THAT([&] { write_recording(path_, recording); },
              ThrowsMessage<InputError>(HasSubstr("not UTF-8")));
  expect_refusal([](H5::H5File& f) { set_attribute(f, "arm_name", "caf\xE9"); },
                 {"attribute 'arm_name': not a text in UTF-8"});
}

}  // namespace
}  // namespace limber
