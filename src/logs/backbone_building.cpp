#include "backbone_building.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base_alignment.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/log_units.hpp"
#include "log_runs.hpp"
#include "rotation_flips.hpp"

namespace limber {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTurn = 2.0 * M_PI;
constexpr double kLongestChord = 1.2;  // over the length at rest; noise and stretch leave less
constexpr double kNotedLength = 0.03;
// Of the gap behind a base that is not tracked: a place by hand may be a plate's distance off, but
// a length in mm, or degrees for radians, are off by more.
constexpr double kLongestBaseGap = 2.0;
constexpr double kFarthestBaseTurn_rad = 1.5;
constexpr double kMaxHeadingOff_rad = 0.3;  // of the mean one; bodies are defined to a few degrees
constexpr double kNotedHeadingOff_rad = 0.03;  // bodies of a well defined take are off by less
constexpr double kMaxHeadingOffWithoutArcs_rad = 1.5;  // of points that lie segments apart
constexpr double kShortestArc = 0.05;  // chord over length; beyond, the points are no neighbours

// ---- missing points
// ---------------------------------------------------------------------------

/// Row t, that part of the time from one to the other, on the straight line between both.
void bridge(Eigen::Index from, Eigen::Index to, Eigen::Index t, double part, Eigen::Index i,
            PointTracks& tracks) {
  const auto between = [&](double a, double b) { return a + part * (b - a); };
  tracks.x_m(t, i) = between(tracks.x_m(from, i), tracks.x_m(to, i));
  tracks.y_m(t, i) = between(tracks.y_m(from, i), tracks.y_m(to, i));
  if (tracks.has_headings()) {
    const double a = tracks.theta_rad(from, i);
    tracks.theta_rad(t, i) = a + part * std::remainder(tracks.theta_rad(to, i) - a, kTurn);
  }
}

// ---- distances
// --------------------------------------------------------------------------------

double median_distance_m(const PointTracks& tracks, const std::vector<bool>& tracked,
                         Eigen::Index i) {
  std::vector<double> distances;
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    if (tracked[std::size_t(t)]) {
      distances.push_back(std::hypot(tracks.x_m(t, i + 1) - tracks.x_m(t, i),
                                     tracks.y_m(t, i + 1) - tracks.y_m(t, i)));
    }
  }
  return median(std::move(distances));
}

/// Distances between neighbouring points, where no arc can be longer than the arm at rest.
void require_distances(const std::string& log, const std::vector<bool>& tracked,
                       const ImportMapping& mapping, const ArmDescription& arm,
                       const PointTracks& tracks, RunReport& report) {
  const std::vector<double> rest = rest_positions_m(arm);
  double measured_m = 0.0;
  double of_file_m = 0.0;
  std::vector<std::string> wrong;
  double first_ratio = 0.0;
  for (Eigen::Index i = 0; i + 1 < tracks.point_count(); ++i) {
    const int from = tracks.plates[std::size_t(i)];
    const int to = tracks.plates[std::size_t(i + 1)];
    const double rest_m = rest[std::size_t(to)] - rest[std::size_t(from)];
    const double distance_m = median_distance_m(tracks, tracked, i);
    const double ratio = distance_m / rest_m;
    measured_m += distance_m;
    of_file_m += rest_m;
    if (ratio > kLongestChord || ratio < kShortestChord) {
      first_ratio = wrong.empty() ? ratio : first_ratio;
      wrong.push_back(
          fmt::format("'{}' and '{}' ({} and {}) are {:.4g} m apart; the arm "
                      "file has {:.4g} m between them",
                      tracks.names[std::size_t(i)], tracks.names[std::size_t(i + 1)],
                      plate_name(from), plate_name(to), distance_m, rest_m));
    }
  }
  if (!wrong.empty()) {
    const std::string unit = unit_suspicion(first_ratio, mapping.length_unit);
    const bool all = std::ssize(wrong) == tracks.point_count() - 1;
    const std::string advice =
        all && !unit.empty()
            ? fmt::format("The mapping reads lengths in {}: {}", mapping.length_unit, unit)
        : all
            ? std::string("Is it this arm, and are the lengths in the unit that the mapping says?")
            : std::string(
                  "The other distances fit: are the points "
                  "in order, base first, and all in one unit?");
    throw InputError(
        fmt::format("{}: {} of {} distances between neighbouring "
                    "points do not fit arm '{}': {}. {}",
                    log, wrong.size(), tracks.point_count() - 1, arm.name, wrong.front(), advice));
  }
  report.length_ratio = of_file_m > 0.0 ? measured_m / of_file_m : 1.0;
  if (report.length_ratio > 1.0 + kNotedLength) {
    report.note("the points are farther apart than the arm file says",
                fmt::format("{:.1f} % of its length along them", 100.0 * report.length_ratio));
  }
}

/// A base that is no point lies where the mapping says: the point behind it has to lie before it.
void require_base_gap(const std::string& log, const std::vector<bool>& tracked,
                      const ArmDescription& arm, const PointTracks& tracks, RunReport& report) {
  const double rest_m = rest_positions_m(arm)[std::size_t(tracks.plates[1])];
  const double distance_m = median_distance_m(tracks, tracked, 0);
  std::vector<double> turns_rad;
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    if (tracked[std::size_t(t)]) {
      turns_rad.push_back(std::abs(tracks.direction_rad(t, 0, 1)));
    }
  }
  const double turn_rad = median(std::move(turns_rad));
  const std::string found = fmt::format(
      "'{}' ({}) lies {:.4g} m and {:.0f} degrees off the base's heading from where 'alignment' "
      "has the base, in the median row; the arm file has {:.4g} m between them",
      tracks.names[1], plate_name(tracks.plates[1]), distance_m, turn_rad * kDegPerRad, rest_m);
  refuse_if(
      distance_m > kLongestBaseGap * rest_m || turn_rad > kFarthestBaseTurn_rad,
      "{}: {}. Are x_m and y_m in metres, heading_rad in radians, and all of the log's plane?", log,
      found);
  if (distance_m > kLongestChord * rest_m || distance_m < kShortestChord * rest_m) {
    report.note("the base is not where the first point has it: is 'alignment' right?", found);
  }
}

// ---- headings
// ---------------------------------------------------------------------------------

/// Directions from each point to the next in one row, unwrapped along the arm from heading 0.
void chord_directions(const PointTracks& tracks, Eigen::Index t, std::vector<double>& directions) {
  directions.resize(std::size_t(tracks.point_count() - 1));
  double before = 0.0;
  for (Eigen::Index i = 0; i + 1 < tracks.point_count(); ++i) {
    before += std::remainder(tracks.direction_rad(t, i, i + 1) - before, kTurn);
    directions[std::size_t(i)] = before;
  }
}

/// Measured headings point from base to tip, as the plates' line does. Bodies that are defined
/// another way round would make an arm that grows out of its base sideways or backwards. However
/// far an arc turns, its chord has the heading of its middle.
void require_headings_along(const std::string& log, const std::vector<bool>& tracked,
                            const PointTracks& tracks, const ArmDescription& arm,
                            RunReport& report) {
  const auto is_arc = [&](Eigen::Index i) {
    return arm.segment_of_gap(tracks.plates[std::size_t(i)]) ==
           arm.segment_of_gap(tracks.plates[std::size_t(i + 1)] - 1);
  };
  std::vector<Eigen::Index> gaps(std::size_t(tracks.point_count() - 1));
  std::iota(gaps.begin(), gaps.end(), Eigen::Index{0});
  const bool has_arcs = std::ranges::any_of(gaps, is_arc);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Index i : gaps) {
    for (Eigen::Index t = 0; (is_arc(i) || !has_arcs) && t < tracks.row_count(); ++t) {
      if (tracked[std::size_t(t)]) {
        const double theta_rad = tracks.theta_rad(t, i);
        const double turn_rad = std::remainder(tracks.theta_rad(t, i + 1) - theta_rad, kTurn);
        const double off_rad = theta_rad + 0.5 * turn_rad - tracks.direction_rad(t, i, i + 1);
        sum += Eigen::Vector2d(std::cos(off_rad), std::sin(off_rad));
      }
    }
  }
  const double usual_rad = std::atan2(sum.y(), sum.x());
  refuse_if(
      std::abs(usual_rad) > (has_arcs ? kMaxHeadingOff_rad : kMaxHeadingOffWithoutArcs_rad),
      "{}: the headings are {:.0f} degrees off the line from each point to the next, in the "
      "mean; expected along it, from base to tip. Turn the tracked bodies, say with 'straight_s' "
      "in the mapping's alignment when the arm lay straight, or leave the headings out with "
      "'headings: tangent' in its backbone",
      log, usual_rad * kDegPerRad);
  if (has_arcs && std::abs(usual_rad) > kNotedHeadingOff_rad) {
    report.note("the headings are turned against the line from each point to the next, in the mean",
                fmt::format("by {:.1f} degrees; 'straight_s' in the mapping's alignment takes it "
                            "out when the arm lay straight",
                            usual_rad * kDegPerRad));
  }
}

/// A measured heading, modulo a full turn, is the one nearest to where an arc from the point before
/// would lead: twice the chord's direction less that point's heading.
void unwrap_along_arm(PointTracks& tracks) {
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    double before = std::remainder(tracks.theta_rad(t, 0), kTurn);
    tracks.theta_rad(t, 0) = before;
    for (Eigen::Index i = 1; i < tracks.point_count(); ++i) {
      const double expected =
          before + 2.0 * std::remainder(tracks.direction_rad(t, i - 1, i) - before, kTurn);
      before = expected + std::remainder(tracks.theta_rad(t, i) - expected, kTurn);
      tracks.theta_rad(t, i) = before;
    }
  }
}

/// Chords of one segment: where each is an arc, a chord has the heading of its arc's middle, and
/// headings change evenly along the segment.
class SegmentTangents {
 public:
  SegmentTangents(const PointTracks& tracks, const ArmDescription& arm)
      : rest_m_(rest_positions_m(arm)), plates_(tracks.plates) {
    for (std::size_t i = 0; i + 1 < plates_.size(); ++i) {
      const int segment = arm.segment_of_gap(plates_[i]);
      const bool within = segment == arm.segment_of_gap(plates_[i + 1] - 1);
      if (i == 0 || !within || !open_ || segment != last_segment_) {
        groups_.push_back({i, i + 1});
      }
      groups_.back().end = i + 1;
      last_segment_ = segment;
      open_ = within;
    }
  }

  /// Headings of all points of a row, from the chords' directions.
  void headings(const std::vector<double>& directions, std::vector<double>& theta) const {
    theta.assign(plates_.size(), 0.0);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const Group& group = groups_[g];
      for (std::size_t i = group.begin + 1; i < group.end; ++i) {
        theta[i] = between(directions, i);
      }
      const bool is_last = g + 1 == groups_.size();
      const double from_left = group.size() > 1
                                   ? beyond(directions, group.end - 1, group.end - 2)
                                   : 2.0 * directions[group.begin] - theta[group.begin];
      const bool right_known = !is_last && groups_[g + 1].size() > 1;
      theta[group.end] = right_known
                             ? 0.5 * (from_left + beyond(directions, group.end, group.end + 1))
                             : from_left;
    }
  }

 private:
  struct Group {
    std::size_t begin;  // chords begin … end − 1, between points begin … end
    std::size_t end;
    std::size_t size() const { return end - begin; }
  };

  double length_m(std::size_t chord) const {
    return rest_m_[std::size_t(plates_[chord + 1])] - rest_m_[std::size_t(plates_[chord])];
  }

  /// At point i, between chords i − 1 and i.
  double between(const std::vector<double>& directions, std::size_t i) const {
    const double a = length_m(i - 1);
    const double b = length_m(i);
    return directions[i - 1] + (directions[i] - directions[i - 1]) * a / (a + b);
  }

  /// At the far end of chord `end`, away from its neighbour `inner`.
  double beyond(const std::vector<double>& directions, std::size_t end, std::size_t inner) const {
    const double a = length_m(end);
    const double b = length_m(inner);
    return directions[end] + (directions[end] - directions[inner]) * a / (a + b);
  }

  std::vector<double> rest_m_;
  std::vector<int> plates_;
  std::vector<Group> groups_;
  int last_segment_ = -1;
  bool open_ = false;
};

/// Headings of points along an arm of which each segment is an arc, from positions alone: T×k.
/// @param tracks  in frame B, every cell finite, the base first: its heading is 0.
Eigen::MatrixXd tangent_headings(const PointTracks& tracks, const ArmDescription& arm) {
  const SegmentTangents tangents(tracks, arm);
  Eigen::MatrixXd theta_rad(tracks.row_count(), tracks.point_count());
  std::vector<double> directions;
  std::vector<double> headings;
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    chord_directions(tracks, t, directions);
    tangents.headings(directions, headings);
    theta_rad.row(t) = Eigen::Map<const Eigen::RowVectorXd>(headings.data(), tracks.point_count());
  }
  return theta_rad;
}

// ---- plates between points
// --------------------------------------------------------------------

/// On the curve from pose a to pose b: the arc that turns as much as they differ, and across it the
/// cubic that fits both headings' common deviation from that arc.
Pose on_curve(const Pose& a, const Pose& b, double part) {
  const double turn = b.theta_rad - a.theta_rad;
  const double chord = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
  const double mean = 0.5 * (a.theta_rad + b.theta_rad);
  const double deviation = std::remainder(mean - std::atan2(b.y_m - a.y_m, b.x_m - a.x_m), kTurn);
  const double direction = mean - deviation;
  const double length = chord / std::max(chord_share(turn), kShortestArc);
  const Pose on_arc =
      compose(Pose{a.x_m, a.y_m, direction - 0.5 * turn}, arc(part * length, part * turn));
  const double across = chord * deviation * part * (part - 1.0) * (2.0 * part - 1.0);
  return {on_arc.x_m - std::sin(direction) * across, on_arc.y_m + std::cos(direction) * across,
          on_arc.theta_rad + deviation * (6.0 * part * (part - 1.0) + 1.0)};
}

/// Poses of every plate, from those of the points.
Eigen::MatrixXd poses_of_plates(const PointTracks& tracks, const std::vector<bool>& tracked,
                                const ArmDescription& arm) {
  const std::vector<double> rest = rest_positions_m(arm);
  Eigen::MatrixXd poses =
      Eigen::MatrixXd::Constant(tracks.row_count(), kPoseSize * arm.point_count(), kNan);
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    if (!tracked[std::size_t(t)]) {
      continue;
    }
    const auto pose_at = [&](Eigen::Index i) {
      return Pose{tracks.x_m(t, i), tracks.y_m(t, i), tracks.theta_rad(t, i)};
    };
    const auto put = [&](int plate, const Pose& pose) {
      poses.row(t).segment<kPoseSize>(kPoseSize * plate) << pose.x_m, pose.y_m, pose.theta_rad;
    };
    put(tracks.plates.front(), pose_at(0));
    for (Eigen::Index i = 0; i + 1 < tracks.point_count(); ++i) {
      const int from = tracks.plates[std::size_t(i)];
      const int to = tracks.plates[std::size_t(i + 1)];
      for (int plate = from + 1; plate < to; ++plate) {
        put(plate, on_curve(pose_at(i), pose_at(i + 1),
                            (rest[std::size_t(plate)] - rest[std::size_t(from)]) /
                                (rest[std::size_t(to)] - rest[std::size_t(from)])));
      }
      put(to, pose_at(i + 1));
    }
  }
  return poses;
}

/// What comes before frame B is looked for.
BackboneTrack bridge_points(const std::string& log, const ImportMapping& mapping,
                            const ArmDescription& arm, PointTracks& tracks, RunReport& report) {
  if (!mapping.headings_measured && tracks.has_headings()) {
    report.note("logged headings left out: 'headings: tangent'");
    tracks.theta_rad.resize(0, 0);
  }
  BackboneTrack track;
  if (tracks.has_headings()) {
    settle_headings(arm.length_m(), mapping.longest_gap_s, tracks, report);
  }
  show_still_base(tracks, report);
  fill_gaps(log, mapping.longest_gap_s, tracks, track, report, bridge);
  // Before looking for the base: a wrong unit or order would cause a stranger message there.
  require_distances(log, track.tracked, mapping, arm, tracks, report);
  return track;
}

}  // namespace

BaseSighting sight_base(const std::string& log, PointTracks tracks, const ImportMapping& mapping,
                        const ArmDescription& arm) {
  RunReport unused;
  const BackboneTrack track = bridge_points(log, mapping, arm, tracks, unused);
  return sight_base(log, track.tracked, mapping.alignment, arm, tracks);
}

BackboneTrack build_backbone(const std::string& log, PointTracks tracks,
                             const ImportMapping& mapping, const ArmDescription& arm,
                             RunReport& report) {
  BackboneTrack track = bridge_points(log, mapping, arm, tracks, report);
  const bool base_tracked = tracks.plates.front() == 0;
  align_base(log, track.tracked, mapping.alignment, arm, tracks, report);
  if (!base_tracked) {
    require_base_gap(log, track.tracked, arm, tracks, report);
  }
  if (tracks.has_headings()) {
    require_headings_along(log, track.tracked, tracks, arm, report);
    unwrap_along_arm(tracks);
  } else {
    tracks.theta_rad = tangent_headings(tracks, arm);
    report.note("positions only: headings are the tangent's");
  }
  if (tracks.point_count() < arm.point_count()) {
    report.note("plates without a point of their own, put on the curve between their neighbours",
                {}, arm.point_count() - tracks.point_count());
  }
  track.poses = poses_of_plates(tracks, track.tracked, arm);
  track.time_s = std::move(tracks.time_s);
  return track;
}

}  // namespace limber
