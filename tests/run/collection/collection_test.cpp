#include <csignal>
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/run/episode_recorder.hpp"
#include "run/collection/collection_fixture.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST_F(Collection, WritesWhatItReturnsAndLeavesNoParts) {
  const CollectionResult result = collect(arm_, quick_settings(), factory(), path_);
  expect_equal(result.recording, read_recording(path_));
  EXPECT_FALSE(fs::exists(parts_));
  EXPECT_EQ(result.recording.episodes.size(), 5U);
  EXPECT_EQ(result.kept_episodes, 0);
  EXPECT_NO_THROW(require_recording_of(result.recording, arm_, "run.h5"));
}

TEST_F(Collection, GivesTheSameResultForAnyNumberOfJobs) {
  CollectionSettings settings = quick_settings();
  settings.jobs = 1;
  const Recording one = collect(arm_, settings, factory(), path_).recording;
  settings.jobs = 3;
  settings.force = true;
  expect_equal(one, collect(arm_, settings, factory(), path_).recording);
}

TEST_F(Collection, StartsAtRestAndNumbersMotions) {
  const Recording recording = collect(arm_, quick_settings(), factory(), path_).recording;
  for (const Episode& episode : recording.episodes) {
    EXPECT_EQ(episode.time_s[0], 0.0);
    EXPECT_TRUE(episode.pressure_kpa.row(0).isZero());
    EXPECT_EQ(episode.motion_index.front(), 0);
    EXPECT_EQ(episode.motion_index.back(), 3);
    EXPECT_NEAR(episode.time_s[1] - episode.time_s[0], arm_.frame_period_s(), 1e-12);
  }
}

TEST_F(Collection, LeadsTheArmToTheFirstConfigurationUnrecorded) {
  CollectionSettings settings = quick_settings();
  settings.schedule = ScheduleSettings{};
  settings.schedule.hold_s = 0.5;
  const auto schedule = make_schedule(arm_, settings.schedule, settings.seed);
  const Recording recording = collect(arm_, settings, factory(), path_).recording;
  for (std::size_t i = 0; i < schedule.size(); ++i) {
    const Eigen::RowVectorXf first = schedule[i].first_kpa.transpose();
    EXPECT_LE((recording.episodes[i].pressure_kpa.row(0) - first).cwiseAbs().maxCoeff(), 2.0F);
    EXPECT_EQ(recording.episodes[i].setpoint_kpa.row(0), first);
  }
}

TEST_F(Collection, HoldsLongerWhereTheEndIsNotReachedInTime) {
  CollectionSettings settings = quick_settings();
  settings.schedule = ScheduleSettings{};
  settings.schedule.hold_s = 0.1;  // the fake arm needs 0.1·ln(200/2) = 0.46 s for a reversal
  const Recording recording = collect(arm_, settings, factory(), path_).recording;
  for (const Episode& episode : recording.episodes) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      const bool ends =
          t + 1 == episode.frame_count() ||
          episode.motion_index[std::size_t(t + 1)] != episode.motion_index[std::size_t(t)];
      if (ends) {
        EXPECT_LE((episode.pressure_kpa.row(t) - episode.setpoint_kpa.row(t)).cwiseAbs().maxCoeff(),
                  2.0F);
      }
    }
  }
}

TEST_F(Collection, NamesASetPointThatIsNeverReachedAndVents) {
  CollectionSettings settings = quick_settings();
  settings.hold_limit_s = 1.0;
  int vents = 0;
  FakeFaults faults;
  faults.stuck_kpa = 30.0F;
  Pressures setpoint(2);
  setpoint << 80.0F, 10.0F;
  FakeArm driver(arm_, kLag_s, faults, &vents);
  EXPECT_THAT(
      [&] {
        record_episode(arm_, driver, {Pressures::Zero(2), {{setpoint, 0.5, true}}}, settings);
      },
      ThrowsMessage<SystemFault>(HasSubstr("motion 0: segment 0 is at 30.0 kPa after 1 s at set "
                                           "point 80.0 kPa; expected to be within 2.0 kPa")));
  EXPECT_EQ(vents, 1);
}

// Segment 1 is 7.3 kPa off, 400 kPa · exp(−4), and within its own tolerance.
TEST_F(Collection, NamesTheSegmentThatIsMostTolerancesOff) {
  arm_.segments[0].pressure_limit_kpa = 10.0;
  arm_.segments[1].pressure_limit_kpa = 100.0;
  CollectionSettings settings = quick_settings();
  settings.hold_limit_s = 0.4;
  FakeFaults faults;
  faults.stuck_kpa = 3.0F;
  FakeArm driver(arm_, kLag_s, faults);
  const EpisodeSchedule schedule{Pressures::Zero(2), {{Eigen::Vector2f(8.0F, 40.0F), 0.1, true}}};
  EXPECT_THAT([&] { record_episode(arm_, driver, schedule, settings); },
              ThrowsMessage<SystemFault>(HasSubstr("segment 0 is at 3.0 kPa after 0.4 s at set "
                                                   "point 8.0 kPa; expected to be within 0.2")));
}

TEST_F(Collection, NamesTheEpisodeOfAFaultAndWritesNothing) {
  FakeFaults faults;
  faults.fails_at_s = 1.0;
  EXPECT_THAT([&] { collect(arm_, quick_settings(), factory(faults), path_); },
              ThrowsMessage<SystemFault>(AllOf(HasSubstr("episode "), HasSubstr("hose came off"))));
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(Collection, KeepsNumbersThatAreNotFiniteOut) {
  FakeFaults faults;
  faults.returns_nan_at_s = 0.5;
  EXPECT_THAT([&] { collect(arm_, quick_settings(), factory(faults), path_); },
              ThrowsMessage<SystemFault>(HasSubstr("not finite at 0.500 s")));
}

TEST_F(Collection, FillsDroppedFramesAndMarksThem) {
  const Recording whole = collect(arm_, quick_settings(), factory(), path_).recording;
  FakeFaults faults;
  faults.drop_every = 4;
  CollectionSettings settings = quick_settings();
  settings.force = true;
  const Recording dropped = collect(arm_, settings, factory(faults), path_).recording;
  const Episode& episode = dropped.episodes[0];
  EXPECT_EQ(episode.untracked_count(), episode.frame_count() / 4);
  for (int t = 0; t + 1 < episode.frame_count(); ++t) {
    if (episode.tracked[std::size_t(t)] != 0) {
      EXPECT_EQ(episode.backbone.row(t), whole.episodes[0].backbone.row(t));
    } else {
      EXPECT_TRUE(episode.backbone.row(t).isApprox(
          0.5F * (episode.backbone.row(t - 1) + episode.backbone.row(t + 1)), 1e-5F));
    }
  }
}

TEST_F(Collection, GoesOnFromItsPartsWithoutRecordingThemAgain) {
  const Recording whole = collect(arm_, quick_settings(), factory(), path_).recording;
  fs::remove(path_);
  FakeFaults faults;  // of episode 3 alone
  faults.fails_at_s = 0.3;
  CollectionSettings settings = quick_settings();
  settings.jobs = 1;
  const DriverFactory flaky = [&](int i) {
    return std::make_unique<FakeArm>(arm_, kLag_s, i == 3 ? faults : FakeFaults{});
  };
  EXPECT_THROW(collect(arm_, settings, flaky, path_), SystemFault);
  ASSERT_TRUE(fs::exists(parts_));
  const auto kept = std::distance(fs::directory_iterator(parts_), fs::directory_iterator());
  ASSERT_GE(kept, 1);

  EXPECT_THAT([&] { collect(arm_, settings, factory(), path_); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("run.h5.parts"), HasSubstr("--resume"), HasSubstr("--force"))));
  settings.resume = true;
  drivers_ = 0;
  const CollectionResult resumed = collect(arm_, settings, factory(), path_);
  EXPECT_EQ(resumed.kept_episodes, kept);
  EXPECT_EQ(drivers_, 5 - kept);
  EXPECT_FALSE(fs::exists(parts_));
  expect_equal(whole, read_recording(path_));

  drivers_ = 0;
  EXPECT_EQ(collect(arm_, settings, factory(), path_).kept_episodes, 5);
  EXPECT_EQ(drivers_, 0) << "a finished file needs no arm";
}

TEST_F(Collection, KeepsWhatIsSaidOfEachEpisodesArmThroughItsParts) {
  CollectionSettings settings = quick_settings();
  settings.jobs = 1;
  settings.physics = [](int index) { return fmt::format("{{\"arm\": {}}}", index); };
  FakeFaults faults;  // of episode 3 alone
  faults.fails_at_s = 0.3;
  const DriverFactory flaky = [&](int i) {
    return std::make_unique<FakeArm>(arm_, kLag_s, i == 3 ? faults : FakeFaults{});
  };
  EXPECT_THROW(collect(arm_, settings, flaky, path_), SystemFault);
  settings.resume = true;
  ASSERT_GE(collect(arm_, settings, factory(), path_).kept_episodes, 1);
  const Recording read = read_recording(path_);
  for (std::size_t i = 0; i < read.episodes.size(); ++i) {
    EXPECT_EQ(read.episodes[i].physics, settings.physics(static_cast<int>(i)));
  }
}

TEST_F(Collection, LeavesValidPartsOnCtrlCAndSaysHowToGoOn) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        install_interrupt_handler();
        CollectionSettings settings = quick_settings();
        settings.jobs = 1;
        const DriverFactory interrupted = [this](int i) {
          if (i == 2) {
            std::raise(SIGINT);
          }
          return std::make_unique<FakeArm>(arm_, kLag_s);
        };
        try {
          collect(arm_, settings, interrupted, path_);
        } catch (const Interrupted& stop) {
          std::fputs(stop.what(), stderr);
          int valid = 0;
          for (const fs::directory_entry& part : fs::directory_iterator(parts_)) {
            valid += static_cast<int>(read_recording(part.path()).episodes.size());
          }
          std::exit(valid == 2 && !fs::exists(path_) ? 0 : 1);
        }
        std::exit(1);
      },
      ::testing::ExitedWithCode(0), "2 of 5 episodes are kept in .*parts: .*--resume");
}

TEST_F(Collection, DoesNotSayThatEpisodesAreKeptWhereNoneIs) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        install_interrupt_handler();
        std::raise(SIGINT);
        try {
          collect(arm_, quick_settings(), factory(), path_);
        } catch (const Interrupted& stop) {
          std::fputs(stop.what(), stderr);
          std::exit(fs::exists(parts_) || fs::exists(path_) ? 1 : 0);
        }
        std::exit(1);
      },
      ::testing::ExitedWithCode(0), "^stopped on request, before the first episode was finished$");
}

TEST_F(Collection, FindsThatItCannotWriteBeforeMovingTheArm) {
  write_file_atomically(folder_.path() / "file", "x");
  for (const fs::path& path : {fs::path("/proc/nowhere/run.h5"), fs::path(""),
                               folder_.path() / "folder" / "", folder_.path() / "file/x/run.h5"}) {
    EXPECT_THROW(collect(arm_, quick_settings(), factory(), path), InputError) << path;
  }
  write_file_atomically(parts_, "a file where the folder would be");
  EXPECT_THAT([&] { collect(arm_, quick_settings(), factory(), path_); },
              ThrowsMessage<InputError>(HasSubstr("run.h5.parts: is a file")));
  EXPECT_EQ(drivers_, 0);
}

TEST_F(Collection, RefusesPartsOfOtherSettings) {
  CollectionSettings settings = quick_settings();
  collect(arm_, settings, factory(), path_);
  fs::create_directories(parts_);
  fs::rename(path_, parts_ / "000000.h5");
  settings.resume = true;
  const auto refusal = [&](auto change) {
    CollectionSettings changed = settings;
    change(changed);
    return [this, changed] { collect(arm_, changed, factory(), path_); };
  };
  EXPECT_THAT(refusal([](auto& s) { s.seed = 4; }),
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("000000.h5"), HasSubstr("seed '3'; this run has '4'"))));
  EXPECT_THAT(refusal([](auto& s) { s.schedule.hold_s = 0.7; }),
              ThrowsMessage<InputError>(HasSubstr("hold 0.5 s")));
  EXPECT_THAT(refusal([](auto& s) { s.driver = "noise 1 mm"; }),
              ThrowsMessage<InputError>(HasSubstr("noise 1 mm")));
  ArmDescription other = arm_;
  other.segments[0].width_m = 0.05;
  EXPECT_THAT([&] { collect(other, settings, factory(), path_); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("recorded with arm 'small "), HasSubstr(" there, 0.05 here"))));
  write_file_atomically(parts_ / "000000.h5", "damaged");
  EXPECT_THAT([&] { collect(arm_, settings, factory(), path_); },
              ThrowsMessage<InputError>(HasSubstr("000000.h5: not an HDF5 file")));
  settings.resume = false;
  settings.force = true;
  EXPECT_EQ(collect(arm_, settings, factory(), path_).kept_episodes, 0);
}

TEST_F(Collection, RefusesToReplaceAFileBeforeMovingTheArm) {
  write_file_atomically(path_, "precious");
  EXPECT_THAT([&] { collect(arm_, quick_settings(), factory(), path_); },
              ThrowsMessage<InputError>(HasSubstr("--force")));
  EXPECT_EQ(drivers_, 0);
  EXPECT_EQ(read_file(path_), "precious");
}

TEST_F(Collection, MovesStraightThroughPressureSpaceWhenAsked) {
  CollectionSettings settings = quick_settings();
  settings.schedule.approach = Approach::straight;
  const auto schedule = make_schedule(arm_, settings.schedule, settings.seed);
  const Recording recording = collect(arm_, settings, factory(), path_).recording;
  const auto step_kpa = static_cast<float>(arm_.pressure_step_limit_kpa());
  for (std::size_t i = 0; i < schedule.size(); ++i) {
    const FrameMatrix& setpoint = recording.episodes[i].setpoint_kpa;
    for (Eigen::Index t = 1; t < setpoint.rows(); ++t) {
      EXPECT_LE((setpoint.row(t) - setpoint.row(t - 1)).cwiseAbs().maxCoeff(), step_kpa + 1e-3F);
    }
    EXPECT_EQ(setpoint.row(setpoint.rows() - 1).transpose(),
              schedule[i].motions.back().setpoint_kpa);
  }
}

TEST(FillMissingRows, HoldsTheNearestAtTheEndsAndInterpolatesByTimeBetween) {
  FrameMatrix values(6, 1);
  values << 0, 1, 0, 0, 4, 0;
  fill_missing_rows({0.0, 1.0, 1.5, 2.0, 3.0, 4.0}, {0, 1, 0, 0, 1, 0}, values);
  FrameMatrix expected(6, 1);
  expected << 1, 1, 1.75F, 2.5F, 4, 4;
  EXPECT_TRUE(values.isApprox(expected));
}

TEST(EpisodeRecorder, RefusesARunThatNothingTracked) {
  const ArmDescription arm = small_arm();
  EpisodeRecorder recorder(arm);
  recorder.add({0.0, Pressures::Zero(2), std::nullopt, std::nullopt}, Pressures::Zero(2), 0);
  EXPECT_THAT([&] { recorder.finish(); },
              ThrowsMessage<SystemFault>(HasSubstr("none of 1 frames had a backbone")));
  EXPECT_THAT(
      [&] {
        recorder.add({0.0, Pressures::Zero(3), std::nullopt, std::nullopt}, Pressures::Zero(2), 0);
      },
      ThrowsMessage<SystemFault>(HasSubstr("returned 3 pressures")));
}

}  // namespace
}  // namespace limber
