#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/data/recording_export.hpp"
#include "limber/logs/log_import.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr float kRounding = 1e-6F;  // [m], of a quaternion: nine digits, and made to unit length
constexpr float kWritten = 2e-6F;   // Motive's seven digits behind the point
constexpr int kFrames = 200;

/// Recordings of an arm in space, written and read back.
class SpaceExport : public ::testing::Test {
 protected:
  SpaceExport() : arm_(testing_support::space_arm()), recording_(make_recording(arm_, "test", 1)) {
    Episode episode;
    episode.dimension = Dimension::space;
    episode.time_s = Eigen::VectorXd::LinSpaced(kFrames, 0.0, (kFrames - 1) / 20.0);
    episode.pressure_kpa = FrameMatrix::NullaryExpr(
        kFrames, arm_.channel_count(),
        [](auto t, auto i) { return 45.0F + 40.0F * std::sin(0.05F * float(t) + float(i)); });
    episode.setpoint_kpa = episode.pressure_kpa.array() + 0.5F;
    episode.backbone.resize(kFrames, kSpacePoseSize * arm_.point_count());
    const NoLoadModel no_load(arm_);
    for (int t = 0; t < kFrames; ++t) {
      Eigen::VectorXf poses(episode.backbone.cols());
      no_load.poses(episode.pressure_kpa.row(t).transpose(), poses);
      episode.backbone.row(t) = poses.transpose();
      episode.motion_index.push_back(t / 60);
    }
    episode.tracked.assign(kFrames, 1);
    recording_.episodes = {episode};
  }

  Episode back(bool motive) const {
    const auto path = [&](const char* name) { return folder_.path() / name; };
    ImportOptions options;
    options.mapping = read_import_mapping(path("mapping.yaml"), arm_);
    if (!motive) {
      return import_csv({path("episode_000.csv")}, options, arm_).recording.episodes.at(0);
    }
    options.command_logs = {path("episode_000_pressures.csv")};
    options.time_offset_s = 1.5;
    return import_motive({path("episode_000_motive.csv")}, options, arm_).recording.episodes.at(0);
  }

  float largest_difference(const Episode& episode) const {
    return (episode.backbone - recording_.episodes[0].backbone).cwiseAbs().maxCoeff();
  }

  ArmDescription arm_;
  TemporaryFolder folder_;
  Recording recording_;
};

TEST_F(SpaceExport, CsvComesBack) {
  recording_.episodes[0].tracked[100] = 0;
  export_csv(recording_, folder_.path());
  const Episode episode = back(false);
  const Episode& own = recording_.episodes[0];
  EXPECT_EQ(episode.pressure_kpa, own.pressure_kpa);
  EXPECT_EQ(episode.setpoint_kpa, own.setpoint_kpa);
  EXPECT_EQ(episode.motion_index, own.motion_index);
  EXPECT_EQ(episode.tracked, own.tracked);
  EXPECT_FALSE(episode.lifted);
  EXPECT_LT((episode.backbone - own.backbone).topRows(100).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT((episode.backbone - own.backbone).bottomRows(99).cwiseAbs().maxCoeff(), kRounding);
}

// Their rotations are no measurement, on the way back neither.
TEST_F(SpaceExport, RotationsFromPlacesAreMadeAgain) {
  recording_.episodes[0].lifted = true;
  export_csv(recording_, folder_.path());
  EXPECT_THAT(read_file(folder_.path() / "episode_000.csv"), Not(HasSubstr("qx")));
  const Episode episode = back(false);
  EXPECT_TRUE(episode.lifted);
  EXPECT_LT(largest_difference(episode), 1e-5F);  // the arcs are the arm's own
  LogExportSettings settings;
  settings.time_offset_s = 1.5;
  export_motive(recording_, folder_.path(), settings);
  EXPECT_TRUE(back(true).lifted);
}

TEST_F(SpaceExport, MotiveComesBack) {
  for (const bool markers : {false, true}) {
    LogExportSettings settings;
    settings.time_offset_s = 1.5;
    settings.markers = markers;
    export_motive(recording_, folder_.path(), settings);
    const Episode episode = back(true);
    EXPECT_EQ(episode.lifted, markers);
    ASSERT_EQ(episode.frame_count(), kFrames);
    EXPECT_LT(largest_difference(episode), markers ? 5e-4F : kWritten);
    EXPECT_LT((episode.pressure_kpa - recording_.episodes[0].pressure_kpa).cwiseAbs().maxCoeff(),
              1e-3F);
  }
}

TEST_F(SpaceExport, NoiseIsThatOfEveryAxis) {
  LogExportSettings settings;
  settings.time_offset_s = 1.5;
  settings.noise_m = 1e-3;
  settings.noise_rad = 5e-3;
  export_motive(recording_, folder_.path(), settings);
  const Episode episode = back(true);
  const Episode& own = recording_.episodes[0];
  // The base stands still, and so is put where it was.
  Eigen::Vector3d square_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d square_rad = Eigen::Vector3d::Zero();
  int count = 0;
  for (int t = 0; t < episode.frame_count(); ++t) {
    for (int p = 1; p < arm_.point_count(); ++p) {
      const auto pose = [&](const Episode& of) {
        return space_pose_of(
            of.backbone.row(t).segment<kSpacePoseSize>(kSpacePoseSize * p).cast<double>());
      };
      const SpacePose off = between(pose(own), pose(episode));
      square_m += off.position_m.cwiseAbs2();
      square_rad += rotation_vector(off.rotation).cwiseAbs2();
      ++count;
    }
  }
  const Eigen::Vector3d noise_m = (square_m / count).cwiseSqrt();
  const Eigen::Vector3d noise_rad = (square_rad / count).cwiseSqrt();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(noise_m[axis], 1e-3, 2e-4);
    EXPECT_NEAR(noise_rad[axis], 5e-3, 1e-3);
  }
}

}  // namespace
}  // namespace limber
