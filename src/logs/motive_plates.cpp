#include "motive_plates.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kUnitMiss = 0.02;  // quaternions are written with six digits

/// Measured or solved, by what is asked for.
bool is_body(const MotiveObject& object) {
  return object.type == "Rigid Body" || object.type == "Bone";
}
bool is_measured_marker(const MotiveObject& object) {
  return object.type.ends_with("Marker") && !is_body(object) &&
         object.type != "Rigid Body Marker" && object.type != "Bone Marker";
}
bool is_solved_marker(const MotiveObject& object) {
  return object.type == "Rigid Body Marker" || object.type == "Bone Marker";
}

/// "Plate 9" before "Plate 10".
bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    const bool digits = std::isdigit(static_cast<unsigned char>(a[i])) != 0 &&
                        std::isdigit(static_cast<unsigned char>(b[j])) != 0;
    if (!digits) {
      if (a[i] != b[j]) {
        return a[i] < b[j];
      }
      ++i;
      ++j;
      continue;
    }
    const auto number = [](const std::string& text, std::size_t& index) {
      double value = 0.0;
      while (index < text.size() && std::isdigit(static_cast<unsigned char>(text[index])) != 0) {
        value = 10.0 * value + (text[index++] - '0');
      }
      return value;
    };
    const double x = number(a, i);
    const double y = number(b, j);
    if (x != y) {
      return x < y;
    }
  }
  return a.size() - i < b.size() - j;
}

constexpr double kFlat_m = 0.02;         // plates tilt, tables are not quite level
constexpr double kClearlyFlatter = 0.5;  // another axis has less than this part of the spread

/// The plane's two axes and its normal, right-handed, as columns of a position; the first as it is.
struct Plane {
  int forward;
  int left;
  int up;
  double left_sign;
  double up_sign;
};

Plane plane_of(const std::string& up) {
  if (up == "x") return {1, 2, 0, 1.0, 1.0};
  if (up == "z") return {0, 1, 2, 1.0, 1.0};
  if (up == "-x") return {2, 1, 0, 1.0, -1.0};
  if (up == "-y") return {0, 2, 1, 1.0, -1.0};
  if (up == "-z") return {1, 0, 2, 1.0, -1.0};
  return {0, 2, 1, -1.0, 1.0};
}

/// Spread of a column: between its 2nd and 98th percentile.
double spread(const Eigen::MatrixXd& positions, Eigen::Index axis) {
  std::vector<double> values;
  for (Eigen::Index t = 0; t < positions.rows(); ++t) {
    if (std::isfinite(positions(t, axis))) {
      values.push_back(positions(t, axis));
    }
  }
  return values.empty() ? 0.0 : quantile(values, 0.98) - quantile(values, 0.02);
}

/// The arm lies in a plane; what a point does across it tells a wrong axis from a tilted table.
void require_plane(const std::string& log, const std::vector<Eigen::MatrixXd>& positions,
                   const ImportMapping& mapping, RunReport& report) {
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (const Eigen::MatrixXd& position : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      largest[axis] = std::max(largest[axis], spread(position, axis));
    }
  }
  const double across_m = largest[plane_of(mapping.up).up];
  if (across_m <= kFlat_m) {
    return;
  }
  int flattest = 0;
  const double min_m = largest.minCoeff(&flattest);
  if (min_m < kClearlyFlatter * across_m) {
    throw InputError(
        fmt::format("{}: points move by {:.3f} m along {}, which should leave the "
                    "arm's plane, and by only {:.3f} m along {}. Say in the mapping "
                    "which axis is up: 'backbone: {{up: {}}}' (Motive's own is y)",
                    log, across_m, mapping.up, min_m, "xyz"[flattest], "xyz"[flattest]));
  }
  report.note("points leave the plane: what they do across it is left out",
              fmt::format("by {:.3f} m", across_m));
}

struct PointSeries {
  std::string name;
  Eigen::MatrixXd position_m;   // T×3
  Eigen::VectorXd heading_rad;  // empty if none
};

PointSeries series_of(const PointSource& point, const PlateFinder& finder, const Plane& plane) {
  const auto angle = [](double y, double x) { return std::atan2(y, x); };
  if (!point.body.empty()) {
    const MotiveObject& body = finder.body(point.body);
    PointSeries series{body.name, body.position_m, {}};
    if (body.rotation.size() > 0) {
      // The turn about the plane's normal, whatever the body's own tilt.
      series.heading_rad = 2.0 * (plane.up_sign * body.rotation.col(plane.up).array())
                                     .binaryExpr(body.rotation.col(3).array(), angle);
    }
    return series;
  }
  if (!point.marker.empty()) {
    const MotiveObject& marker = finder.marker(point.marker);
    return {marker.name, marker.position_m, {}};
  }
  const MotiveObject& right = finder.marker(point.right);
  const MotiveObject& left = finder.marker(point.left);
  const Eigen::MatrixXd across = left.position_m - right.position_m;
  PointSeries series{
      right.name + " and " + left.name, 0.5 * (left.position_m + right.position_m), {}};
  series.heading_rad = (plane.left_sign * across.col(plane.left).array())
                           .binaryExpr(across.col(plane.forward).array(), angle) -
                       0.5 * M_PI;
  return series;
}

}  // namespace

Eigen::MatrixXd unit_quaternions(const std::string& file, const std::string& object,
                                 const std::vector<double>& time_s, Eigen::MatrixXd rotation) {
  for (Eigen::Index t = 0; t < rotation.rows(); ++t) {
    const double length = rotation.row(t).norm();
    if (!std::isnan(length) && std::abs(length - 1.0) > kUnitMiss) {  // NaN: not seen
      throw InputError(
          fmt::format("{}: the rotation of '{}' at {} s is ({}, {}, {}, {}), of length {:.4g}; "
                      "expected a unit quaternion X, Y, Z, W",
                      file, object, time_s[std::size_t(t)], rotation(t, 0), rotation(t, 1),
                      rotation(t, 2), rotation(t, 3), length));
    }
    rotation.row(t) /= length;
  }
  return rotation;
}

bool is_euler_order(const std::string& order) {
  std::string axes = order;
  std::sort(axes.begin(), axes.end());
  return axes == "XYZ";
}

Eigen::Vector4d quaternion_of_euler(const Eigen::Vector3d& angles_rad, const std::string& order) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (const char axis : order) {
    const int i = axis - 'X';
    rotation = rotation * Eigen::AngleAxisd(angles_rad[i], Eigen::Vector3d::Unit(i));
  }
  return rotation.coeffs();  // x, y, z, w
}

Eigen::MatrixXd quaternions_of_euler(const Eigen::MatrixXd& angles_deg, const std::string& order) {
  Eigen::MatrixXd rotation(angles_deg.rows(), 4);
  for (Eigen::Index t = 0; t < angles_deg.rows(); ++t) {
    rotation.row(t) = quaternion_of_euler(angles_deg.row(t).transpose() * kRadPerDeg, order);
  }
  return rotation;
}

template <class Kind>
const MotiveObject* PlateFinder::find(const std::string& name, Kind is_kind) const {
  const MotiveObject* found = nullptr;
  for (const MotiveObject& object : take_.objects) {
    if (!is_kind(object)) {
      continue;
    }
    if (object.name == name) {
      return &object;
    }
    // "Asset:Marker1" may be called "Marker1" where that is unambiguous.
    const std::size_t colon = object.name.rfind(':');
    if (colon != std::string::npos && object.name.substr(colon + 1) == name) {
      if (found != nullptr) {
        throw InputError(fmt::format("{}: '{}' could be '{}' or '{}'; give the whole name", log_,
                                     name, found->name, object.name));
      }
      found = &object;
    }
  }
  return found;
}

template <class Kind>
void PlateFinder::refuse_missing(const char* what, const std::string& name, Kind is_kind) const {
  std::vector<std::string> names;
  for (const MotiveObject& object : take_.objects) {
    if (is_kind(object)) {
      names.push_back(object.name);
    }
  }
  throw InputError(
      fmt::format("{}: there is no {} '{}'; the file has: {}", log_, what, name,
                  names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, ", "))));
}

std::vector<PointSource> PlateFinder::default_points(const ArmDescription& arm) const {
  for (const bool bodies : {true, false}) {
    std::vector<std::string> names;
    for (const MotiveObject& object : take_.objects) {
      if (bodies ? is_body(object) : is_measured_marker(object)) {
        names.push_back(object.name);
      }
    }
    if (names.empty()) {
      continue;
    }
    if (std::ssize(names) != arm.point_count()) {
      throw InputError(fmt::format(
          "{}: {} {} found ({}); arm '{}' has {} plates. Say in a mapping (--mapping) which is "
          "which: 'backbone: {{points: [{{plate: 0, {}: NAME}}, …]}}'",
          log_, names.size(), bodies ? "rigid bodies" : "markers", fmt::join(names, ", "), arm.name,
          arm.point_count(), bodies ? "body" : "marker"));
    }
    std::sort(names.begin(), names.end(), natural_less);
    std::vector<PointSource> points(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      points[i].plate = int(i);
      (bodies ? points[i].body : points[i].marker) = names[i];
    }
    report_.note("no mapping of plates: taken in the order of their names",
                 fmt::format("base '{}', end '{}'", names.front(), names.back()),
                 std::ssize(names));
    return points;
  }
  throw InputError(fmt::format("{}: no rigid bodies and no measured markers in it", log_));
}

const MotiveObject& PlateFinder::body(const std::string& name) const {
  const MotiveObject* found = find(name, is_body);
  if (found == nullptr) {
    refuse_missing("rigid body", name, is_body);
  }
  return *found;
}

const MotiveObject& PlateFinder::marker(const std::string& name) const {
  if (const MotiveObject* found = find(name, is_measured_marker)) {
    return *found;
  }
  const MotiveObject* solved = find(name, is_solved_marker);
  if (solved == nullptr) {
    refuse_missing("marker", name, [](const MotiveObject& o) { return !is_body(o); });
  }
  report_.note(
      "markers whose measured positions are not in the file: solved ones used, which go "
      "on while a marker is hidden",
      fmt::format("'{}'", name));
  return *solved;
}

PointTracks motive_points(const std::string& log, const MotiveTake& take,
                          const ImportMapping& mapping, const ArmDescription& arm,
                          RunReport& report) {
  const PlateFinder finder(log, take, report);
  const std::vector<PointSource> points = finder.points(mapping, arm);
  const Plane plane = plane_of(mapping.up);
  const auto rows = Eigen::Index(take.time_s.size());
  const auto k = Eigen::Index(points.size());
  PointTracks tracks;
  tracks.time_s = take.time_s;
  tracks.x_m.resize(rows, k);
  tracks.y_m.resize(rows, k);
  tracks.theta_rad.resize(rows, k);
  std::vector<Eigen::MatrixXd> positions;
  Eigen::Index with_heading = 0;
  for (Eigen::Index i = 0; i < k; ++i) {
    const PointSource& point = points[std::size_t(i)];
    if (!point.x.empty()) {
      throw InputError(
          fmt::format("{}: the mapping names column '{}' for {}; of a Motive file "
                      "expected body, marker, or right and left",
                      log, point.x, plate_name(point.plate)));
    }
    PointSeries series = series_of(point, finder, plane);
    tracks.names.push_back(series.name);
    tracks.plates.push_back(point.plate);
    tracks.x_m.col(i) = series.position_m.col(plane.forward);
    tracks.y_m.col(i) = plane.left_sign * series.position_m.col(plane.left);
    if (series.heading_rad.size() > 0) {
      tracks.theta_rad.col(i) = series.heading_rad;
      ++with_heading;
    }
    positions.push_back(std::move(series.position_m));
  }
  if (with_heading < k) {
    tracks.theta_rad.resize(0, 0);
    if (with_heading > 0) {
      report.note("some points have a heading and some have none: all headings are the tangent's");
    }
  }
  require_plane(log, positions, mapping, report);
  return tracks;
}

SpaceTracks space_motive_tracks(const std::string& log, const MotiveTake& take,
                                const ImportMapping& mapping, const ArmDescription& arm,
                                RunReport& report) {
  const PlateFinder finder(log, take, report);
  const std::vector<PointSource> points = finder.points(mapping, arm);
  const auto rows = Eigen::Index(take.time_s.size());
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
