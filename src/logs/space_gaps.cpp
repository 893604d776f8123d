#include "space_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "import_steps.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/log_units.hpp"
#include "space_backbone.hpp"

namespace limber {

namespace {

constexpr double kLongestSpaceChord = 1.5;   // over the length at rest, as recordings allow
constexpr double kShortestSpaceChord = 0.2;  // an arc of 4.6 rad has this
constexpr double kFarthestOffX_rad = 1.2;    // half of how far an arm bends between two points
constexpr double kShortShare = 0.05;
constexpr double kLongShare = 0.95;
constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;

/// Rows t of (from, to) on the way between both.
void bridge_in_space(Eigen::Index from, Eigen::Index to, Eigen::Index i, SpaceTracks& tracks) {
  const auto time = [&](Eigen::Index t) { return tracks.time_s[std::size_t(t)]; };
  const SpacePose a = tracks.pose(from, i);
  const SpacePose b = tracks.pose(to, i);
  for (Eigen::Index t = from + 1; t < to; ++t) {
    const double part = (time(t) - time(from)) / (time(to) - time(from));
    tracks.put(
        t, i,
        {a.position_m + part * (b.position_m - a.position_m), a.rotation.slerp(part, b.rotation)});
  }
}

}  // namespace

void fill_space_gaps(const std::string& log, double longest_gap_s, SpaceTracks& tracks,
                     BackboneTrack& track, RunReport& report) {
  const Eigen::Index rows = tracks.row_count();
  track.tracked.assign(std::size_t(rows), true);
  track.bridged.assign(std::size_t(rows), false);
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    const std::string& name = tracks.names[std::size_t(i)];
    const int plate = tracks.plates[std::size_t(i)];
    const Eigen::Index missing = bridge_hidden_rows(
        tracks.time_s, longest_gap_s, [&](Eigen::Index t) { return tracks.is_tracked(t, i); },
        [&](Eigen::Index before, Eigen::Index t) { bridge_in_space(before, t, i, tracks); },
        track.tracked, track.bridged);
    note_point(log, name, plate, missing, rows, report);
  }
  note_hidden_rows(log, longest_gap_s, track.tracked, track.bridged, report);
}

GapMeasurement::GapMeasurement(std::vector<int> plates, std::vector<double> rest_m)
    : plates_(std::move(plates)), rest_m_(std::move(rest_m)), gaps_(plates_.size() - 1) {}

double GapMeasurement::rest_m(std::size_t gap) const {
  return rest_m_[std::size_t(plates_[gap + 1])] - rest_m_[std::size_t(plates_[gap])];
}

void GapMeasurement::add(const std::vector<SpacePose>& points) {
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

void GapMeasurement::require_of(const std::string& log, const ImportMapping& mapping,
                                const ArmDescription& arm, const SpaceTracks& tracks) const {
  const std::size_t first = tracks.tracks_base() ? 0 : 1;  // a base that is no point has no name
  const auto name = [&](std::size_t point) {
    return point < first
               ? std::string("the base")
               : fmt::format("'{}' ({})", tracks.names[point - first], plate_name(plates_[point]));
  };
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const double chord_m = median(gaps_[i].chord_m);
    const double ratio = chord_m / rest_m(i);
    if (ratio > kLongestSpaceChord || ratio < kShortestSpaceChord) {
      const std::string unit = unit_suspicion(ratio, mapping.length_unit);
      throw InputError(fmt::format(
          "{}: {} and {} are {:.4g} m apart in the median row; arm '{}' has {:.4g} m between them, "
          "and {:.4g} m to {:.4g} m are allowed. {}",
          log, name(i), name(i + 1), chord_m, arm.name, rest_m(i), kShortestSpaceChord * rest_m(i),
          kLongestSpaceChord * rest_m(i),
          unit.empty()
              ? "Are the points in order, and is the base where 'alignment' says?"
              : fmt::format("The mapping reads lengths in {}: {}", mapping.length_unit, unit)));
    }
  }
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const double off_rad = median(gaps_[i].off_x_rad);
    if (off_rad > kFarthestOffX_rad) {
      throw InputError(fmt::format(
          "{}: seen from {}, {} lies {:.0f} degrees off the x axis in the median row; expected at "
          "most {:.0f}: x points along the straight arm, to its tip. Say where it does with "
          "'alignment: {{x_axis: [x, y, z]}}' or '{{rest_s: [from, to]}}'; bodies' rotations then "
          "count from the log's axes, or from the rest",
          log, name(i), name(i + 1), off_rad * kDegreesPerRad, kFarthestOffX_rad * kDegreesPerRad));
    }
  }
}

std::vector<SpaceGapReport> GapMeasurement::report() const {
  std::vector<SpaceGapReport> reports;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const Gap& gap = gaps_[i];
    reports.push_back({plates_[i], plates_[i + 1], rest_m(i), median(gap.length_m),
                       quantile(gap.length_m, kShortShare), quantile(gap.length_m, kLongShare),
                       median(gap.off_arc_rad)});
  }
  return reports;
}

}  // namespace limber
