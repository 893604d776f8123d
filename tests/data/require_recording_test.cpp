#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/data/recording.hpp"
#include "support/test_recording.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(RequireRecordingOf, NamesWhatDiffersFromTheArm) {
  ArmDescription arm;
  arm.name = "mine";
  arm.frame_rate_hz = 20.0;
  arm.segments = {Segment{0.2, 0.05, 2, 100.0, {1e-3, 0, 0, 0}},
                  Segment{0.2, 0.05, 1, 100.0, {1e-3, 0, 0, 0}}};
  Recording recording = test_recording();
  EXPECT_NO_THROW(require_sizes_of(recording, arm, "a.h5"));
  recording.command = {"motor angle", "rad"};
  EXPECT_THAT(
      [&] { require_recording_of(recording, arm, "a.h5"); },
      ThrowsMessage<InputError>(HasSubstr("the command 'motor angle' in rad; arm 'mine' has "
                                          "'pressure' in kPa")));
  recording.command = {};
  recording.segment_count = 5;
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr(
                  "a.h5: recording of arm 'test arm' has 5 segments; arm 'mine' has 2. Give "
                  "the arm file that it was recorded with")));
  recording.segment_count = 2;
  recording.point_count = 7;
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("7 backbone points; arm 'mine' has 4")));
  recording.point_count = 4;
  recording.rate_hz = 100.0;
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("100 frames a second; arm 'mine' has 20")));
}

TEST(RequireRecordingOf, TakesTheSameArmRenamedOrEditedAndRefusesAnother) {
  ArmDescription arm;
  arm.name = "mine";
  arm.frame_rate_hz = 20.0;
  arm.segments.assign(2, Segment{0.2, 0.05, 2, 100.0, {1e-3, 0, 0, 0}});
  Recording recording = test_recording(1, 40, 2, 5);
  recording.arm_name = "mine";
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "edited since";
  recording.arm_name = "other";
  recording.arm_hash = arm.hash();
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "renamed since";
  recording.arm_hash = "0";
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("recorded with arm 'other' (hash 0)"),
                                              HasSubstr("Give the arm file"))));
}

TEST(RequireRecordingOf, RefusesWhatLiesFarBeyondTheLimits) {
  ArmDescription arm;
  arm.name = "test arm";
  arm.frame_rate_hz = 20.0;
  arm.segments.assign(2, Segment{0.2, 0.05, 2, 100.0, {1e-3, 0, 0, 0}});
  const auto refusal = [&](const Recording& recording) {
    return [&] { require_recording_of(recording, arm, "a.h5"); };
  };
  Recording recording = test_recording(1, 4000, 2, 5);
  recording.episodes[0].pressure_kpa(7, 1) = 130.0F;
  EXPECT_NO_THROW(refusal(recording)()) << "a single spike";
  recording.episodes[0].pressure_kpa(7, 1) = 310.0F;
  EXPECT_THAT(refusal(recording), ThrowsMessage<InputError>(
                                      AllOf(HasSubstr("a.h5: episodes/000000, measured: segment 1 "
                                                      "is at 310 kPa in frame 7"),
                                            HasSubstr("the limit of arm 'test arm' is 100 kPa"),
                                            HasSubstr("import it again"))));
  recording = test_recording(1, 4000, 2, 5);
  recording.episodes[0].setpoint_kpa *= 6.894757F;
  EXPECT_THAT(refusal(recording), ThrowsMessage<InputError>(HasSubstr("set points: segment 0")));
}

TEST(RequireRecordingOf, RefusesWhatWasNeverTracked) {
  ArmDescription arm;
  arm.name = "test arm";
  arm.frame_rate_hz = 20.0;
  arm.segments.assign(2, Segment{0.2, 0.05, 2, 100.0, {1e-3, 0, 0, 0}});
  Recording recording = test_recording(1, 40, 2, 5);
  recording.episodes[0].tracked.assign(40, 0);
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("tracked in none of its 40 frames")));
}

}  // namespace
}  // namespace limber
