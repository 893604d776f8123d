#include "limber/data/recording_part.hpp"

#include <cmath>

#include "recording_file.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST_F(RecordingFile, GivesSomeOfItsEpisodesUnderTheirNumbers) {
  const Recording written = test_recording();
  ASSERT_EQ(written.episodes.size(), 2U);
  const std::vector<int> second = {1};
  const Recording part = read_recording_part(path_, second);
  ASSERT_EQ(part.episodes.size(), 1U);
  EXPECT_EQ(part.episodes[0].backbone, written.episodes[1].backbone);
  EXPECT_EQ(part.rate_hz, written.rate_hz);
  EXPECT_EQ(part.number(0), 1U);
  const std::vector<int> none = {7};
  EXPECT_THAT([&] { (void)read_recording_part(path_, none); },
              ThrowsMessage<InputError>(HasSubstr("episodes/000007: no such episode")));
  {
    H5::H5File file(path_.string(), H5F_ACC_RDWR);
    overwrite(file, "episodes/000001/backbone", H5::PredType::NATIVE_FLOAT, 0, NAN);
  }
  EXPECT_THAT([&] { (void)read_recording_part(path_, second); },
              ThrowsMessage<InputError>(HasSubstr("episodes/000001")));
}

TEST_F(RecordingFile, GivesTimesAndPhysicsWithoutItsFrames) {
  Recording varied = test_recording();
  varied.episodes.back().physics = "{}";
  write_recording(path_, varied);
  const Recording outline = read_recording_outline(path_);
  ASSERT_EQ(outline.episodes.size(), 2U);
  EXPECT_EQ(outline.frame_count(), varied.frame_count());
  EXPECT_EQ(outline.episodes.back().time_s, varied.episodes.back().time_s);
  EXPECT_EQ(outline.episodes.back().physics, "{}");
  EXPECT_EQ(outline.episodes.back().backbone.size(), 0);
}

}  // namespace
}  // namespace limber
