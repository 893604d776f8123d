#include "limber/data/recording_export.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/logs/log_import.hpp"
#include "support/exit_interrupted.hpp"
#include "support/log_truth.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kWritten = 2e-6;  // [m], [rad]: seven digits, and quaternions

/// Logs written from a recording and read back.
class RecordingExport : public ::testing::Test {
 protected:
  RecordingExport() : truth_(sample_arm(3)), recording_(make_recording(truth_.arm(), "test", 1)) {
    Episode episode;
    const int frames = 600;
    const int m = truth_.arm().point_count();
    episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) / 20.0);
    episode.pressure_kpa.resize(frames, 3);
    episode.backbone.resize(frames, 3 * m);
    for (int t = 0; t < frames; ++t) {
      episode.pressure_kpa.row(t) = truth_.pressures(episode.time_s[t]).cast<float>().transpose();
      const BackboneD b = truth_.backbone(episode.time_s[t]);
      episode.backbone.row(t) =
          Eigen::Map<const Eigen::RowVectorXd>(b.data(), b.size()).cast<float>();
      episode.motion_index.push_back(t / 60);
    }
    episode.setpoint_kpa = episode.pressure_kpa.array() + 0.5F;
    episode.tracked.assign(frames, 1);
    recording_.episodes = {episode};
  }

  ImportResult import_back(bool motive, std::optional<double> offset_s = {}) const {
    const auto path = [&](const char* name) { return folder_.path() / name; };
    ImportOptions options;
    options.mapping = read_import_mapping(path("mapping.yaml"), truth_.arm());
    options.time_offset_s = offset_s;
    if (!motive) {
      return import_csv({path("episode_000.csv")}, options, truth_.arm());
    }
    options.command_logs = {path("episode_000_pressures.csv")};
    return import_motive({path("episode_000_motive.csv")}, options, truth_.arm());
  }

  /// Root mean square and largest difference of positions, and of headings, over frames seen.
  struct Differences {
    double rms_m = 0.0;
    double max_m = 0.0;
    double rms_rad = 0.0;
  };
  Differences differences(const Recording& imported) const {
    const Episode& original = recording_.episodes.front();
    Differences result;
    int count = 0;
    for (const Episode& episode : imported.episodes) {
      for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
        if (episode.tracked[std::size_t(t)] == 0) {
          continue;
        }
        const auto frame = static_cast<Eigen::Index>(std::lround(episode.time_s[t] * 20.0));
        for (int p = 1; p < recording_.point_count; ++p) {
          const Eigen::Vector3d d = (episode.backbone.row(t).segment<3>(3 * p) -
                                     original.backbone.row(frame).segment<3>(3 * p))
                                        .cast<double>();
          result.rms_m += d.head<2>().squaredNorm();
          result.rms_rad += d[2] * d[2];
          result.max_m = std::max(result.max_m, d.head<2>().norm());
          ++count;
        }
      }
    }
    result.rms_m = std::sqrt(result.rms_m / count);
    result.rms_rad = std::sqrt(result.rms_rad / count);
    return result;
  }

  TemporaryFolder folder_;
  LogTruth truth_;
  Recording recording_;
};

TEST_F(RecordingExport, StopsOnCtrlC) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(exit_interrupted([&] { export_csv(recording_, folder_.path()); }),
              ::testing::ExitedWithCode(0), "stopped on request");
  EXPECT_EXIT(exit_interrupted([&] { export_motive(recording_, folder_.path(), {}); }),
              ::testing::ExitedWithCode(0), "stopped on request");
}

TEST_F(RecordingExport, CsvComesBackToTheBit) {
  recording_.episodes[0].tracked[100] = 0;
  export_csv(recording_, folder_.path());
  const Recording back = import_back(false).recording;
  const Episode& a = recording_.episodes[0];
  const Episode& b = back.episodes.at(0);
  EXPECT_EQ(a.pressure_kpa, b.pressure_kpa);
  EXPECT_EQ(a.setpoint_kpa, b.setpoint_kpa);
  EXPECT_EQ(a.motion_index, b.motion_index);
  EXPECT_EQ(a.tracked, b.tracked);
  EXPECT_EQ(a.backbone.topRows(100), b.backbone.topRows(100));
  EXPECT_EQ(a.backbone.bottomRows(499), b.backbone.bottomRows(499));
}

TEST_F(RecordingExport, SetPointsAloneComeBackAsSetPointsAlone) {
  recording_.episodes = with_setpoints_only(recording_.episodes);
  export_csv(recording_, folder_.path());
  EXPECT_EQ(read_file(folder_.path() / "episode_000.csv").find("pressure"), std::string::npos);
  const Recording back = import_back(false).recording;
  EXPECT_TRUE(back.setpoints_only());
  EXPECT_EQ(back.episodes.at(0).setpoint_kpa, recording_.episodes[0].setpoint_kpa);
  EXPECT_EQ(back.episodes.at(0).backbone, recording_.episodes[0].backbone);
  export_motive(recording_, folder_.path(), {});
  EXPECT_TRUE(import_back(true, 0.0).recording.setpoints_only());
}

TEST_F(RecordingExport, MotiveComesBackThroughAnotherClock) {
  for (const bool markers : {false, true}) {
    LogExportSettings settings;
    settings.rate_hz = 120.0;
    settings.time_offset_s = -73.21;
    settings.markers = markers;
    export_motive(recording_, folder_.path(), settings);
    const ImportResult back = import_back(true);
    // Pressures at 20 Hz: a little lag, fitted along, fits as well.
    EXPECT_NEAR(back.report.runs[0].clock->offset_s, -73.21, 1.5e-2);
    EXPECT_LT(differences(back.recording).max_m, 5 * kWritten);
    EXPECT_GT(back.recording.frame_count(), 595);
    EXPECT_EQ(back.recording.untracked_count(), 0);
  }
}

TEST_F(RecordingExport, NoiseAndOcclusionsComeBackAsThatAndNoMore) {
  LogExportSettings settings;
  settings.rate_hz = 120.0;
  settings.time_offset_s = 4.4;
  settings.noise_m = 5e-4;
  settings.noise_rad = 5e-3;
  settings.occlusions = 40;
  settings.occlusion_s = 0.2;
  export_motive(recording_, folder_.path(), settings);
  const ImportResult back = import_back(true);
  EXPECT_NEAR(back.report.runs[0].clock->offset_s, 4.4, 1e-2);
  const Differences found = differences(back.recording);
  // Two coordinates, each with the noise; the base's median adds next to nothing.
  EXPECT_NEAR(found.rms_m, std::sqrt(2.0) * settings.noise_m, 0.05 * settings.noise_m);
  EXPECT_NEAR(found.rms_rad, settings.noise_rad, 0.05 * settings.noise_rad);
  EXPECT_LT(found.max_m, 7 * settings.noise_m);
  // 40 × 0.2 s of 30 s, some over others, and the frames beside them.
  EXPECT_GT(back.recording.untracked_count(), 100);
  EXPECT_LT(back.recording.untracked_count(), 250);
}

TEST_F(RecordingExport, LongOcclusionsAreNotFilledIn) {
  LogExportSettings settings;
  settings.occlusions = 2;
  settings.occlusion_s = 2.0;
  settings.seed = 3;
  export_motive(recording_, folder_.path(), settings);
  const ImportResult back = import_back(true, 0.0);
  EXPECT_GE(back.recording.episodes.size(), 2U);
  EXPECT_EQ(back.recording.untracked_count(), 0);
  EXPECT_LT(differences(back.recording).max_m, 5 * kWritten);
}

TEST_F(RecordingExport, IsTheSameForTheSameSeed) {
  LogExportSettings settings;
  settings.noise_m = 1e-3;
  const auto text = [&] {
    export_motive(recording_, folder_.path(), settings);
    return read_file(folder_.path() / "episode_000_motive.csv");
  };
  const std::string first = text();
  EXPECT_EQ(text(), first);
  settings.seed = 2;
  EXPECT_NE(text(), first);
}

TEST_F(RecordingExport, RefusesAClockThatGoesOnForEver) {
  recording_.episodes[0].time_s.tail(100).array() += 1.7e9;
  EXPECT_THAT([&] { export_motive(recording_, folder_.path(), {}); },
              ThrowsMessage<InputError>(HasSubstr("Is there a gap in it?")));
}

TEST_F(RecordingExport, NamesSettingsOutOfRange) {
  LogExportSettings settings;
  settings.rate_hz = 5.0;
  EXPECT_THAT([&] { export_motive(recording_, folder_.path(), settings); },
              ThrowsMessage<InputError>(HasSubstr("rate_hz 5; expected the recording's rate")));
  const auto refusal = [&](const std::function<void(LogExportSettings&)>& change) {
    LogExportSettings changed;
    change(changed);
    try {
      export_motive(recording_, folder_.path(), changed);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refusal([](auto& s) { s.rate_hz = 1e6; }), HasSubstr("rate_hz 1000000; expected"));
  EXPECT_THAT(refusal([](auto& s) { s.rate_hz = 1e300; }), HasSubstr("to 2000 Hz"));
  EXPECT_THAT(refusal([](auto& s) { s.rate_hz = std::nan(""); }), HasSubstr("rate_hz nan"));
  EXPECT_THAT(refusal([](auto& s) { s.occlusions = 2147483647; }),
              HasSubstr("occlusions 2147483647; expected 0 to 10000"));
  EXPECT_THAT(refusal([](auto& s) { s.time_offset_s = std::nan(""); }), HasSubstr("time_offset_s"));
  EXPECT_THAT(refusal([](auto& s) { s.time_offset_s = 1e300; }), HasSubstr("time_offset_s 1e+300"));
}

}  // namespace
}  // namespace limber
