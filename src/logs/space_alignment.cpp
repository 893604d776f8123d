#include "space_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/log_units.hpp"
#include "space_mapping.hpp"

namespace limber {

namespace {

constexpr double kMostRows = 0.95;
// Of the arm's x along the log's own, above which y is made of another axis: arms that hang or lie,
// or stand at 30 or 45 degrees, are far from it, so that noise never turns the frame of a log.
constexpr double kAlongLogsX = 0.8;
constexpr std::size_t kRotationSample = 101;  // rotations compared with all others of the sample
constexpr double kNearRotation_rad = 0.25;

/// Rows in which a point was tracked, of those from and to these times.
/// @throws InputError where there is none
std::vector<Eigen::Index> required_rows(const std::string& log, const SpaceTracks& tracks,
                                        Eigen::Index point,
                                        const std::optional<Eigen::Vector2d>& times_s = {}) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    const double time_s = tracks.time_s[std::size_t(t)];
    const bool within = !times_s || (time_s >= times_s->x() && time_s <= times_s->y());
    if (within && tracks.is_tracked(t, point)) {
      rows.push_back(t);
    }
  }
  if (rows.empty()) {
    throw InputError(fmt::format(
        "{}: point '{}' ({}) is not tracked in any row{}; the log reaches from {:.6g} s to {:.6g} "
        "s",
        log, tracks.names[std::size_t(point)], plate_name(tracks.plates[std::size_t(point)]),
        times_s ? fmt::format(" from {:.6g} s to {:.6g} s (rest_s)", times_s->x(), times_s->y())
                : "",
        tracks.time_s.front(), tracks.time_s.back()));
  }
  return rows;
}

Eigen::Vector3d median_position_m(const SpaceTracks& tracks, Eigen::Index point,
                                  const std::vector<Eigen::Index>& rows) {
  Eigen::Vector3d result;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    auto values = mapped<double>(
        rows, [&](const Eigen::Index t) { return tracks.position_m(t, point)[axis]; });
    result[axis] = median(std::move(values));
  }
  return result;
}

/// The mean of rotations near the one from which most are least far: those that are far off, the
/// fewer ones, do not count. @pre at least one row
Eigen::Quaterniond mean_rotation(const SpaceTracks& tracks, Eigen::Index point,
                                 const std::vector<Eigen::Index>& rows) {
  auto rotations = mapped<Eigen::Quaterniond>(
      rows, [&](const Eigen::Index t) { return tracks.rotation(t, point); });
  std::vector<Eigen::Quaterniond> sample;
  const std::size_t step = 1 + rotations.size() / kRotationSample;
  for (std::size_t i = 0; i < rotations.size(); i += step) {
    sample.push_back(rotations[i]);
  }
  Eigen::Quaterniond middle = sample.front();
  double least = std::numeric_limits<double>::max();
  for (const Eigen::Quaterniond& candidate : sample) {
    const auto sum = sum_of<double>(
        sample, [&](const Eigen::Quaterniond& other) { return candidate.angularDistance(other); });
    if (sum < least) {
      least = sum;
      middle = candidate;
    }
  }
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  for (const Eigen::Quaterniond& rotation : rotations) {
    if (middle.angularDistance(rotation) < kNearRotation_rad) {
      mean += rotation.coeffs() * (rotation.dot(middle) < 0.0 ? -1.0 : 1.0);
    }
  }
  return Eigen::Quaterniond(mean).normalized();
}

/// Axes of frame B as columns.
Eigen::Quaterniond rotation_of_axes(const std::string& log, const Eigen::Vector3d& along,
                                    const std::optional<Eigen::Vector3d>& left) {
  const Eigen::Vector3d x = along.normalized();
  Eigen::Vector3d y;
  if (left) {
    if (x.cross(*left).norm() < kParallelAxes) {
      throw InputError(fmt::format(
          "{}: y_axis lies along the arm at rest, ({:.4f}, {:.4f}, {:.4f}) in the log's frame; "
          "expected a direction to the left of it",
          log, x.x(), x.y(), x.z()));
    }
    y = *left;
  } else {
    y = Eigen::Vector3d::Unit(std::abs(x.x()) < kAlongLogsX ? 0 : 1);
  }
  y = (y - x * x.dot(y)).normalized();
  Eigen::Matrix3d axes;
  axes << x, y, x.cross(y);
  return Eigen::Quaterniond(axes);
}

/// Frame B of an arm in space in the log's frame, and what bodies' axes have to do with it.
struct SpaceFrame {
  SpacePose X_LB;
  std::vector<Eigen::Quaterniond> body_to_plate;  ///< k; a plate's axes in its body's
};

SpaceFrame find_frame(const std::string& log, const SpaceAlignment& alignment,
                      const SpaceTracks& tracks) {
  SpaceFrame frame;
  frame.body_to_plate.assign(std::size_t(tracks.point_count()), Eigen::Quaterniond::Identity());
  if (alignment.kind == SpaceAlignment::Kind::none) {
    return frame;
  }
  frame.X_LB.position_m = alignment.position_m
                              ? *alignment.position_m
                              : median_position_m(tracks, 0, required_rows(log, tracks, 0));
  if (alignment.kind == SpaceAlignment::Kind::base) {
    refuse_if(!tracks.tracks_base() || !tracks.has_rotation.front(),
              "{}: plate 0, the base, has no rotation; expected where the arm points, as in "
              "'alignment: {{x_axis: [x, y, z]}}' or '{{rest_s: [from, to]}}'",
              log);
    frame.X_LB.rotation = mean_rotation(tracks, 0, required_rows(log, tracks, 0));
    return frame;
  }
  const auto rest_rows = [&](Eigen::Index i) {
    return required_rows(log, tracks, i, alignment.rest_s);
  };
  const Eigen::Index tip = tracks.point_count() - 1;
  const Eigen::Vector3d along =
      alignment.x_axis
          ? *alignment.x_axis
          : Eigen::Vector3d(median_position_m(tracks, tip, rest_rows(tip)) - frame.X_LB.position_m);
  frame.X_LB.rotation = rotation_of_axes(log, along, alignment.y_axis);
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    if (tracks.has_rotation[std::size_t(i)]) {
      // What a body's rotation is when its plate lies along the base.
      const Eigen::Quaterniond zero = alignment.rest_s ? mean_rotation(tracks, i, rest_rows(i))
                                                       : Eigen::Quaterniond::Identity();
      frame.body_to_plate[std::size_t(i)] = zero.conjugate() * frame.X_LB.rotation;
    }
  }
  return frame;
}

/// @return 95 % of the distances of a tracked base from its median place
/// @throws InputError where it was never tracked
double base_scatter_m(const std::string& log, const SpaceTracks& tracks) {
  const std::vector<Eigen::Index> rows = required_rows(log, tracks, 0);
  const Eigen::Vector3d middle = median_position_m(tracks, 0, rows);
  auto off_m = mapped<double>(
      rows, [&](const Eigen::Index t) { return (tracks.position_m(t, 0) - middle).norm(); });
  return quantile(std::move(off_m), kMostRows);
}

/// A point without a rotation has none in frame B either.
void move_into(const SpaceFrame& frame, SpaceTracks& tracks) {
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
      SpacePose pose = between(frame.X_LB, tracks.pose(t, i));
      pose.rotation = tracks.has_rotation[std::size_t(i)]
                          ? pose.rotation * frame.body_to_plate[std::size_t(i)]
                          : Eigen::Quaterniond::Identity();
      if (tracks.is_tracked(t, i)) {
        tracks.put(t, i, pose);
      }
    }
  }
}

/// A base that stands still is at the origin, unless the log is in the arm's frame already.
void settle_base(const std::string& log, const SpaceAlignment& alignment, SpaceTracks& tracks,
                 RunReport& report) {
  report.space->base_tracked = tracks.tracks_base();
  if (!tracks.tracks_base()) {
    return;
  }
  report.space->base_scatter_m = base_scatter_m(log, tracks);
  if (report.space->base_scatter_m >= kBaseStandsStill_m) {
    report.note("the base moves: it is left where it was tracked",
                fmt::format("95 % within {:.1f} mm of its median place",
                            1e3 * report.space->base_scatter_m));
    return;
  }
  if (alignment.kind == SpaceAlignment::Kind::none) {
    return;
  }
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    tracks.put(t, 0, {});
  }
}

}  // namespace

SpacePose frame_in_log(const std::string& log, const SpaceAlignment& alignment,
                       const SpaceTracks& tracks) {
  return find_frame(log, alignment, tracks).X_LB;
}

void align_in_space(const std::string& log, const SpaceAlignment& alignment, SpaceTracks& tracks,
                    RunReport& report) {
  const SpaceFrame frame = find_frame(log, alignment, tracks);
  const Eigen::Matrix3d axes = frame.X_LB.rotation.toRotationMatrix();
  report.space->base_m = frame.X_LB.position_m;
  report.space->x_axis = axes.col(0);
  report.space->y_axis = axes.col(1);
  report.space->y_chosen =
      alignment.kind == SpaceAlignment::Kind::given && !alignment.y_axis.has_value();
  move_into(frame, tracks);
  settle_base(log, alignment, tracks, report);
}

}  // namespace limber
