#include "space_backbone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/log_units.hpp"
#include "log_runs.hpp"
#include "rotation_flips.hpp"
#include "space_alignment.hpp"
#include "space_tracks.hpp"

namespace limber {

namespace {

constexpr double kLongestSpaceChord = 1.5;  // over the length at rest, as recordings allow
constexpr double kFarthestOffX_rad = 1.2;   // half of how far an arm bends between two points
// Of rotations in the median row. Within a segment a laboratory's two-segment arm has 5 degrees at
// most; over several segments, which bend apart, an arm of arcs has 20 by itself.
constexpr double kFarOffArc_rad = 30.0 * kRadPerDeg;
constexpr double kFarOffOverSegments_rad = 1.0;
constexpr double kShortShare = 0.05;
constexpr double kLongShare = 0.95;

/// Distances and directions from each point to the next, over the rows of a log.
class GapMeasurement {
 public:
  /// @param plates  of the points; `rest_m`: how far along the arm at rest each plate lies
  GapMeasurement(std::vector<int> plates, std::vector<double> rest_m)
      : plates_(std::move(plates)), rest_m_(std::move(rest_m)), gaps_(plates_.size() - 1) {}

  void add(const std::vector<SpacePose>& points) {
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const SpacePose step = between(points[i], points[i + 1]);
      const SpacePose arc = arc_to(step.position_m);
      const double chord_m = step.position_m.norm();
      Gap& gap = gaps_[i];
      gap.chord_m.push_back(chord_m);
      gap.length_m.push_back(chord_m / sine_over(0.5 * rotation_vector(step.rotation).norm()));
      gap.off_arc_rad.push_back(arc.rotation.angularDistance(step.rotation));
      gap.off_x_rad.push_back(std::atan2(step.position_m.tail<2>().norm(), step.position_m.x()));
    }
  }

  /// Requires distances and directions of the arm in the median row.
  /// @throws InputError, its message beginning with `log`
  void require_of(const std::string& log, const ImportMapping& mapping, const ArmDescription& arm,
                  const SpaceTracks& tracks) const {
    const std::size_t first = tracks.tracks_base() ? 0 : 1;  // a base that is no point has no name
    const auto name = [&](std::size_t point) {
      return point < first ? std::string("the base")
                           : fmt::format("'{}' ({})", tracks.names[point - first],
                                         plate_name(plates_[point]));
    };
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const double chord_m = median(gaps_[i].chord_m);
      const double ratio = chord_m / rest_m(i);
      if (ratio > kLongestSpaceChord || ratio < kShortestChord) {
        const std::string unit = unit_suspicion(ratio, mapping.length_unit);
        throw InputError(fmt::format(
            "{}: {} and {} are {:.4g} m apart in the median row; arm '{}' has {:.4g} m between "
            "them, and {:.4g} m to {:.4g} m are allowed. {}",
            log, name(i), name(i + 1), chord_m, arm.name, rest_m(i), kShortestChord * rest_m(i),
            kLongestSpaceChord * rest_m(i),
            unit.empty()
                ? "Are the points in order, and is the base where 'alignment' says? Of an arm that "
                  "stretches, length_m is what it usually has"
                : fmt::format("The mapping reads lengths in {}: {}", mapping.length_unit, unit)));
      }
    }
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const double off_rad = median(gaps_[i].off_x_rad);
      refuse_if(
          off_rad > kFarthestOffX_rad,
          "{}: seen from {}, {} lies {:.0f} degrees off the x axis in the median row; expected "
          "at most {:.0f}: x points along the straight arm, to its tip. Say where it does with "
          "'alignment: {{x_axis: [x, y, z]}}' or '{{rest_s: [from, to]}}'; bodies' rotations "
          "then count from the log's axes, or from the rest",
          log, name(i), name(i + 1), off_rad * kDegPerRad, kFarthestOffX_rad * kDegPerRad);
    }
  }

  std::vector<SpaceGapReport> report() const {
    std::vector<SpaceGapReport> reports;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const Gap& gap = gaps_[i];
      reports.push_back({plates_[i], plates_[i + 1], rest_m(i), median(gap.length_m),
                         quantile(gap.length_m, kShortShare), quantile(gap.length_m, kLongShare),
                         median(gap.off_arc_rad)});
    }
    return reports;
  }

 private:
  struct Gap {
    std::vector<double> chord_m;
    std::vector<double> length_m;     // along the arc
    std::vector<double> off_arc_rad;  // of the rotation there
    std::vector<double> off_x_rad;    // of the chord
  };

  double rest_m(std::size_t gap) const {
    return rest_m_[std::size_t(plates_[gap + 1])] - rest_m_[std::size_t(plates_[gap])];
  }

  std::vector<int> plates_;
  std::vector<double> rest_m_;
  std::vector<Gap> gaps_;
};

/// Row t, that part of the time from one to the other, between both; rotations on the shortest way.
void bridge_in_space(Eigen::Index from, Eigen::Index to, Eigen::Index t, double part,
                     Eigen::Index i, SpaceTracks& tracks) {
  const SpacePose a = tracks.pose(from, i);
  const SpacePose b = tracks.pose(to, i);
  tracks.put(
      t, i,
      {a.position_m + part * (b.position_m - a.position_m), a.rotation.slerp(part, b.rotation)});
}

constexpr double kStrayShare = 0.95;

/// V of exp: the end of a curve of constant strain (v, ω) lies at V(ω) v.
Eigen::Matrix3d end_of_strain(const Eigen::Vector3d& omega) {
  Eigen::Matrix3d result;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    // element() is V e_x; another axis is x in a frame turned by a third about (1, 1, 1).
    const auto turned = [](const Eigen::Vector3d& v, Eigen::Index by) {
      return Eigen::Vector3d(v[by % 3], v[(1 + by) % 3], v[(2 + by) % 3]);
    };
    const Eigen::Vector3d end = element(1.0, turned(omega, axis)).position_m;
    result.col(axis) = turned(end, 3 - axis);
  }
  return result;
}

/// Poses of the points of one row, in frame B; a plate 0 that is no point comes first.
std::vector<SpacePose> poses_of_points(const SpaceTracks& tracks, Eigen::Index t) {
  std::vector<SpacePose> poses;
  if (!tracks.tracks_base()) {
    poses.emplace_back();
  }
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    SpacePose pose = tracks.pose(t, i);
    if (!tracks.has_rotations() && !poses.empty()) {
      const SpacePose& before = poses.back();
      pose.rotation = before.rotation * arc_to(between(before, pose).position_m).rotation;
    }
    poses.push_back(pose);
  }
  return poses;
}

/// The numbers of every plate in one row.
Eigen::RowVectorXd row_of_plates(const std::vector<SpacePose>& points,
                                 const std::vector<int>& plates,
                                 const std::vector<double>& rest_m) {
  Eigen::RowVectorXd row(kSpacePoseSize * std::ssize(rest_m));
  const auto put = [&](int plate, const SpacePose& pose) {
    row.segment<kSpacePoseSize>(kSpacePoseSize * plate) = numbers_of(pose).transpose();
  };
  put(0, points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double from_m = rest_m[std::size_t(plates[i - 1])];
    const double length_m = rest_m[std::size_t(plates[i])] - from_m;
    for (int plate = plates[i - 1] + 1; plate < plates[i]; ++plate) {
      put(plate, compose(points[i - 1], along(between(points[i - 1], points[i]),
                                              (rest_m[std::size_t(plate)] - from_m) / length_m)));
    }
    put(plates[i], points[i]);
  }
  return row;
}

/// All plates but the base have rotations, or none.
void leave_out_rotations(bool asked, SpaceTracks& tracks, RunReport& report) {
  const std::ptrdiff_t first = tracks.tracks_base() ? 1 : 0;
  const auto begin = tracks.has_rotation.begin() + first;
  const auto some = std::count(begin, tracks.has_rotation.end(), true);
  const bool all = some == tracks.point_count() - first;
  if (some > 0 && (asked || !all)) {
    report.note(asked ? "logged rotations left out: 'headings: tangent'"
                      : "some points have a rotation and some have none: all are left out");
    std::fill(begin, tracks.has_rotation.end(), false);
  }
}

/// Rotations that say another shape than places do are noted: an odd body may be meant so.
void note_far_off_arcs(const ArmDescription& arm, RunReport& report) {
  for (const SpaceGapReport& gap : report.space->gaps) {
    const bool is_arc = arm.segment_of_gap(gap.from) == arm.segment_of_gap(gap.to - 1);
    if (gap.off_arc_rad > (is_arc ? kFarOffArc_rad : kFarOffOverSegments_rad)) {
      report.note(
          "warning: measured rotations are far off the arcs from point to point. Are the columns "
          "in the order qx, qy, qz, qw (w last), is none of them mirrored, and were all bodies "
          "defined on the straight arm? 'rest_s' in the alignment counts them from the rest, "
          "'headings: tangent' leaves them out",
          fmt::format("{:.0f} degrees from {} to {} in the median row",
                      kDegPerRad * gap.off_arc_rad, plate_name(gap.from), plate_name(gap.to)));
    }
  }
}

void measure_strays(const BackboneTrack& track, const std::vector<int>& plates,
                    SpaceRunReport& report) {
  for (const int plate : plates) {
    std::vector<double> places[3];
    for (Eigen::Index t = 0; t < track.row_count(); ++t) {
      for (Eigen::Index axis = 0; track.tracked[std::size_t(t)] && axis < 3; ++axis) {
        places[axis].push_back(track.poses(t, kSpacePoseSize * plate + axis));
      }
    }
    const Eigen::Vector3d middle(median(places[0]), median(places[1]), median(places[2]));
    auto off_m = mapped<double>(places[0].size(), [&](std::size_t i) {
      return (Eigen::Vector3d(places[0][i], places[1][i], places[2][i]) - middle).norm();
    });
    report.plates.push_back({plate, quantile(std::move(off_m), kStrayShare)});
  }
}

}  // namespace

SpacePose arc_to(const Eigen::Vector3d& point) {
  const double across = std::hypot(point.y(), point.z());
  const double alpha = std::atan2(across, point.x());
  // The axis is x × point, and the arc turns by twice its chord's angle.
  const Eigen::Vector3d omega =
      across > 0.0
          ? Eigen::Vector3d(2.0 * alpha / across * Eigen::Vector3d(0.0, -point.z(), point.y()))
          : Eigen::Vector3d::Zero();
  return {point, rotation_of_vector(omega)};
}

SpacePose along(const SpacePose& step, double part) {
  const Eigen::Vector3d omega = rotation_vector(step.rotation);
  const Eigen::Vector3d strain = end_of_strain(omega).partialPivLu().solve(step.position_m);
  const Eigen::Vector3d turned = part * omega;
  return {end_of_strain(turned) * (part * strain), rotation_of_vector(turned)};
}

BackboneTrack build_backbone(const std::string& log, SpaceTracks tracks,
                             const ImportMapping& mapping, const ArmDescription& arm,
                             RunReport& report) {
  SpaceRunReport& space = report.space.emplace();
  space.repeated_rows = drop_repeated_poses(tracks);
  leave_out_rotations(!mapping.headings_measured, tracks, report);
  space.lifted = !tracks.has_rotations();
  space.flips = settle_rotations(arm.length_m(), mapping.longest_gap_s, tracks);
  align_in_space(log, mapping.space_alignment, tracks, report);
  BackboneTrack track;
  fill_gaps(log, mapping.longest_gap_s, tracks, track, report, bridge_in_space);
  std::vector<int> plates = tracks.plates;
  if (!tracks.tracks_base()) {
    plates.insert(plates.begin(), 0);
  }
  const std::vector<double> rest_m = rest_positions_m(arm);
  track.poses = Eigen::MatrixXd::Constant(tracks.row_count(), kSpacePoseSize * arm.point_count(),
                                          std::numeric_limits<double>::quiet_NaN());
  GapMeasurement gaps(plates, rest_m);
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    if (track.tracked[std::size_t(t)]) {
      const std::vector<SpacePose> points = poses_of_points(tracks, t);
      gaps.add(points);
      track.poses.row(t) = row_of_plates(points, plates, rest_m);
    }
  }
  gaps.require_of(log, mapping, arm, tracks);
  space.gaps = gaps.report();
  note_far_off_arcs(arm, report);
  for (Eigen::Index plate = 0; plate < arm.point_count(); ++plate) {
    make_signs_continuous(track.poses.middleCols(kSpacePoseSize * plate + 3, 4));
  }
  if (std::ssize(plates) < arm.point_count()) {
    report.note("plates without a point of their own, put on the curve between their neighbours",
                {}, arm.point_count() - std::ssize(plates));
  }
  track.time_s = std::move(tracks.time_s);
  measure_strays(track, plates, space);
  return track;
}

}  // namespace limber
