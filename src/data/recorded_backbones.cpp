#include "recorded_backbones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "episode_path.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/log_units.hpp"
#include "limber/data/recording_inspection.hpp"

namespace limber {

namespace {

constexpr double kBasePosition_m = 0.002;  // trackers are better than that
constexpr double kBaseHeading_rad = 0.01;  // 7 mm at the end of a 0.7 m arm
// Median distance of two plates over their gap at rest. A gap that stretches by half or bends by
// 3.8 rad is not an arm that we know; another unit or another arm is off by more.
constexpr double kMaxTrackedGap = 1.5;
constexpr double kMinTrackedGap = 0.5;
// From the base, in lengths of the arm, and turned against it: no tracker sees an arm there, even
// once. What it takes for a plate by mistake lies nearer.
constexpr double kNeverThere = 100.0;
constexpr double kNeverTurned_rad = 100.0;
// Standard deviation of the end's position over the arm's length, 1.4 mm at 0.7 m: more than a
// tracker's noise and less than any motion in which a command changes by half of its limit.
constexpr double kStill = 0.002;
constexpr double kMovingCommand = 0.5;

/// @param slack  ≥ 1, by which the allowed range is wider
void require_gaps(const Episode& episode, const ArmDescription& arm, double slack,
                  const std::string& where) {
  const std::vector<double> rest_m = rest_positions_m(arm);
  for (int plate = 0; plate + 1 < arm.point_count(); ++plate) {
    const double expected_m = rest_m[plate + 1] - rest_m[plate];
    const double found_m = median_gap_m(episode, plate);
    const double high_m = slack * kMaxTrackedGap * expected_m;
    const double low_m = kMinTrackedGap / slack * expected_m;
    if (found_m > high_m || found_m < low_m) {
      const std::string unit = unit_suspicion(found_m / expected_m, "m");
      throw InputError(fmt::format(
          "{}: {} are {:.4g} m apart (median over the frames); {} has {:.4g} m "
          "there, and {:.4g} to {:.4g} m are allowed. {} Import its logs again, or give the arm "
          "file that it was recorded with (--arm)",
          where, plates_of_gap(plate), found_m, arm_in_words(arm), expected_m, low_m, high_m,
          unit.empty() ? "Are the plates in order, and is it this arm?"
                       : "It should be in m: " + unit));
    }
  }
}

/// In space a heading has no turns to count.
double heading_from_base_rad(const Episode& episode, int t, int plate) {
  return episode.dimension == Dimension::space
             ? 0.0
             : std::abs(double(episode.backbone(t, kPoseSize * plate + 2)) -
                        double(episode.backbone(t, 2)));
}

/// Even one frame far away ruins ranges and means.
void require_plates_near(const Episode& episode, const ArmDescription& arm,
                         const std::string& where) {
  const double farthest_m = kNeverThere * arm.length_m();
  const std::vector<int> tracked = tracked_frames(episode);
  for (const int t : tracked) {
    const Eigen::Vector3d begin = episode.position_m(tracked.front(), 0);
    const Eigen::Vector3d base = episode.position_m(t, 0);
    for (int plate = 0; plate < arm.point_count(); ++plate) {
      const double away_m = (episode.position_m(t, plate) - (plate == 0 ? begin : base)).norm();
      const double turned_rad = heading_from_base_rad(episode, t, plate);
      if (away_m > farthest_m || turned_rad > kNeverTurned_rad) {
        throw InputError(fmt::format(
            "{}: {}: {} is {}; {} is {:.4g} m long, and up to {:.4g} m and {} rad are allowed. Was "
            "something else tracked there? Leave that log out, or import it again without that "
            "frame",
            where, frame_name(t), plate_name(plate),
            away_m > farthest_m ? fmt::format("{:.4g} m from {}", away_m,
                                              plate == 0 ? "where the base began" : "the base")
                                : fmt::format("turned by {:.4g} rad against the base", turned_rad),
            arm_in_words(arm), arm.length_m(), farthest_m, kNeverTurned_rad));
      }
    }
  }
}

double spread_of_end_m(const Episode& episode) {
  const Eigen::Index tip = episode.point_count() - 1;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double squares = 0.0;
  double count = 0.0;
  for (const int t : tracked_frames(episode)) {
    // Welford's update: differences of large sums would lose the spread of an arm far away.
    const Eigen::Vector3d tip_m = episode.position_m(t, tip);
    const Eigen::Vector3d before = tip_m - mean;
    count += 1.0;
    mean += before / count;
    squares += before.dot(tip_m - mean);
  }
  return count > 0.0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

/// The same of an arm in space.
std::string base_offset_in_space(const Episode& episode) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_rad = Eigen::Vector3d::Zero();
  const std::vector<int> frames = tracked_frames(episode);
  for (const int t : frames) {
    const SpacePose base =
        space_pose_of(episode.backbone.row(t).head<kSpacePoseSize>().cast<double>());
    point += base.position_m;
    rotation_rad += rotation_vector(base.rotation);
  }
  point /= std::max(double(frames.size()), 1.0);
  rotation_rad /= std::max(double(frames.size()), 1.0);
  if (point.norm() <= kBasePosition_m && rotation_rad.norm() <= kBaseHeading_rad) {
    return {};
  }
  return fmt::format("({:.3f}, {:.3f}, {:.3f}) m, {:.3f} rad", point.x(), point.y(), point.z(),
                     rotation_rad.norm());
}

/// Mean place and heading of the base plate over the frames in which the arm was tracked; zero
/// where it never was.
Pose mean_base(const Episode& episode) {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double cosine = 0.0;
  double sine = 0.0;
  const std::vector<int> frames = tracked_frames(episode);
  for (const int t : frames) {
    const auto base = episode.backbone.row(t).head<kPoseSize>().cast<double>();
    point += base.head<2>().transpose();
    cosine += std::cos(base[2]);
    sine += std::sin(base[2]);
  }
  point /= std::max(double(frames.size()), 1.0);
  return {point.x(), point.y(), std::atan2(sine, cosine)};
}

}  // namespace

std::string base_offset(const Episode& episode) {
  if (episode.dimension == Dimension::space) {
    return base_offset_in_space(episode);
  }
  const Pose base = mean_base(episode);
  if (std::hypot(base.x_m, base.y_m) <= kBasePosition_m &&
      std::abs(base.theta_rad) <= kBaseHeading_rad) {
    return {};
  }
  return fmt::format("({:.3f}, {:.3f}) m, {:.3f} rad", base.x_m, base.y_m, base.theta_rad);
}

double median_gap_m(const Episode& episode, int plate) {
  auto distances = mapped<double>(tracked_frames(episode), [&](const int t) {
    return (episode.position_m(t, plate + 1) - episode.position_m(t, plate)).norm();
  });
  return distances.empty() ? std::numeric_limits<double>::quiet_NaN()
                           : median(std::move(distances));
}

void require_motion(const Episode& episode, const ArmDescription& arm, const std::string& where) {
  const double spread_m = spread_of_end_m(episode);
  if (!(spread_m < kStill * arm.length_m())) {
    return;
  }
  const std::vector<int> tracked = tracked_frames(episode);
  for (Eigen::Index i = 0; i < episode.pressure_kpa.cols(); ++i) {
    const Eigen::VectorXf commands = episode.pressure_kpa(tracked, i);
    const double range = double(commands.maxCoeff()) - double(commands.minCoeff());
    const double limit = arm.limits_of_channel(int(i)).half_width_kpa();
    if (range > kMovingCommand * limit) {
      throw InputError(fmt::format(
          "{}: the arm's end stands still (its position spreads by {:.2g} mm; expected at least "
          "{:.2g} mm) while the {} of {} changes by {:.4g} {}. Was the tracker running, and do "
          "both logs belong together? Record it again, or leave the episode out",
          where, 1e3 * spread_m, 1e3 * kStill * arm.length_m(), arm.command.name,
          channel_name(arm, i), range, arm.command.unit));
    }
  }
}

std::string arm_in_words(const ArmDescription& arm) {
  return arm.name.empty() ? "the arm" : fmt::format("arm '{}'", arm.name);
}

void require_backbones_of(const Episode& episode, const ArmDescription& arm, double slack,
                          const std::string& where) {
  require_gaps(episode, arm, slack, where);
  require_plates_near(episode, arm, where);
}

std::string base_warning(const Recording& recording) {
  for (std::size_t e = 0; e < recording.episodes.size(); ++e) {
    if (const std::string offset = base_offset(recording.episodes[e]); !offset.empty()) {
      return fmt::format(
          "the base plate does not lie at the origin of the arm's frame but at {} ({}, on average; "
          "2 mm and 0.01 rad are allowed). A network of plate-relative poses can't know that, and "
          "its error is as large. Import the logs again with 'alignment: base' in the mapping",
          offset, episode_path(recording.number(e)));
    }
  }
  return {};
}

}  // namespace limber
