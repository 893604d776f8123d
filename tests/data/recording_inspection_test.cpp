#include "limber/data/recording_inspection.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/data/log_units.hpp"
#include "support/test_recording.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

constexpr float kLimit_kpa = 100.0F;
constexpr int kFramesPerMotion = 12;

ArmDescription one_segment_arm() {
  ArmDescription arm;
  arm.name = "one";
  arm.segments = {Segment{0.2, 0.05, 2, kLimit_kpa, {1e-3, 0, 0, 0}}};
  return arm;
}

/// One segment, led through `states` (−1 left, 0 off, 1 right), the first one at frame 0; a
/// straight arm of three points.
Recording corner_recording(const std::vector<int>& states) {
  Recording recording = test_recording(1, 1, 1, 3);
  recording.arm_name = one_segment_arm().name;
  recording.arm_hash = one_segment_arm().hash();
  const int frames = 1 + kFramesPerMotion * (static_cast<int>(states.size()) - 1);
  Episode& episode = recording.episodes[0];
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) / recording.rate_hz);
  episode.setpoint_kpa.resize(frames, 1);
  episode.backbone.resize(frames, 9);
  episode.motion_index.assign(static_cast<std::size_t>(frames), 0);
  episode.tracked.assign(static_cast<std::size_t>(frames), 1);
  for (int t = 0; t < frames; ++t) {
    const int motion = t == 0 ? 0 : (t - 1) / kFramesPerMotion;
    const int state = t == 0 ? states[0] : states[static_cast<std::size_t>(motion) + 1];
    episode.setpoint_kpa(t, 0) = kLimit_kpa * static_cast<float>(state);
    episode.motion_index[static_cast<std::size_t>(t)] = motion;
    // A little motion, so that nothing stands still to the bit.
    const float y = 1e-4F * static_cast<float>(t % 2);
    episode.backbone.row(t) << 0.0F, 0.0F, 0.0F, 0.1F, y, 0.0F, 0.2F, y, 0.0F;
  }
  episode.pressure_kpa = episode.setpoint_kpa;
  return recording;
}

RecordingInspection inspect_it(const Recording& recording) {
  return inspect(recording, nullptr, "a.h5");
}

TEST(TransitionCoverage, CountsEachDifferentTransitionOnce) {
  const Recording recording = corner_recording({0, 1, -1, -1, 0, 1, -1});
  const TransitionCoverage coverage = transition_coverage(recording, {kLimit_kpa});
  EXPECT_EQ(coverage.possible, 9.0);
  EXPECT_EQ(coverage.attempted, 4);  // 0→1, 1→−1, −1→−1, −1→0; the last two again
  EXPECT_EQ(coverage.covered, 4);
}

TEST(TransitionCoverage, CountsOnlyWhereBothEndsWereReached) {
  Recording recording = corner_recording({0, 1, -1, 0});
  Episode& episode = recording.episodes[0];
  const int end_of_second = 2 * kFramesPerMotion;
  episode.pressure_kpa(end_of_second, 0) = -97.0F;  // the tolerance is 2 kPa
  const TransitionCoverage coverage = transition_coverage(recording, {kLimit_kpa});
  EXPECT_EQ(coverage.attempted, 3);
  EXPECT_EQ(coverage.covered, 1) << "neither what ends there nor what starts there";
  episode.pressure_kpa(end_of_second, 0) = -98.5F;
  EXPECT_EQ(transition_coverage(recording, {kLimit_kpa}).covered, 3);
}

TEST(TransitionCoverage, LeavesOutConfigurationsThatAreNoCorner) {
  Recording recording = corner_recording({0, 1, 0, -1});
  recording.episodes[0].setpoint_kpa.middleRows(1, kFramesPerMotion).setConstant(60.0F);
  EXPECT_EQ(transition_coverage(recording, {kLimit_kpa}).attempted, 1);  // 0→−1
}

TEST(TransitionCoverage, ComparesSetPointsWithTheArmsLimits) {
  const Recording recording = corner_recording({0, 1, 0, -1});
  EXPECT_EQ(inspect_it(recording).transitions.covered, 3);
  ArmDescription stronger = one_segment_arm();
  stronger.segments[0].pressure_limit_kpa = 150.0;
  EXPECT_EQ(inspect(recording, &stronger, "a.h5").transitions.covered, 0);
}

TEST(TransitionCoverage, KnowsTheLimitOfEachSide) {
  Recording recording = corner_recording({0, 1, -1, 0});
  Episode& episode = recording.episodes[0];
  episode.setpoint_kpa = episode.setpoint_kpa.cwiseMax(-60.0F);
  episode.pressure_kpa = episode.setpoint_kpa;
  const PressureLimits limits(-60.0, double(kLimit_kpa));
  EXPECT_EQ(transition_coverage(recording, {limits}).covered, 3);
  EXPECT_EQ(transition_coverage(recording, {kLimit_kpa}).covered, 1) << "-60 kPa is no corner";
  ArmDescription arm = one_segment_arm();
  arm.segments[0].pressure_limit_kpa = PressureLimits(-40.0, double(kLimit_kpa));
  std::string text;
  for (const Suspicion& suspicion : inspect(recording, &arm, "a.h5").suspicions) {
    text += suspicion.first + "; ";
  }
  EXPECT_THAT(text, HasSubstr("-60.0 kPa, limit -40.0"));
}

TEST(RecordingInspection, GivesPressureRangesOverAllEpisodes) {
  Recording recording = corner_recording({0, 1, 0, 0});
  recording.episodes.push_back(corner_recording({0, -1, -1, -1}).episodes[0]);
  recording.episodes[1].pressure_kpa(2, 0) = -101.0F;
  const RecordingInspection inspection = inspect_it(recording);
  ASSERT_THAT(inspection.pressures, SizeIs(1));
  EXPECT_EQ(inspection.pressures[0].lowest_kpa, -101.0);
  EXPECT_EQ(inspection.pressures[0].highest_kpa, 100.0);
  EXPECT_EQ(inspection.pressures[0].lowest_setpoint_kpa, -100.0);
  EXPECT_THAT(inspection.suspicions, IsEmpty());
}

/// The only suspicion of a recording changed by `change`.
template <class Change>
Suspicion only_suspicion(Change change) {
  Recording recording = corner_recording({0, 1, 0, -1, 0});
  change(recording.episodes[0]);
  const ArmDescription arm = one_segment_arm();
  const RecordingInspection inspection = inspect(recording, &arm, "a.h5");
  EXPECT_THAT(inspection.suspicions, SizeIs(1));
  return inspection.suspicions.empty() ? Suspicion{} : inspection.suspicions.front();
}

TEST(RecordingInspection, FindsGapsInTime) {
  const Suspicion gap =
      only_suspicion([](Episode& e) { e.time_s.tail(e.time_s.size() - 5).array() += 0.2; });
  EXPECT_EQ(gap.what, "a gap in time");
  EXPECT_EQ(gap.count, 1);
  EXPECT_EQ(gap.frame, 5);
  EXPECT_THAT(gap.first, HasSubstr("0.250 s between frames, the rate gives 0.050"));
}

TEST(RecordingInspection, FindsPlatesThatJump) {
  const Suspicion jump = only_suspicion([](Episode& e) { e.backbone(7, 6) += 0.4F; });
  EXPECT_EQ(jump.what, "a plate that jumps");
  EXPECT_EQ(jump.count, 2) << "there and back";
  EXPECT_EQ(jump.frame, 7);
  EXPECT_THAT(jump.first, HasSubstr("plate 2: 0.400 m"));
}

TEST(RecordingInspection, FindsWrappedHeadings) {
  const Suspicion wrapped = only_suspicion([](Episode& e) {
    e.backbone.bottomRows(6).col(8).array() += static_cast<float>(2.0 * std::numbers::pi);
  });
  EXPECT_THAT(wrapped.what, HasSubstr("(wrapped?)"));
  EXPECT_EQ(wrapped.count, 1);
  EXPECT_THAT(wrapped.first, HasSubstr("plate 2: 6.28 rad"));
}

TEST(RecordingInspection, FindsABaseThatMoves) {
  const Suspicion moved =
      only_suspicion([](Episode& e) { e.backbone.bottomRows(4).col(1).array() += 0.02F; });
  EXPECT_THAT(moved.what, HasSubstr("a base that has moved"));
  EXPECT_EQ(moved.count, 4);
}

TEST(RecordingInspection, FindsPressuresBeyondTheLimit) {
  EXPECT_THAT(only_suspicion([](Episode& e) { e.pressure_kpa(3, 0) = 115.0F; }).what,
              HasSubstr("10 % beyond"));
  EXPECT_THAT(only_suspicion([](Episode& e) { e.setpoint_kpa(3, 0) = 101.0F; }).first,
              HasSubstr("segment 0: 101.0 kPa, limit 100.0"));
}

TEST(RecordingInspection, NoiseBesideNoCommandIsNotBeyondALimit) {
  Recording recording = corner_recording({0, 0, 0});
  recording.episodes[0].pressure_kpa(3, 0) = 0.1F;
  for (const Suspicion& suspicion : inspect_it(recording).suspicions) {
    EXPECT_THAT(suspicion.what, ::testing::Not(HasSubstr("beyond"))) << suspicion.first;
  }
}

TEST(RecordingInspection, FindsATrackerThatHangs) {
  const Suspicion hung = only_suspicion([](Episode& e) {
    for (Eigen::Index t = 2; t < e.backbone.rows(); ++t) {
      e.backbone.row(t) = e.backbone.row(1);
    }
  });
  EXPECT_THAT(hung.what, HasSubstr("stands still to the bit"));
}

TEST(RecordingInspection, SuspectsNothingOfWhatWasFilledIn) {
  Recording recording = corner_recording({0, 1, 0, -1, 0, 1});
  Episode& episode = recording.episodes[0];
  for (int t = 4; t < 15; ++t) {  // over the second motion's begin
    episode.backbone.row(t) = episode.backbone.row(3);
    episode.tracked[static_cast<std::size_t>(t)] = 0;
  }
  episode.backbone.row(30).array() += 0.4F;
  episode.tracked[30] = 0;
  const ArmDescription arm = one_segment_arm();
  EXPECT_THAT(inspect(recording, &arm, "a.h5").suspicions, IsEmpty());
}

TEST(RecordingInspection, FindsCommandsThatNeverChange) {
  const Suspicion constant = only_suspicion([](Episode& e) {
    e.pressure_kpa.setConstant(55.0F);
    e.setpoint_kpa.setConstant(55.0F);
  });
  EXPECT_THAT(constant.what, HasSubstr("pressure never changes"));
  EXPECT_THAT(constant.first, HasSubstr("segment 0: 55 … 55 kPa"));
}

TEST(UnitSuspicion, AUnitIsNotAskedForBySomeOtherName) {
  EXPECT_EQ(unit_suspicion(1.0, "hPa"), "");
  EXPECT_EQ(unit_suspicion(1.0, "mbar"), "");
  EXPECT_THAT(unit_suspicion(1e3, "kPa"), HasSubstr("is it in Pa?"));
}

// A tendon moves by millimetres: without an arm file a command is held against its own largest.
TEST(RecordingInspection, SmallNumbersOfAnotherUnitChangeToo) {
  Recording recording = corner_recording({0, 1, 0, -1, 0, 1});
  recording.episodes[0].pressure_kpa *= 1e-4F;
  recording.episodes[0].setpoint_kpa *= 1e-4F;
  for (const Suspicion& suspicion : inspect_it(recording).suspicions) {
    EXPECT_THAT(suspicion.what, ::testing::Not(HasSubstr("never changes"))) << suspicion.first;
  }
}

TEST(RecordingInspection, WhatWasNotTrackedSaysNothingOfPlates) {
  Recording recording = corner_recording({0, 1, 0, -1, 0, 1});
  Episode& episode = recording.episodes[0];
  const int hidden = episode.frame_count() / 2 + 1;
  for (int t = 0; t < episode.frame_count(); ++t) {
    episode.backbone.row(t).array() += t < hidden ? 0.0F : 0.03F;  // where its tracker has the base
    episode.tracked[std::size_t(t)] = t < hidden ? 0 : 1;
  }
  episode.backbone.topRows(hidden).setZero();
  for (const Suspicion& suspicion : inspect_it(recording).suspicions) {
    EXPECT_THAT(suspicion.what, ::testing::Not(HasSubstr("same place"))) << suspicion.first;
    EXPECT_THAT(suspicion.what, ::testing::Not(HasSubstr("has moved"))) << suspicion.first;
  }
}

TEST(RecordingInspection, FindsEpisodesTooShortOrNeverTracked) {
  Recording recording = corner_recording({0, 1, 0, -1});
  recording.episodes.push_back(corner_recording({0, 1, -1}).episodes[0]);
  recording.episodes.push_back(corner_recording({0, 1}).episodes[0]);
  recording.episodes[0].tracked.assign(recording.episodes[0].tracked.size(), 0);
  const std::vector<Suspicion> found = inspect_it(recording).suspicions;
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].what, "an episode in which the arm was never tracked");
  EXPECT_EQ(found[1].what, "an episode shorter than a training window");
  EXPECT_EQ(found[1].episode, 1);
  EXPECT_EQ(found[1].count, 2);
  EXPECT_EQ(found[1].first, "the shortest of 3 has 13 frames; 33 make one");
}

TEST(RecordingInspection, FindsFramesAtAnotherRate) {
  const Suspicion rate = only_suspicion([](Episode& e) { e.time_s *= 0.5; });
  EXPECT_EQ(rate.first, "a frame every 0.025 s by their times, every 0.05 s by the file");
  const auto said = [](double factor) {
    return only_suspicion([&](Episode& e) { e.time_s *= factor; }).first;
  };
  EXPECT_EQ(said(1e-3),
            "a frame every 5e-05 s by their times, every 0.05 s by the file; were seconds taken "
            "for another unit: is it in ms?");
  Recording slow = corner_recording({0, 1, 0, -1});
  slow.episodes[0].time_s *= 1e3;
  EXPECT_THAT(inspect_it(slow).suspicions.front().first,
              HasSubstr("a frame every 50 s by their times, every 0.05 s by the file; time_s holds "
                        "seconds: is it in ms?"));
}

TEST(RecordingInspection, FindsABaseAwayFromTheOrigin) {
  const Suspicion base = only_suspicion([](Episode& e) {
    for (const int column : {0, 3, 6}) {
      e.backbone.col(column).array() += 0.5F;
    }
  });
  EXPECT_THAT(base.what, HasSubstr("a base that is not the origin of the arm's frame"));
  EXPECT_THAT(base.what, HasSubstr("'alignment: base'"));
}

TEST(RecordingInspection, FindsMixedUnitsAndDoubledPlates) {
  const Suspicion mixed = only_suspicion([](Episode& e) { e.backbone.col(6).array() += 100.0F; });
  EXPECT_THAT(mixed.what, HasSubstr("another unit, order or arm?"));
  EXPECT_THAT(mixed.first, HasSubstr("plates 1 and 2: 100.1 m, 0.1 m by the arm file"));
  const Suspicion doubled =
      only_suspicion([](Episode& e) { e.backbone.rightCols(3) = e.backbone.middleCols(3, 3); });
  EXPECT_EQ(doubled.what, "two plates at the same place");
}

TEST(RecordingInspection, SaysWhoseRecordingItIs) {
  ArmDescription arm = one_segment_arm();
  Recording recording = corner_recording({0, 1, 0, -1});
  recording.arm_hash = "0";
  EXPECT_EQ(inspect(recording, &arm, "a.h5").suspicions.at(0).what,
            "recorded with this arm before its file was changed");
  recording.arm_name = "other";
  EXPECT_EQ(inspect(recording, &arm, "a.h5").suspicions.at(0).what,
            "recorded with another arm: train and evaluate refuse it");
}

TEST(RecordingInspection, SaysTheSameInJsonAndInText) {
  Recording recording = corner_recording({0, 1, 0, -1});
  recording.episodes[0].tracked[2] = 0;
  recording.episodes[0].time_s.tail(3).array() += 1.0;
  const RecordingInspection inspection = inspect_it(recording);
  const nlohmann::ordered_json json = to_json(recording, inspection);
  EXPECT_EQ(json["frames"], 37);
  EXPECT_EQ(json["frames_dropped"], 1);
  EXPECT_EQ(json["transitions"]["possible"], 9);
  EXPECT_EQ(json["transitions"]["covered"], 3);
  EXPECT_EQ(json["suspicions"][0]["what"], "a gap in time");
  EXPECT_THAT(to_text(recording, inspection),
              AllOf(HasSubstr("37 frames at 20 Hz"), HasSubstr("1 not tracked"),
                    HasSubstr("3 of 9 transitions covered"), HasSubstr("a gap in time: 1 times")));
}

TEST(RecordingInspection, ShowsWhatWasDrawnWhereAnythingWas) {
  Recording recording = corner_recording({0, 1, 0, -1});
  EXPECT_FALSE(to_json(recording, inspect_it(recording)).contains("physics"));
  recording.episodes[0].physics = "{\"tip_load_kg\": 0.05}";
  EXPECT_EQ(to_json(recording, inspect_it(recording))["physics"][0], "{\"tip_load_kg\": 0.05}");
}

TEST(RecordingInspection, RefusesAnotherArm) {
  ArmDescription arm = one_segment_arm();
  arm.segments[0].gaps = 7;
  EXPECT_THAT(
      [&] {
        inspect(corner_recording({0, 1}), &arm, "a.h5");
      },
      ThrowsMessage<InputError>(HasSubstr("a.h5: recording of arm 'one' has 3 "
                                          "backbone points; arm 'one' has 8")));
}

}  // namespace
}  // namespace limber
