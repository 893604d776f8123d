// Laws of recordings drawn by a number: their files, and the logs that they are exported as.
#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/data/recording_export.hpp"
#include "limber/logs/log_import.hpp"
#include "support/drawn_arm.hpp"
#include "support/property.hpp"
#include "support/sample_arm.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

constexpr float kRounding = 2e-6F;    // [m], [rad], of a quaternion: nine digits
constexpr float kWritten = 1e-5F;     // [m], [rad]; Motive's seven digits, over the arm's length
constexpr float kWrittenKpa = 1e-3F;  // times have six digits behind the point
constexpr int kSlowerFiles = 4;       // each is read by a process of its own
constexpr int kSlowerLogs = 10;
constexpr int kLogFrames = 300;

/// Any numbers, as recordings may hold them.
Episode drawn_episode(const Recording& recording, bool lifted, RandomStream& random) {
  const auto drawn_matrix = [&](Eigen::Index rows, Eigen::Index columns, double size) {
    return FrameMatrix(FrameMatrix::NullaryExpr(
        rows, columns, [&] { return float(random.uniform(-size, size)); }));
  };
  const Eigen::Index frames = 1 + random.index(8);
  Episode episode;
  episode.dimension = recording.dimension;
  episode.lifted = lifted;
  episode.time_s.resize(frames);
  double now_s = random.uniform(-1e3, 1e9);
  int motion = int(random.index(3));
  for (Eigen::Index t = 0; t < frames; ++t) {
    episode.time_s[t] = now_s;
    now_s += random.uniform(0.001, 1.0);
    episode.motion_index.push_back(motion);
    motion += int(random.index(3));
    episode.tracked.push_back(drawn::chance(random, 0.8) ? 1 : 0);
  }
  episode.pressure_kpa = drawn_matrix(frames, recording.channel_count(), 150.0);
  episode.setpoint_kpa = drawn_matrix(frames, recording.channel_count(), 150.0);
  const int size = pose_size(recording.dimension);
  episode.backbone = drawn_matrix(frames, Eigen::Index(size) * recording.point_count, 2.0);
  for (Eigen::Index q = 3; recording.dimension == Dimension::space && q < episode.backbone.cols();
       q += kSpacePoseSize) {
    for (Eigen::Index t = 0; t < frames; ++t) {
      episode.backbone.row(t).segment<4>(q) += Eigen::RowVector4f(0.0F, 0.0F, 0.0F, 5.0F);
      episode.backbone.row(t).segment<4>(q).normalize();
    }
  }
  episode.physics = drawn_text();
  episode.log = drawn_text();
  return episode;
}

Recording drawn_recording(std::uint64_t number, bool in_space) {
  RandomStream random(number, 0);
  const ArmDescription arm =
      in_space ? drawn::space_arm(number, random) : drawn::arm(number, random);
  Recording recording =
      make_recording(arm, drawn_text(), std::uint64_t{0xFFFFFFFFFFFFFFFF} - number);
  recording.settings = drawn_text();
  const bool lifted = in_space && drawn::chance(random, 0.5);
  for (auto left = 1 + random.index(3); left > 0; --left) {
    recording.episodes.push_back(drawn_episode(recording, lifted, random));
  }
  if (drawn::chance(random, 0.3)) {
    recording.episodes = with_setpoints_only(recording.episodes);
  }
  return recording;
}

void check_same(const Episode& a, const Episode& b) {
  RC_ASSERT(a.frame_count() == b.frame_count());
  RC_ASSERT(a.time_s == b.time_s);
  RC_ASSERT(a.pressure_kpa == b.pressure_kpa);
  RC_ASSERT(a.setpoint_kpa == b.setpoint_kpa);
  RC_ASSERT(a.backbone == b.backbone);
  RC_ASSERT(a.motion_index == b.motion_index);
  RC_ASSERT(a.tracked == b.tracked);
  RC_ASSERT(a.setpoints_only == b.setpoints_only);
  RC_ASSERT(a.dimension == b.dimension);
  RC_ASSERT(a.lifted == b.lifted);
  RC_ASSERT(a.physics == b.physics);
  RC_ASSERT(a.log == b.log);
}

TEST(DrawnRecordings, FilesComeBackExactly) {
  expect_law(
      "a recording that is written and read is the recording",
      [] {
        const Recording written = drawn_recording(drawn_number(), *rc::gen::arbitrary<bool>());
        const TemporaryFolder folder;
        write_recording(folder.path() / "r.h5", written);
        const Recording read = read_recording(folder.path() / "r.h5");
        RC_ASSERT(read.arm_name == written.arm_name);
        RC_ASSERT(read.arm_hash == written.arm_hash);
        RC_ASSERT(read.arm_description == written.arm_description);
        RC_ASSERT(read.command.name == written.command.name);
        RC_ASSERT(read.command.unit == written.command.unit);
        RC_ASSERT(read.dimension == written.dimension);
        RC_ASSERT(read.segment_count == written.segment_count);
        RC_ASSERT(read.chamber_count == written.chamber_count);
        RC_ASSERT(read.point_count == written.point_count);
        RC_ASSERT(read.rate_hz == written.rate_hz);
        RC_ASSERT(read.seed == written.seed);
        RC_ASSERT(read.source == written.source);
        RC_ASSERT(read.settings == written.settings);
        RC_ASSERT(read.episodes.size() == written.episodes.size());
        for (std::size_t e = 0; e < read.episodes.size(); ++e) {
          check_same(read.episodes[e], written.episodes[e]);
        }
      },
      kSlowerFiles);
}

/// A recording that could have been made: an arm follows its no-load model under commands that
/// swing and never repeat. Motions are numbered from 0, one after the other; now and then a frame
/// was not tracked.
struct DrawnLog {
  RandomStream random;
  ArmDescription arm;
  Recording recording;

  DrawnLog(std::uint64_t number, bool in_space)
      : random(number, 0),
        arm(in_space ? testing_support::space_arm() : sample_arm(1 + int(random.index(4)))),
        recording(make_recording(arm, "test", number)) {
    Episode episode;
    episode.dimension = arm.dimension;
    episode.time_s.resize(kLogFrames);
    for (int t = 0; t < kLogFrames; ++t) {
      episode.time_s[t] = t / arm.frame_rate_hz;
    }
    episode.pressure_kpa.resize(kLogFrames, arm.channel_count());
    for (int i = 0; i < arm.channel_count(); ++i) {
      swing(episode.pressure_kpa.col(i), arm.limits_of_channel(i), episode.time_s);
    }
    episode.setpoint_kpa = episode.pressure_kpa.array() + float(random.uniform(0.1, 0.9));
    const NoLoadModel no_load(arm);
    Eigen::VectorXf poses(pose_size(arm.dimension) * arm.point_count());
    episode.backbone.resize(kLogFrames, poses.size());
    for (int t = 0; t < kLogFrames; ++t) {
      no_load.poses(episode.pressure_kpa.row(t).transpose(), poses);
      episode.backbone.row(t) = poses.transpose();
      const int before = t == 0 ? 0 : episode.motion_index.back();
      episode.motion_index.push_back(before + int(t > 0 && drawn::chance(random, 0.05)));
    }
    episode.tracked.assign(kLogFrames, 1);
    recording.episodes = {episode};
  }

  Episode& episode() { return recording.episodes.front(); }

  void lose_frames() {
    constexpr int kApart = 20;
    for (int t = kApart / 2; t + kApart < kLogFrames; t += kApart + int(random.index(60))) {
      episode().tracked[std::size_t(t)] = 0;
    }
  }

 private:
  void swing(Eigen::Ref<Eigen::VectorXf, 0, Eigen::InnerStride<>> kpa, const PressureLimits& limits,
             const Eigen::VectorXd& time_s) {
    const double rate = random.uniform(0.7, 2.5);
    const double phase = random.uniform(0.0, 6.0);
    const double middle = 0.5 * (limits.lower_kpa + limits.upper_kpa);
    const double size = random.uniform(0.5, 0.9) * limits.half_width_kpa();
    for (Eigen::Index t = 0; t < time_s.size(); ++t) {
      const double a = (rate + 0.02 * time_s[t]) * time_s[t] + phase;
      kpa[t] = float(middle + size * std::sin(a + 0.8 * std::sin(0.31 * a)));
    }
  }
};

/// Of positions and headings; of rotations, whichever sign their quaternions have.
float largest_difference(const Episode& a, const Episode& b) {
  float largest = 0.0F;
  for (Eigen::Index t = 0; t < a.backbone.rows(); ++t) {
    for (Eigen::Index at = 0; at < a.backbone.cols(); at += pose_size(a.dimension)) {
      const auto off = [&](Eigen::Index first, Eigen::Index size, float sign) {
        return (a.backbone.row(t).segment(at + first, size) -
                sign * b.backbone.row(t).segment(at + first, size))
            .cwiseAbs()
            .maxCoeff();
      };
      if (!a.was_tracked(int(t))) {
        continue;
      }
      largest = std::max(largest, off(0, 3, 1.0F));
      if (a.dimension == Dimension::space) {
        largest = std::max(largest, std::min(off(3, 4, 1.0F), off(3, 4, -1.0F)));
      }
    }
  }
  return largest;
}

TEST(DrawnRecordings, CsvComesBackAsItWas) {
  expect_law(
      "what is imported of an export is the recording",
      [] {
        DrawnLog drawn(drawn_number(), *rc::gen::arbitrary<bool>());
        drawn.lose_frames();
        const bool setpoints_only = drawn::chance(drawn.random, 0.3);
        if (setpoints_only) {
          drawn.recording.episodes = with_setpoints_only(drawn.recording.episodes);
        }
        const TemporaryFolder folder;
        export_csv(drawn.recording, folder.path());
        ImportOptions options;
        options.mapping = read_import_mapping(folder.path() / "mapping.yaml", drawn.arm);
        const Recording back =
            import_csv({folder.path() / "episode_000.csv"}, options, drawn.arm).recording;
        RC_ASSERT(back.episodes.size() == 1U);
        const Episode& a = drawn.episode();
        const Episode& b = back.episodes.front();
        RC_ASSERT(a.frame_count() == b.frame_count());
        RC_ASSERT(a.setpoints_only == b.setpoints_only);
        RC_ASSERT(a.pressure_kpa == b.pressure_kpa);
        RC_ASSERT(a.setpoint_kpa == b.setpoint_kpa);
        RC_ASSERT(a.motion_index == b.motion_index);
        RC_ASSERT(a.tracked == b.tracked);
        RC_ASSERT((a.time_s - b.time_s).cwiseAbs().maxCoeff() <= double(kRounding));
        RC_ASSERT(largest_difference(a, b) <= kRounding);
      },
      kSlowerLogs);
}

TEST(DrawnRecordings, MotiveComesBackWithinItsDigits) {
  expect_law(
      "what is imported of an export on two clocks is the recording, to its written digits",
      [] {
        DrawnLog drawn(drawn_number(), *rc::gen::arbitrary<bool>());
        LogExportSettings settings;
        settings.time_offset_s = 1e-3 * (double(drawn.random.index(200'000)) - 1e5);
        const TemporaryFolder folder;
        export_motive(drawn.recording, folder.path(), settings);
        ImportOptions options;
        options.mapping = read_import_mapping(folder.path() / "mapping.yaml", drawn.arm);
        options.command_logs = {folder.path() / "episode_000_pressures.csv"};
        options.time_offset_s = settings.time_offset_s;
        const Recording back =
            import_motive({folder.path() / "episode_000_motive.csv"}, options, drawn.arm).recording;
        RC_ASSERT(back.episodes.size() == 1U);
        const Episode& a = drawn.episode();
        const Episode& b = back.episodes.front();
        RC_ASSERT(a.frame_count() == b.frame_count());
        RC_ASSERT(b.untracked_count() == 0);
        RC_ASSERT((a.pressure_kpa - b.pressure_kpa).cwiseAbs().maxCoeff() <= kWrittenKpa);
        RC_ASSERT(largest_difference(a, b) <= kWritten);
      },
      kSlowerLogs);
}

}  // namespace
}  // namespace limber
