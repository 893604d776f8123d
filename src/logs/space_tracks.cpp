#include "space_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/median_rate.hpp"

namespace limber {

namespace {

constexpr double kUnitLength = 0.05;     // by which a quaternion's length may miss 1
constexpr double kRepeatedWithin = 0.5;  // of the median period
constexpr Eigen::Index kEuler = 3;

/// A body's rotation, from 4 or 3 numbers of a table's row; none where a quaternion's length is not
/// about 1.
std::optional<Eigen::Quaterniond> rotation_in(const EulerAngles& euler,
                                              const Eigen::VectorXd& numbers) {
  if (numbers.size() == kEuler) {
    return rotation_of_euler(euler.order, euler.factor * numbers);
  }
  const Eigen::Quaterniond rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
  if (std::abs(rotation.norm() - 1.0) > kUnitLength) {
    return std::nullopt;
  }
  return rotation.normalized();
}

/// One body's quaternions that are none.
struct BadQuaternions {
  std::size_t count = 0;
  std::size_t first_line = 0;
  double first_length = 0.0;
};

/// Notes them, hidden. @throws InputError where they are many
void note_bad_quaternions(const LogTable& table, std::size_t rows, const PointSource& point,
                          const BadQuaternions& bad, RunReport& report) {
  if (bad.count == 0) {
    return;
  }
  if (are_too_many(bad.count, rows)) {
    throw InputError(fmt::format(
        "{}: {} of {} quaternions of {} don't have the length 1; the first, in line {}, has "
        "{:.4g}. Are the columns '{}' … '{}' in the order qx, qy, qz, qw? Leave cells empty where "
        "it was not tracked",
        table.file, bad.count, rows, plate_name(point.plate), bad.first_line, bad.first_length,
        point.rotation.front(), point.rotation.back()));
  }
  report.note(
      "quaternions that don't have the length 1: not tracked",
      fmt::format("line {}, {}: {:.4g}", bad.first_line, plate_name(point.plate), bad.first_length),
      std::int64_t(bad.count));
}

}  // namespace

void SpaceTracks::hide(Eigen::Index t, Eigen::Index i) {
  poses.block<1, kSpacePoseSize>(t, kSpacePoseSize * i)
      .setConstant(std::numeric_limits<double>::quiet_NaN());
}

void keep_rows(SpaceTracks& tracks, const std::vector<std::size_t>& order) {
  keep_rows(tracks.poses, order);
  keep_rows(tracks.time_s, order);
}

void want_space_points(const std::string& log, const ImportMapping& mapping,
                       WantedColumns& wanted) {
  refuse_if(
      mapping.points.empty(),
      "{}: the mapping names no points; expected 'backbone: {{points: [{{x: COLUMN, y: COLUMN, "
      "z: COLUMN}}, …]}}', base first, with qx, qy, qz, qw or euler where they were logged",
      log);
  for (const PointSource& point : mapping.points) {
    if (point.x.empty()) {
      throw InputError(fmt::format(
          "{}: {} is mapped to an object of a Motive file; expected the columns x, y and z", log,
          plate_name(point.plate)));
    }
    wanted.names.insert(wanted.names.end(), {point.x, point.y, point.z});
    wanted.names.insert(wanted.names.end(), point.rotation.begin(), point.rotation.end());
  }
}

SpaceTracks space_tracks_of(const LogTable& table, const RowGroup& group,
                            const ImportMapping& mapping, RunReport& report) {
  SpaceTracks tracks;
  const auto rows = Eigen::Index(group.rows.size());
  tracks.poses.resize(rows, kSpacePoseSize * Eigen::Index(mapping.points.size()));
  tracks.time_s = picked(table.columns[0], group.rows, mapping.time.seconds_per_unit);
  std::size_t column = 1;
  for (Eigen::Index i = 0; i < std::ssize(mapping.points); ++i) {
    const PointSource& point = mapping.points[std::size_t(i)];
    const auto turns = Eigen::Index(point.rotation.size());
    tracks.names.push_back(point.x);
    tracks.plates.push_back(point.plate);
    tracks.has_rotation.push_back(turns > 0);
    Eigen::VectorXd numbers(3 + turns);
    const std::vector<bool> zeros =
        rows_of_zeros(table, group, column, std::size_t(numbers.size()), point, mapping, report);
    BadQuaternions bad;
    for (Eigen::Index t = 0; t < rows; ++t) {
      const std::size_t row = group.rows[std::size_t(t)];
      for (Eigen::Index c = 0; c < numbers.size(); ++c) {
        numbers[c] = table.columns[column + std::size_t(c)][row];
      }
      if (zeros[std::size_t(t)] || !numbers.allFinite()) {
        tracks.hide(t, i);
        continue;
      }
      const std::optional<Eigen::Quaterniond> rotation =
          turns > 0 ? rotation_in(mapping.euler, numbers.tail(turns))
                    : Eigen::Quaterniond::Identity();
      if (rotation) {
        tracks.put(t, i, {mapping.length_factor * numbers.head<3>(), *rotation});
        continue;
      }
      tracks.hide(t, i);
      if (bad.count++ == 0) {
        bad.first_line = table.lines[row];
        bad.first_length = numbers.tail<4>().norm();
      }
    }
    note_bad_quaternions(table, group.rows.size(), point, bad, report);
    column += std::size_t(numbers.size());
  }
  return tracks;
}

std::int64_t drop_repeated_poses(SpaceTracks& tracks) {
  const double shortest_s = kRepeatedWithin / median_rate_hz(tracks.time_s);
  std::vector<std::size_t> kept = {0};
  for (Eigen::Index t = 1; t < tracks.row_count(); ++t) {
    const std::size_t before = kept.back();
    const bool soon = tracks.time_s[std::size_t(t)] - tracks.time_s[before] < shortest_s;
    if (!soon || tracks.poses.row(t) != tracks.poses.row(Eigen::Index(before))) {
      kept.push_back(std::size_t(t));
    }
  }
  const auto dropped = std::int64_t(tracks.time_s.size() - kept.size());
  if (dropped > 0) {
    keep_rows(tracks, kept);
  }
  return dropped;
}

void make_signs_continuous(Eigen::Ref<Eigen::MatrixXd> quaternions) {
  Eigen::RowVectorXd before = Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
  for (Eigen::Index t = 0; t < quaternions.rows(); ++t) {
    if (!quaternions.row(t).allFinite()) {
      continue;
    }
    if (quaternions.row(t).dot(before) < 0.0) {
      quaternions.row(t) *= -1.0;
    }
    before = quaternions.row(t);
  }
}

Eigen::Quaterniond rotation_of_euler(const std::string& order, const Eigen::Vector3d& angles_rad) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (std::size_t turn = 0; turn < order.size(); ++turn) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(order[turn] - 'x');
    rotation = rotation * rotation_of_vector<double>(angles_rad[Eigen::Index(turn)] * axis);
  }
  return rotation;
}

}  // namespace limber
