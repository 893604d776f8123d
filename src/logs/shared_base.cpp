#include "shared_base.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "backbone_building.hpp"
#include "base_alignment.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/log_units.hpp"
#include "space_alignment.hpp"

namespace limber {

namespace {

// Where a bolted arm points, by logs in which it bends now this way, now that, differs by less; a
// base that was mounted anew may differ by more.
constexpr double kSameDirection_rad = 0.05;

/// A base, in the plane at z 0.
struct Place {
  Eigen::Vector3d position_m;
  Eigen::Vector3d x_axis;
};

double off_m(const Place& place, const Place& other) {
  return (place.position_m - other.position_m).norm();
}

double off_rad(const Place& place, const Place& other) {
  return std::atan2(place.x_axis.cross(other.x_axis).norm(), place.x_axis.dot(other.x_axis));
}

Place median_of(const std::vector<Place>& places) {
  Place result;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> positions;
    std::vector<double> directions;
    for (const Place& place : places) {
      positions.push_back(place.position_m[axis]);
      directions.push_back(place.x_axis[axis]);
    }
    result.position_m[axis] = median(std::move(positions));
    result.x_axis[axis] = median(std::move(directions));
  }
  result.x_axis.normalize();
  return result;
}

struct SharedPlace {
  Place place;
  std::vector<bool> has_it;
  LogsBase report;
};

/// None where most do not agree.
std::optional<SharedPlace> shared_place(const std::vector<Place>& places) {
  const Place middle = median_of(places);
  SharedPlace shared;
  std::vector<Place> same;
  for (const Place& place : places) {
    shared.has_it.push_back(off_m(place, middle) < kBaseStandsStill_m &&
                            off_rad(place, middle) < kSameDirection_rad);
    if (shared.has_it.back()) {
      same.push_back(place);
    }
  }
  if (same.size() < 2 || 2 * same.size() <= places.size()) {
    return {};
  }
  shared.place = median_of(same);
  shared.report.logs = int(same.size());
  for (const Place& place : same) {
    shared.report.most_off_m = std::max(shared.report.most_off_m, off_m(place, shared.place));
    shared.report.most_off_rad = std::max(shared.report.most_off_rad, off_rad(place, shared.place));
  }
  return shared;
}

template <class Tracks>
void note_others(const SharedPlace& shared, std::vector<ReadRun<Tracks>>& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!shared.has_it[i]) {
      runs[i].run.report.note("the base lies elsewhere than in the other logs: it keeps its own");
    }
  }
}

/// The points of each run in order of time. @param sight  (name, points)
template <class Tracks, class Sight>
void sight_each(const std::vector<ReadRun<Tracks>>& runs, const Sight& sight) {
  for (const ReadRun<Tracks>& read : runs) {
    throw_if_interrupted();
    Tracks points = read.run.points;
    RunReport unused;
    put_in_order(read.name, points, unused);
    sight(read.name, std::move(points));
  }
}

std::string text_of(const Eigen::Vector3d& v) {
  return fmt::format("[{:.5f}, {:.5f}, {:.5f}]", v.x(), v.y(), v.z());
}

}  // namespace

std::optional<LogsBase> share_base(const ImportMapping& mapping, const ArmDescription& arm,
                                   std::vector<ReadRun<PointTracks>>& runs) {
  using Kind = BaseAlignment::Kind;
  const bool counts_headings_anew = mapping.alignment.kind == Kind::straight &&
                                    mapping.headings_measured &&
                                    runs.front().run.points.has_headings();
  if (runs.size() < 2 || !is_base_sought(mapping.alignment) || counts_headings_anew) {
    return {};
  }
  std::vector<BaseSighting> sightings;
  sight_each(runs, [&](const std::string& name, PointTracks points) {
    sightings.push_back(sight_base(name, std::move(points), mapping, arm));
  });
  const std::vector<Pose> bases = bases_of(sightings);
  const auto places = mapped<Place>(bases, [&](const Pose& base) {
    return Place{{base.x_m, base.y_m, 0.0},
                 {std::cos(base.theta_rad), std::sin(base.theta_rad), 0.0}};
  });
  const std::optional<SharedPlace> shared = shared_place(places);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Place& place = shared && shared->has_it[i] ? shared->place : places[i];
    runs[i].mapping.alignment.kind = Kind::fixed;
    runs[i].mapping.alignment.pose = {place.position_m.x(), place.position_m.y(),
                                      std::atan2(place.x_axis.y(), place.x_axis.x())};
  }
  if (!shared) {
    return {};
  }
  note_others(*shared, runs);
  LogsBase report = shared->report;
  report.alignment = fmt::format("{{x_m: {:.5f}, y_m: {:.5f}, heading_rad: {:.5f}}}",
                                 shared->place.position_m.x(), shared->place.position_m.y(),
                                 std::atan2(shared->place.x_axis.y(), shared->place.x_axis.x()));
  return report;
}

std::optional<LogsBase> share_base(const ImportMapping& mapping, const ArmDescription& /*arm*/,
                                   std::vector<ReadRun<SpaceTracks>>& runs) {
  const SpaceAlignment& asked = mapping.space_alignment;
  if (runs.size() < 2 || !asked.rest_s || asked.x_axis) {
    return {};
  }
  std::vector<Place> places;
  sight_each(runs, [&](const std::string& name, const SpaceTracks& points) {
    const SpacePose X_LB = frame_in_log(name, asked, points);
    places.push_back({X_LB.position_m, X_LB.rotation * Eigen::Vector3d::UnitX()});
  });
  const std::optional<SharedPlace> shared = shared_place(places);
  if (!shared) {
    return {};
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (shared->has_it[i]) {
      runs[i].mapping.space_alignment.position_m = shared->place.position_m;
      runs[i].mapping.space_alignment.x_axis = shared->place.x_axis;
    }
  }
  note_others(*shared, runs);
  LogsBase report = shared->report;
  report.alignment =
      fmt::format("{{position_m: {}, x_axis: {}{}, rest_s: [{:.6g}, {:.6g}]}}",
                  text_of(shared->place.position_m), text_of(shared->place.x_axis),
                  asked.y_axis ? fmt::format(", y_axis: {}", text_of(*asked.y_axis)) : "",
                  asked.rest_s->x(), asked.rest_s->y());
  return report;
}

Json to_json(const LogsBase& shared) {
  return {{"alignment", shared.alignment},
          {"logs", shared.logs},
          {"most_off_m", shared.most_off_m},
          {"most_off_rad", shared.most_off_rad}};
}

std::string to_text(const LogsBase& shared, std::ptrdiff_t runs) {
  return fmt::format(
      "base: one for {} of {} logs, each of which alone has it within {:.1f} mm and {:.4f} rad of "
      "there. For later logs: 'alignment: {}'\n",
      shared.logs, runs, kMmPerM * shared.most_off_m, shared.most_off_rad, shared.alignment);
}

}  // namespace limber
