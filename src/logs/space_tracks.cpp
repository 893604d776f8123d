#include "space_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/median_rate.hpp"

namespace limber {

namespace {

constexpr double kUnitLength = 0.05;     // by which a quaternion's length may miss 1
constexpr double kRepeatedWithin = 0.5;  // of the median period
constexpr Eigen::Index kEuler = 3;

/// A body's rotation, from 4 or 3 numbers of a table's row.
Eigen::Quaterniond rotation_in(const LogTable& table, std::size_t row, const PointSource& point,
                               const EulerAngles& euler, const Eigen::VectorXd& numbers) {
  if (numbers.size() == kEuler) {
    return rotation_of_euler(euler.order, euler.factor * numbers);
  }
  const Eigen::Quaterniond rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
  if (std::abs(rotation.norm() - 1.0) > kUnitLength) {
    throw InputError(fmt::format(
        "{}: line {}: the quaternion of {} has the length {:.4g}; expected 1. Are its columns "
        "'{}' … '{}' in the order qx, qy, qz, qw? Leave its cells empty where it was not tracked",
        table.file, table.lines[row], plate_name(point.plate), rotation.norm(),
        point.rotation.front(), point.rotation.back()));
  }
  return rotation.normalized();
}

constexpr double kJump_rad = 6.0 * kRadPerDeg;   // a tracker's noise is less
constexpr double kFlip_rad = 30.0 * kRadPerDeg;  // markers that look alike are farther apart
constexpr double kSameFlip_rad = 15.0 * kRadPerDeg;
constexpr double kQuietShare = 0.25;  // of the steps around: flips themselves are fewer than that
constexpr double kOverQuiet = 8.0;    // steps beyond so many quiet ones are no motion
constexpr double kPlaceJump = 0.05;   // of the arm's length: something else was tracked there
constexpr double kReturned = 0.5;     // of a jump: how far off the row after it may be
constexpr std::ptrdiff_t kNeighbours = 10;  // steps before and after

double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return rotation_vector<double>(a.conjugate() * b).norm();
}

/// The quiet step around each of them.
std::vector<double> quiet_steps(const std::vector<double>& steps) {
  std::vector<double> quiet;
  for (std::ptrdiff_t j = 0; j < std::ssize(steps); ++j) {
    const auto begin = steps.begin() + std::max<std::ptrdiff_t>(0, j - kNeighbours);
    const auto end = steps.begin() + std::min(std::ssize(steps), j + kNeighbours + 1);
    quiet.push_back(quantile(std::vector<double>(begin, end), kQuietShare));
  }
  return quiet;
}

/// One body over time.
class BodyRotations {
 public:
  BodyRotations(double length_m, double longest_gap_s, Eigen::Index point, SpaceTracks& tracks)
      : length_m_(length_m), longest_gap_s_(longest_gap_s), point_(point), tracks_(tracks) {
    flips_.point = tracks.names[std::size_t(point)];
    flips_.plate = tracks.plates[std::size_t(point)];
  }

  SpaceFlips settle() {
    find_steps();
    if (flips_.plate != 0) {
      hide_single_rows();
      find_steps();
    }
    turn_back();
    return flips_;
  }

 private:
  void find_steps() {
    rows_.clear();
    turn_rad_.clear();
    std::vector<double> way_m;
    for (Eigen::Index t = 0; t < tracks_.row_count(); ++t) {
      if (!tracks_.is_tracked(t, point_)) {
        continue;
      }
      if (!rows_.empty()) {
        const Eigen::Index before = rows_.back();
        turn_rad_.push_back(
            angle_between(tracks_.rotation(before, point_), tracks_.rotation(t, point_)));
        way_m.push_back(
            (tracks_.position_m(t, point_) - tracks_.position_m(before, point_)).norm());
      }
      rows_.push_back(t);
    }
    allowed_rad_ = quiet_steps(turn_rad_);
    const std::vector<double> quiet_m = quiet_steps(way_m);
    stays_.clear();
    for (std::size_t j = 0; j < turn_rad_.size(); ++j) {
      allowed_rad_[j] *= kOverQuiet;
      const double silence_s = time_s(j + 1) - time_s(j);
      stays_.push_back(way_m[j] < kPlaceJump * length_m_ + kOverQuiet * quiet_m[j] &&
                       silence_s <= longest_gap_s_);
    }
  }

  double time_s(std::size_t j) const { return tracks_.time_s[std::size_t(rows_[j])]; }
  Eigen::Quaterniond rotation(std::size_t j) const { return tracks_.rotation(rows_[j], point_); }
  /// Between rows j and j + 1, by more than `least_rad` beyond what is quiet there.
  bool jumps(std::size_t j, double least_rad) const {
    return stays_[j] && turn_rad_[j] > least_rad + allowed_rad_[j];
  }

  void note(std::size_t j) {
    const bool first = flips_.hidden_rows + flips_.turned_rows + flips_.jumps == 0;
    flips_.first_s = first ? time_s(j) : std::min(flips_.first_s, time_s(j));
    if (j > 0) {
      flips_.largest_rad = std::max(flips_.largest_rad, turn_rad_[j - 1]);
    }
  }

  void hide_single_rows() {
    for (std::size_t j = 1; j + 1 < rows_.size(); ++j) {
      const double smaller_rad = std::min(turn_rad_[j - 1], turn_rad_[j]);
      if (jumps(j - 1, kJump_rad) && jumps(j, kJump_rad) &&
          angle_between(rotation(j - 1), rotation(j + 1)) < kReturned * smaller_rad) {
        note(j);
        ++flips_.hidden_rows;
        tracks_.hide(rows_[j], point_);
        ++j;  // the row after it is a good one
      }
    }
  }

  /// What turns rows after a jump back, one of `backs`; a new one joins them.
  static std::size_t like(const Eigen::Quaterniond& back, std::vector<Eigen::Quaterniond>& backs) {
    for (std::size_t m = 0; m < backs.size(); ++m) {
      if (angle_between(backs[m], back) < kSameFlip_rad) {
        return m;
      }
    }
    backs.push_back(back);
    return backs.size() - 1;
  }

  void turn_back() {
    std::vector<Eigen::Quaterniond> backs = {Eigen::Quaterniond::Identity()};
    std::vector<std::size_t> of_row(rows_.size(), 0);
    for (std::size_t j = 1; j < rows_.size(); ++j) {
      of_row[j] = of_row[j - 1];
      if (jumps(j - 1, kFlip_rad)) {
        // R_after back = R_before back_before: the body goes on as it was.
        of_row[j] = like(rotation(j).conjugate() * rotation(j - 1) * backs[of_row[j - 1]], backs);
      } else if (jumps(j - 1, kJump_rad)) {
        note(j);
        ++flips_.jumps;
      }
    }
    std::vector<std::int64_t> count(backs.size(), 0);
    for (const std::size_t m : of_row) {
      ++count[m];
    }
    const auto usual = static_cast<std::size_t>(std::ranges::max_element(count) - count.begin());
    const Eigen::Quaterniond to_usual = backs[usual].conjugate();
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      if (of_row[j] != usual) {
        note(j);
        ++flips_.turned_rows;
        tracks_.put(
            rows_[j], point_,
            {tracks_.position_m(rows_[j], point_), rotation(j) * backs[of_row[j]] * to_usual});
      }
    }
    flips_.kinds = static_cast<std::int64_t>(backs.size()) - 1;
  }

  double length_m_;
  double longest_gap_s_;
  Eigen::Index point_;
  SpaceTracks& tracks_;
  SpaceFlips flips_;
  std::vector<Eigen::Index> rows_;   // those in which it was tracked
  std::vector<double> turn_rad_;     // from each to the next
  std::vector<double> allowed_rad_;  // as the quiet ones around it are
  std::vector<bool> stays_;          // whether its place says that it is the same body
};

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
  if (mapping.points.empty()) {
    throw InputError(fmt::format(
        "{}: the mapping names no points; expected 'backbone: {{points: [{{x: COLUMN, y: COLUMN, "
        "z: COLUMN}}, …]}}', base first, with qx, qy, qz, qw or euler where they were logged",
        log));
  }
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
  const auto rows = static_cast<Eigen::Index>(group.rows.size());
  tracks.poses.resize(rows, kSpacePoseSize * static_cast<Eigen::Index>(mapping.points.size()));
  tracks.time_s = picked(table.columns[0], group.rows, mapping.time.seconds_per_unit);
  std::size_t column = 1;
  for (Eigen::Index i = 0; i < std::ssize(mapping.points); ++i) {
    const PointSource& point = mapping.points[std::size_t(i)];
    const auto turns = static_cast<Eigen::Index>(point.rotation.size());
    tracks.names.push_back(point.x);
    tracks.plates.push_back(point.plate);
    tracks.has_rotation.push_back(turns > 0);
    Eigen::VectorXd numbers(3 + turns);
    const std::vector<bool> zeros = rows_of_zeros(
        table, group, column, static_cast<std::size_t>(numbers.size()), point, mapping, report);
    for (Eigen::Index t = 0; t < rows; ++t) {
      const std::size_t row = group.rows[std::size_t(t)];
      for (Eigen::Index c = 0; c < numbers.size(); ++c) {
        numbers[c] = table.columns[column + std::size_t(c)][row];
      }
      if (zeros[std::size_t(t)] || !numbers.allFinite()) {
        tracks.hide(t, i);
        continue;
      }
      tracks.put(t, i,
                 {mapping.length_factor * numbers.head<3>(),
                  turns > 0 ? rotation_in(table, row, point, mapping.euler, numbers.tail(turns))
                            : Eigen::Quaterniond::Identity()});
    }
    column += static_cast<std::size_t>(numbers.size());
  }
  return tracks;
}

std::int64_t drop_repeated_poses(SpaceTracks& tracks) {
  const double shortest_s = kRepeatedWithin / median_rate_hz(tracks.time_s);
  std::vector<std::size_t> kept = {0};
  for (Eigen::Index t = 1; t < tracks.row_count(); ++t) {
    const std::size_t before = kept.back();
    const bool soon = tracks.time_s[std::size_t(t)] - tracks.time_s[before] < shortest_s;
    if (!soon || tracks.poses.row(t) != tracks.poses.row(static_cast<Eigen::Index>(before))) {
      kept.push_back(static_cast<std::size_t>(t));
    }
  }
  const auto dropped = static_cast<std::int64_t>(tracks.time_s.size() - kept.size());
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
    rotation =
        rotation * rotation_of_vector<double>(angles_rad[static_cast<Eigen::Index>(turn)] * axis);
  }
  return rotation;
}

std::vector<SpaceFlips> settle_rotations(double length_m, double longest_gap_s,
                                         SpaceTracks& tracks) {
  std::vector<SpaceFlips> found;
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    if (!tracks.has_rotation[std::size_t(i)]) {
      continue;
    }
    const SpaceFlips flips = BodyRotations(length_m, longest_gap_s, i, tracks).settle();
    if (flips.hidden_rows + flips.turned_rows + flips.jumps > 0) {
      found.push_back(flips);
    }
  }
  return found;
}

}  // namespace limber
