// Recordings across languages: h5py, an independent reader and writer, on both ends.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/data/recording.hpp"
#include "support/run_command.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_recording.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

CommandResult python(const std::string& script, const std::string& arguments) {
  return run_command(
      fmt::format("'{}' '{}/{}' {}", LIMBER_PYTHON, LIMBER_SOURCE_DIR, script, arguments));
}

class RecordingInPython : public ::testing::Test {
 protected:
  void SetUp() override {
    if (run_command(fmt::format("'{}' -c 'import h5py'", LIMBER_PYTHON)).code != 0) {
      GTEST_SKIP() << "no Python with h5py (Debian: python3-h5py)";
    }
  }
  TemporaryFolder folder_;
};

TEST_F(RecordingInPython, ReadsWhatWasWrittenHere) {
  const std::string path = folder_.path() / "run.h5";
  const Recording recording = test_recording();
  write_recording(path, recording);
  const CommandResult result = python("tests/python/check_recording.py", path);
  ASSERT_EQ(result.code, 0) << result.output;
  double backbone_sum = 0.0;
  double pressure_sum = 0.0;
  for (const Episode& episode : recording.episodes) {
    backbone_sum += episode.backbone.cast<double>().sum();
    pressure_sum += episode.pressure_kpa.cast<double>().sum();
  }
  EXPECT_EQ(result.output,
            fmt::format("limber/recording/1 test arm 20.0 18446744073709551615\n"
                        "2 episodes, backbone (5, 4, 3), pressure (5, 2), units m, m, rad and kPa\n"
                        "sums {:.9f} {:.9f}\n",
                        backbone_sum, pressure_sum));
}

TEST_F(RecordingInPython, WritesWhatIsReadHere) {
  const std::string path = folder_.path() / "python.h5";
  const CommandResult result = python("tests/python/write_recording.py", path);
  ASSERT_EQ(result.code, 0) << result.output;
  const Recording recording = read_recording(path);
  EXPECT_EQ(recording.arm_name, "from python");
  EXPECT_EQ(recording.segment_count, 1);
  ASSERT_EQ(recording.episodes.size(), 1U);
  const Episode& episode = recording.episodes[0];
  ASSERT_EQ(episode.frame_count(), 4);
  EXPECT_FLOAT_EQ(episode.pressure_kpa(3, 0), 30.0F);
  EXPECT_FLOAT_EQ(episode.backbone(2, 5), 0.5F);  // frame 2, point 1, theta
  EXPECT_EQ(episode.untracked_count(), 0);
}

TEST_F(RecordingInPython, ExampleRunsAndSaysWhatTheFileHolds) {
  const std::string path = folder_.path() / "run.h5";
  write_recording(path, test_recording());
  const CommandResult result = python("examples/read_recording.py", path);
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("arm 'test arm', 2 segments, 4 points, 20 Hz"));
  EXPECT_THAT(result.output, HasSubstr("2 episodes, 10 frames, 2 of them not tracked"));
}

}  // namespace
}  // namespace limber
