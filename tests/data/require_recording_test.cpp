#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/data/recording.hpp"
#include "limber/data/recording_inspection.hpp"
#include "support/test_recording.hpp"

namespace limber {
namespace {

using ::testing::_;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Two segments, five plates 0.1 m apart.
ArmDescription small_arm(const char* name) {
  ArmDescription arm;
  arm.name = name;
  arm.frame_rate_hz = 20.0;
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.segments.assign(2, Segment{0.2, 0.05, 2, 100.0, {1e-3, 0, 0, 0}});
  return arm;
}

/// A recording of it whose plates lie along a line that turns about the base.
Recording turning_recording(int frames) {
  Recording recording = test_recording(1, frames, 2, 5);
  FrameMatrix& backbone = recording.episodes[0].backbone;
  for (int t = 0; t < frames; ++t) {
    const float angle = 0.5F * std::sin(0.2F * static_cast<float>(t));
    for (int plate = 0; plate < 5; ++plate) {
      const float x = 0.1F * static_cast<float>(plate);
      backbone.row(t).segment<3>(3 * plate) << x * std::cos(angle), x * std::sin(angle), angle;
    }
  }
  return recording;
}

TEST(RequireRecordingOf, NamesWhatDiffersFromTheArm) {
  ArmDescription arm;
  arm.name = "mine";
  arm.frame_rate_hz = 20.0;
  arm.segments = {Segment{0.2, 0.05, 2, 100.0, {1e-3, 0, 0, 0}},
                  Segment{0.2, 0.05, 1, 100.0, {1e-3, 0, 0, 0}}};
  Recording recording = test_recording();
  EXPECT_NO_THROW(require_sizes_of(recording, arm, "a.h5"));
  recording.command = {"motor angle", "rad"};
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("the command 'motor angle' in rad; "
                                                  "arm 'mine' has 'pressure' in kPa")));
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
              ThrowsMessage<InputError>(HasSubstr("100 frames per second; arm 'mine' has 20")));
}

// Other shares make other commands of segments of the same logs, whatever the arm is called.
TEST(RequireRecordingOf, RefusesOneWhoseCommandsWereSummedOtherwise) {
  ArmDescription arm = small_arm("mine");
  const std::string without = arm_keys_to_yaml(arm);
  arm.commands = {{"a", {1.0, 0.0}}, {"b", {-1.0, 0.0}}, {"c", {0.0, 1.0}}};
  Recording recording = turning_recording(40);
  recording.arm_name = "mine";
  recording.arm_hash = "0";
  recording.arm_description = arm_keys_to_yaml(arm);
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5"));
  recording.arm_description = without;
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "of segments' commands";
  recording.arm_description = arm_keys_to_yaml(arm);
  arm.commands[1].shares[0] = -0.5;
  EXPECT_THAT(
      [&] { require_recording_of(recording, arm, "a.h5"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("commands[1].acts_on[0]: -1 there, -0.5 here"),
                                      HasSubstr("import its logs again"))));
}

TEST(RequireRecordingOf, TakesTheSameArmRenamedOrEditedAndRefusesAnother) {
  const ArmDescription arm = small_arm("mine");
  Recording recording = turning_recording(40);
  recording.arm_name = "mine";
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "edited since";
  recording.arm_name = "other";
  recording.arm_hash = arm.hash();
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "renamed since";
  ArmDescription elsewhere = arm;
  elsewhere.segments[0].strain_polynomial[0] += 1e-9;
  recording.arm_hash = elsewhere.hash();
  recording.arm_description = arm_keys_to_yaml(elsewhere);
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "renamed, fitted elsewhere";
  elsewhere.segments[1].length_m = 0.3;
  recording.arm_hash = "0";
  recording.arm_description = arm_keys_to_yaml(elsewhere);
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("segments[1].length_m: 0.3 there, 0.2 here")));
  recording.arm_description.clear();
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("recorded with arm 'other' (hash 0)"),
                                              HasSubstr("Give the arm file"))));
}

TEST(RequireRecordingOf, RefusesWhatLiesFarBeyondTheLimits) {
  const ArmDescription arm = small_arm("test arm");
  const auto refusal = [&](const Recording& recording) {
    return [&] { require_recording_of(recording, arm, "a.h5"); };
  };
  Recording recording = turning_recording(4000);
  recording.episodes[0].pressure_kpa(7, 1) = 130.0F;
  EXPECT_NO_THROW(refusal(recording)()) << "a single spike";
  recording.episodes[0].pressure_kpa(7, 1) = 310.0F;
  EXPECT_THAT(refusal(recording), ThrowsMessage<InputError>(
                                      AllOf(HasSubstr("a.h5: episodes/000000, measured: segment 1 "
                                                      "is at 310 kPa in frame 7"),
                                            HasSubstr("the limit of arm 'test arm' is 100 kPa"),
                                            HasSubstr("import it again"))));
  recording = turning_recording(4000);
  recording.episodes[0].setpoint_kpa *= 6.894757F;
  EXPECT_THAT(refusal(recording), ThrowsMessage<InputError>(HasSubstr("set points: segment 0")));
}

TEST(RequireRecordingOf, RefusesWhatWasNeverTracked) {
  const ArmDescription arm = small_arm("test arm");
  Recording recording = turning_recording(40);
  recording.episodes[0].tracked.assign(40, 0);
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("tracked in none of its 40 frames")));
}

TEST(RequireRecordingOf, RefusesPlatesThatAreNotAsFarApartAsTheArms) {
  const ArmDescription arm = small_arm("test arm");
  const auto refusal = [&](const Recording& recording) {
    return [&] { require_recording_of(recording, arm, "a.h5"); };
  };
  Recording stretched = turning_recording(200);
  stretched.episodes[0].backbone *= 1.3F;
  EXPECT_NO_THROW(refusal(stretched)()) << "an arm that stretches";
  Recording single = turning_recording(200);
  single.episodes[0].backbone.middleRows(3, 60).setConstant(7.0F);
  EXPECT_NO_THROW(refusal(single)()) << "less than half of the frames";
  Recording millimetres = turning_recording(200);
  millimetres.episodes.push_back(millimetres.episodes[0]);
  millimetres.episodes[1].backbone *= 1000.0F;
  EXPECT_THAT(refusal(millimetres),
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("a.h5: episodes/000001: plates 0 and 1 are 100 m apart"),
                        HasSubstr("arm 'test arm' has 0.1 m there, and 0.05 to 0.15 m are allowed"),
                        HasSubstr("It should be in m: is it in mm?"))));
  Recording swapped = turning_recording(200);
  FrameMatrix& backbone = swapped.episodes[0].backbone;
  const FrameMatrix second = backbone.middleCols(6, 3);
  backbone.middleCols(6, 3) = backbone.middleCols(9, 3);
  backbone.middleCols(9, 3) = second;
  EXPECT_THAT(refusal(swapped),
              ThrowsMessage<InputError>(AllOf(HasSubstr("plates 1 and 2 are 0.2 m apart"),
                                              HasSubstr("Are the plates in order"))));
  // What was not seen says nothing.
  single.episodes[0].backbone.setConstant(7.0F);
  single.episodes[0].tracked.assign(200, 0);
  single.episodes.push_back(turning_recording(200).episodes[0]);
  EXPECT_NO_THROW(refusal(single)());
}

TEST(RequireRecordingOf, RefusesAnArmThatStandsStillUnderChangingPressures) {
  const ArmDescription arm = small_arm("test arm");
  Recording recording = turning_recording(200);
  recording.episodes.push_back(recording.episodes[0]);
  Episode& still = recording.episodes[1];
  for (int t = 1; t < 200; ++t) {
    still.backbone.row(t) = still.backbone.row(0);
    still.backbone(t, 12) += 1e-4F * static_cast<float>(t % 5);  // a tracker's noise
  }
  EXPECT_THAT([&] { require_recording_of(recording, arm, "a.h5"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("a.h5: episodes/000001: the arm's end stands still (its position "
                                  "spreads by 0.14 mm; expected at least 0.8 mm)"),
                        HasSubstr("the pressure of segment 0 changes by 180 kPa"))));
  const FrameMatrix told_kpa = still.pressure_kpa;
  still.pressure_kpa.setConstant(30.0F);
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "an arm at rest";
  still.pressure_kpa.bottomRows(100) = told_kpa.bottomRows(100);
  std::fill(still.tracked.begin() + 100, still.tracked.end(), std::uint8_t{0});
  EXPECT_NO_THROW(require_recording_of(recording, arm, "a.h5")) << "nobody saw it move";
}

// One frame at 1e30 m ruins every mean and range that is taken of it.
TEST(RequireRecordingOf, RefusesAPlateThatNoArmReachesInASingleFrame) {
  const ArmDescription arm = small_arm("test arm");
  const auto refusal_of = [&](int column, float value) {
    Recording recording = turning_recording(200);
    recording.episodes[0].backbone(7, column) = value;
    return [&arm, recording] { require_recording_of(recording, arm, "a.h5"); };
  };
  EXPECT_NO_THROW(refusal_of(12, 9.0F)()) << "something else that was tracked";
  EXPECT_THAT(refusal_of(12, 1e30F),
              ThrowsMessage<InputError>(AllOf(
                  HasSubstr("a.h5: episodes/000000: frame 7: plate 4 is 1e+30 m from the base"),
                  HasSubstr("arm 'test arm' is 0.4 m long, and up to 40 m"))));
  EXPECT_THAT(
      refusal_of(0, -400.0F),
      ThrowsMessage<InputError>(HasSubstr("frame 7: plate 0 is 400 m from where the base")));
  EXPECT_THAT(refusal_of(14, 180.0F), ThrowsMessage<InputError>(HasSubstr("plate 4 is turned by")));
  Recording untracked = turning_recording(200);
  untracked.episodes[0].tracked.assign(200, 1);
  untracked.episodes[0].tracked[7] = 0;
  untracked.episodes[0].backbone(7, 12) = 1e30F;
  EXPECT_NO_THROW(require_recording_of(untracked, arm, "a.h5")) << "nobody saw it there";
}

TEST(RequireEpisodesOf, RefusesEpisodesOfAnotherArmAndHalfMadeOnes) {
  const ArmDescription arm = small_arm("mine");
  const std::vector<Episode> good = turning_recording(40).episodes;
  EXPECT_NO_THROW(require_episodes_of(good, arm));
  EXPECT_NO_THROW(require_episodes_of(good, NoLoadModel(arm)));
  const auto refusal_of = [&](const std::function<void(Episode&)>& change) {
    std::vector<Episode> episodes = {good[0], good[0]};
    change(episodes[1]);
    return [&arm, episodes] { require_episodes_of(episodes, arm, "the data"); };
  };
  EXPECT_THAT(refusal_of([](Episode& e) { e.pressure_kpa.setZero(40, 3); }),
              ThrowsMessage<InputError>(
                  HasSubstr("the data: episodes/000001 has 3 segments; arm 'mine' has 2")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.setpoint_kpa.setZero(40, 1); }),
              ThrowsMessage<InputError>(HasSubstr("has 1 segments; arm 'mine' has 2")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.backbone.setZero(40, 12); }),
              ThrowsMessage<InputError>(HasSubstr("4 backbone points; arm 'mine' has 5")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.backbone.setZero(39, 15); }),
              ThrowsMessage<InputError>(HasSubstr("backbone: 39 × 15 numbers found")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.motion_index.pop_back(); }),
              ThrowsMessage<InputError>(HasSubstr("motion_index: 39 numbers found")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.tracked.pop_back(); }),
              ThrowsMessage<InputError>(HasSubstr("tracked: 39 numbers found")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.time_s.reverseInPlace(); }),
              ThrowsMessage<InputError>(HasSubstr("expected times to increase")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.pressure_kpa(3, 1) = NAN; }),
              ThrowsMessage<InputError>(HasSubstr("frame 3, number 1 is nan")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.backbone *= 1000.0F; }),
              ThrowsMessage<InputError>(HasSubstr("should be in m")));
  EXPECT_THAT(refusal_of([](Episode& e) { e.pressure_kpa *= 1000.0F; }),
              ThrowsMessage<InputError>(HasSubstr("the limit of arm 'mine' is")));
  EXPECT_THAT(refusal_of([](Episode& e) { e = Episode{}; }), ThrowsMessage<InputError>(_));
}

TEST(RequireAlike, RefusesEpisodesOfSeveralSizes) {
  const Episode small = test_recording(1, 5, 2, 4).episodes[0];
  EXPECT_NO_THROW(require_alike({small, small}));
  EXPECT_THAT(
      [&] {
        require_alike({small, test_recording(1, 5, 3, 4).episodes[0]});
      },
      ThrowsMessage<InputError>(HasSubstr("episodes/000001/pressure_kpa: 5 × 3 numbers")));
  EXPECT_THAT([&] { require_alike({small}, 2, 5); },
              ThrowsMessage<InputError>(HasSubstr("episodes/000000/backbone: 5 × 12 numbers")));
}

// Networks of plate-relative poses never see where the base lies.
TEST(BaseWarning, SaysWhereTheBaseLiesOnAverage) {
  Recording recording = turning_recording(200);
  Episode& episode = recording.episodes[0];
  episode.backbone.leftCols(3).setZero();
  EXPECT_EQ(base_warning(recording), "");
  for (int t = 0; t < 200; ++t) {  // noise about zero, and a full turn, are none
    episode.backbone(t, 0) = t % 2 == 0 ? 0.004F : -0.004F;
    episode.backbone(t, 2) = static_cast<float>(t % 2 == 0 ? 2.0 * M_PI : 0.0);
  }
  EXPECT_EQ(base_warning(recording), "");
  episode.backbone.col(2).setConstant(0.05F);
  EXPECT_THAT(base_warning(recording),
              AllOf(HasSubstr("(0.000, 0.000) m, 0.050 rad (episodes/000000"),
                    HasSubstr("'alignment: base'")));
  episode.backbone.col(2).setZero();
  episode.backbone.col(1).setConstant(-0.003F);
  EXPECT_THAT(base_warning(recording), HasSubstr("-0.003) m, 0.000 rad"));
}

}  // namespace
}  // namespace limber
