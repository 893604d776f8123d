#include "rotation_flips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "longest_gap.hpp"

namespace limber {

namespace {

/// What is a jump, and from where on it is turned back if it lasts.
struct JumpSizes {
  double least_rad;
  double flip_rad;
};
// A tracker's noise is less than 6 degrees; markers that look alike are farther apart than 30.
constexpr JumpSizes kInSpace = {6.0 * kRadPerDeg, 30.0 * kRadPerDeg};
constexpr JumpSizes kInPlane = {1.0, 1.0};  // pairs of markers give noisier headings than bodies
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
  BodyRotations(double length_m, double longest_gap_s, const JumpSizes& sizes, Eigen::Index point,
                SpaceTracks& tracks)
      : length_m_(length_m),
        longest_gap_s_(longest_gap_s),
        sizes_(sizes),
        point_(point),
        tracks_(tracks) {
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
      if (jumps(j - 1, sizes_.least_rad) && jumps(j, sizes_.least_rad) &&
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
      const Eigen::Quaterniond before = rotation(j - 1) * backs[of_row[j - 1]];
      of_row[j] = of_row[j - 1];
      if (!stays_[j - 1]) {  // nothing was compared: what turns the body least
        const auto turn_rad = [&](const Eigen::Quaterniond& back) {
          return angle_between(before, rotation(j) * back);
        };
        of_row[j] = std::size_t(std::ranges::min_element(backs, {}, turn_rad) - backs.begin());
      } else if (jumps(j - 1, sizes_.flip_rad)) {
        // R_after back = R_before back_before: the body goes on as it was.
        of_row[j] = like(rotation(j).conjugate() * before, backs);
        flips_.largest_rad = std::max(flips_.largest_rad, turn_rad_[j - 1]);
      } else if (jumps(j - 1, sizes_.least_rad)) {
        note(j);
        ++flips_.jumps;
      }
    }
    std::vector<std::int64_t> count(backs.size(), 0);
    for (const std::size_t m : of_row) {
      ++count[m];
    }
    const auto usual = std::size_t(std::ranges::max_element(count) - count.begin());
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
    flips_.kinds = std::int64_t(backs.size()) - 1;
  }

  double length_m_;
  double longest_gap_s_;
  JumpSizes sizes_;
  Eigen::Index point_;
  SpaceTracks& tracks_;
  SpaceFlips flips_;
  std::vector<Eigen::Index> rows_;   // those in which it was tracked
  std::vector<double> turn_rad_;     // from each to the next
  std::vector<double> allowed_rad_;  // as the quiet ones around it are
  std::vector<bool> stays_;          // whether its place says that it is the same body
};

std::vector<SpaceFlips> settle(double length_m, const LongestGap& longest_gap,
                               const JumpSizes& sizes, SpaceTracks& tracks) {
  const double longest_gap_s = longest_gap_in_s(longest_gap, tracks.time_s);
  std::vector<SpaceFlips> found;
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    if (!tracks.has_rotation[std::size_t(i)]) {
      continue;
    }
    const SpaceFlips flips = BodyRotations(length_m, longest_gap_s, sizes, i, tracks).settle();
    if (flips.hidden_rows + flips.turned_rows + flips.jumps > 0) {
      found.push_back(flips);
    }
  }
  return found;
}

/// The same points in space, in the plane z = 0.
SpaceTracks in_space(const PointTracks& tracks) {
  SpaceTracks space;
  space.names = tracks.names;
  space.plates = tracks.plates;
  space.time_s = tracks.time_s;
  space.has_rotation.assign(tracks.plates.size(), true);
  space.poses.resize(tracks.row_count(), kSpacePoseSize * tracks.point_count());
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
      if (tracks.is_tracked(t, i)) {
        space.put(t, i,
                  {{tracks.x_m(t, i), tracks.y_m(t, i), 0.0},
                   rotation_of_vector<double>(Eigen::Vector3d(0.0, 0.0, tracks.theta_rad(t, i)))});
      } else {
        space.hide(t, i);
      }
    }
  }
  return space;
}

}  // namespace

std::vector<SpaceFlips> settle_rotations(double length_m, const LongestGap& longest_gap,
                                         SpaceTracks& tracks) {
  return settle(length_m, longest_gap, kInSpace, tracks);
}

void settle_headings(double length_m, const LongestGap& longest_gap, PointTracks& tracks,
                     RunReport& report) {
  constexpr double kTurned_rad = 1e-6;  // less is rounding
  SpaceTracks space = in_space(tracks);
  for (const SpaceFlips& flips : settle(length_m, longest_gap, kInPlane, space)) {
    report.note(
        "headings that jump while their place does not: hidden in single rows, else turned back to "
        "what most rows show",
        fmt::format("'{}' ({}) by up to {:.0f} degrees at {:.3f} s", flips.point,
                    plate_name(flips.plate), kDegPerRad * flips.largest_rad, flips.first_s),
        flips.hidden_rows + flips.turned_rows);
  }
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
      double& theta_rad = tracks.theta_rad(t, i);
      if (tracks.is_tracked(t, i) && !space.is_tracked(t, i)) {
        theta_rad = std::numeric_limits<double>::quiet_NaN();
      } else if (tracks.is_tracked(t, i)) {
        const double settled_rad = rotation_vector(space.rotation(t, i)).z();
        const double off_rad = std::remainder(settled_rad - theta_rad, 2.0 * M_PI);
        theta_rad += std::abs(off_rad) > kTurned_rad ? off_rad : 0.0;
      }
    }
  }
}

}  // namespace limber
