#include "space_motive.hpp"

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "motive_plates.hpp"

namespace limber {

SpaceTracks space_motive_tracks(const std::string& log, const MotiveTake& take,
                                const ImportMapping& mapping, const ArmDescription& arm,
                                RunReport& report) {
  const PlateFinder finder(log, take, report);
  const std::vector<PointSource> points =
      mapping.points.empty() ? finder.default_points(arm) : mapping.points;
  const auto rows = static_cast<Eigen::Index>(take.time_s.size());
  SpaceTracks tracks;
  tracks.time_s = take.time_s;
  tracks.poses.resize(rows, kSpacePoseSize * std::ssize(points));
  for (Eigen::Index i = 0; i < std::ssize(points); ++i) {
    const PointSource& point = points[std::size_t(i)];
    if (point.body.empty() && point.marker.empty()) {
      throw InputError(
          fmt::format("{}: the mapping names column '{}' for {}; of a Motive file expected body or "
                      "marker",
                      log, point.x, plate_name(point.plate)));
    }
    const MotiveObject& object =
        point.body.empty() ? finder.marker(point.marker) : finder.body(point.body);
    const bool has_rotation = object.rotation.size() > 0;
    tracks.names.push_back(object.name);
    tracks.plates.push_back(point.plate);
    tracks.has_rotation.push_back(has_rotation);
    const Eigen::Index first = kSpacePoseSize * i;
    tracks.poses.middleCols<3>(first) = object.position_m;
    if (has_rotation) {
      tracks.poses.middleCols<4>(first + 3) = object.rotation;
    } else {
      tracks.poses.middleCols<4>(first + 3).rowwise() = Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
    }
  }
  return tracks;
}

}  // namespace limber
