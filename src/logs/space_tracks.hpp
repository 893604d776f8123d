#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/space_pose.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"

namespace limber {

/// Where a log saw points of an arm in space, on the log's own clock. T rows, k points. Metres and
/// unit quaternions in the log's frame; NaN where a point was not tracked.
struct SpaceTracks {
  std::vector<std::string> names;  ///< k, base first; what messages call them
  std::vector<int> plates;         ///< k, rising
  std::vector<double> time_s;      ///< T
  Eigen::MatrixXd poses;           ///< T×7k; a point without rotations has those of no turn
  std::vector<bool> has_rotation;  ///< k

  Eigen::Index point_count() const { return Eigen::Index(plates.size()); }
  Eigen::Index row_count() const { return Eigen::Index(time_s.size()); }
  /// Of all plates but the base, and so of the tip.
  bool has_rotations() const { return has_rotation.back(); }
  bool tracks_base() const { return plates.front() == 0; }

  Eigen::Vector3d position_m(Eigen::Index t, Eigen::Index i) const {
    return poses.block<1, 3>(t, kSpacePoseSize * i).transpose();
  }
  Eigen::Quaterniond rotation(Eigen::Index t, Eigen::Index i) const {
    return Eigen::Quaterniond(poses.block<1, 4>(t, kSpacePoseSize * i + 3).transpose());
  }
  SpacePose pose(Eigen::Index t, Eigen::Index i) const {
    return {position_m(t, i), rotation(t, i)};
  }
  void put(Eigen::Index t, Eigen::Index i, const SpacePose& pose) {
    poses.block<1, kSpacePoseSize>(t, kSpacePoseSize * i) = numbers_of(pose).transpose();
  }
  void hide(Eigen::Index t, Eigen::Index i);
  bool is_tracked(Eigen::Index t, Eigen::Index i) const {
    return poses.block<1, kSpacePoseSize>(t, kSpacePoseSize * i).allFinite();
  }
};

void keep_rows(SpaceTracks& tracks, const std::vector<std::size_t>& order);

/// The columns of all points, in the order that `space_tracks_of` reads them.
/// @throws InputError where the mapping names no columns; `log` stands for the file
void want_space_points(const std::string& log, const ImportMapping& mapping, WantedColumns& wanted);

/// What a table holds of the points, its times and point columns first. Where a quaternion's length
/// is not about 1 its point is hidden, and noted.
/// @throws InputError naming the first line where that are too many (are_too_many).
SpaceTracks space_tracks_of(const LogTable& table, const RowGroup& group,
                            const ImportMapping& mapping, RunReport& report);

/// Rows that show the pose of the row before again, less than half the median period later, are
/// no measurements of their own: left out. @return how many
std::int64_t drop_repeated_poses(SpaceTracks& tracks);

/// Makes of a column of quaternions (T×4) one without jumps of sign.
void make_signs_continuous(Eigen::Ref<Eigen::MatrixXd> quaternions);

/// The rotation of Euler angles in radians. @pre angles has as many as the order
Eigen::Quaterniond rotation_of_euler(const std::string& order, const Eigen::Vector3d& angles_rad);

}  // namespace limber
