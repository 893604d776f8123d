#include "base_alignment.hpp"

#include <cmath>
#include <complex>
#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/log_units.hpp"

namespace limber {

namespace {

constexpr double kMostBaseRows = 0.95;
// Noise of one row is in its direction and in its turn, and would bend how they go together; that
// of rows so far apart is not the same. Arms bend on for longer.
constexpr std::size_t kRowsApart = 5;

class BaseFinder {
 public:
  BaseFinder(const std::string& log, const std::vector<bool>& tracked,
             const BaseAlignment& alignment, const ArmDescription& arm, const PointTracks& tracks)
      : log_(log), alignment_(alignment), arm_(arm), tracks_(tracks) {
    for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
      const bool straight = alignment.kind != BaseAlignment::Kind::straight || is_straight_at(t);
      if (tracked[std::size_t(t)] && straight) {
        rows_.push_back(t);
      }
    }
  }

  /// @pre base or straight
  BaseSighting sight() const {
    if (tracks_.plates.front() != 0) {
      refuse("no point is the base, plate 0");
    }
    if (rows_.empty()) {
      refuse(fmt::format("no row from {} s to {} s, the time named straight, has all points",
                         alignment_.straight_from_s, alignment_.straight_to_s));
    }
    BaseSighting sighting;
    sighting.base = {median(tracks_.x_m), median(tracks_.y_m), 0.0};
    if (alignment_.kind == BaseAlignment::Kind::straight) {
      sighting.base.theta_rad = straight_heading();
    } else if (tracks_.has_headings()) {
      sighting.base.theta_rad =
          mean_direction([&](Eigen::Index t) { return tracks_.theta_rad(t, 0); });
    } else {
      see_first_turns(sighting);
    }
    return sighting;
  }

  /// Mean heading that each point shows while the arm lies straight.
  Eigen::VectorXd heading_offsets() const {
    Eigen::VectorXd offsets(tracks_.point_count());
    for (int i = 0; i < tracks_.point_count(); ++i) {
      offsets[i] = mean_direction([&](Eigen::Index t) { return tracks_.theta_rad(t, i); });
    }
    return offsets;
  }

 private:
  bool is_straight_at(Eigen::Index t) const {
    const double time_s = tracks_.time_s[std::size_t(t)];
    return time_s >= alignment_.straight_from_s && time_s <= alignment_.straight_to_s;
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(
        fmt::format("{}: the arm's base can't be found: {}. Say in the mapping "
                    "where it is: 'alignment: {{x_m, y_m, heading_rad}}', or when "
                    "the arm lay straight: 'alignment: {{straight_s: [from, to]}}'",
                    log_, message));
  }

  double median(const Eigen::MatrixXd& matrix) const {
    auto values = mapped<double>(rows_, [&](const Eigen::Index t) { return matrix(t, 0); });
    return limber::median(std::move(values));
  }

  /// That of the sum of unit vectors, whatever the angles' turns. @param angle_rad  in each row
  template <class Angle>
  double mean_direction(const Angle& angle_rad) const {
    std::complex<double> sum;
    for (const Eigen::Index t : rows_) {
      sum += std::polar(1.0, angle_rad(t));
    }
    return std::arg(sum);
  }

  double straight_heading() const {
    return mean_direction(
        [&](Eigen::Index t) { return tracks_.direction_rad(t, 0, tracks_.point_count() - 1); });
  }

  /// The direction to the second point, and how it changes with the turn there.
  void see_first_turns(BaseSighting& sighting) const {
    if (tracks_.point_count() < 3 || tracks_.plates[2] > arm_.segments.front().gaps) {
      refuse(
          "headings were not logged, and fewer than three points lie on the first segment, so "
          "that its tangent at the base is unknown");
    }
    const std::vector<double> rest_m = rest_positions_m(arm_);
    sighting.arc_share =
        rest_m[std::size_t(tracks_.plates[1])] / rest_m[std::size_t(tracks_.plates[2])];
    const auto direction = [&](Eigen::Index t) { return tracks_.direction_rad(t, 0, 1); };
    const auto turn = [&](Eigen::Index t) {
      return std::remainder(tracks_.direction_rad(t, 1, 2) - direction(t), 2.0 * M_PI);
    };
    sighting.base.theta_rad = mean_direction(direction);
    std::vector<double> turns_off;
    std::vector<double> directions_off;
    for (const Eigen::Index t : rows_) {
      sighting.turn_rad += turn(t) / double(rows_.size());
    }
    for (const Eigen::Index t : rows_) {
      turns_off.push_back(turn(t) - sighting.turn_rad);
      directions_off.push_back(std::remainder(direction(t) - sighting.base.theta_rad, 2.0 * M_PI));
    }
    for (std::size_t i = 0; i + kRowsApart < rows_.size(); ++i) {
      const std::size_t k = i + kRowsApart;
      sighting.turn_products += 2.0 * turns_off[i] * turns_off[k];
      sighting.direction_products +=
          directions_off[i] * turns_off[k] + directions_off[k] * turns_off[i];
      sighting.products += 2;
    }
  }

  const std::string& log_;
  const BaseAlignment& alignment_;
  const ArmDescription& arm_;
  const PointTracks& tracks_;
  std::vector<Eigen::Index> rows_;
};

void transform(const Pose& base, PointTracks& tracks) {
  const bool headings = tracks.has_headings();
  for (Eigen::Index i = 0; i < tracks.x_m.size(); ++i) {
    double* const theta_rad = headings ? tracks.theta_rad.data() + i : nullptr;
    const Pose seen{tracks.x_m.data()[i], tracks.y_m.data()[i], headings ? *theta_rad : 0.0};
    const Pose pose = between(base, seen);
    tracks.x_m.data()[i] = pose.x_m;
    tracks.y_m.data()[i] = pose.y_m;
    if (headings) {
      *theta_rad = pose.theta_rad;
    }
  }
}

Eigen::MatrixXd with_zero_column(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd wider(matrix.rows(), matrix.cols() + 1);
  wider << Eigen::VectorXd::Zero(matrix.rows()), matrix;
  return wider;
}

void add_base(PointTracks& tracks) {
  tracks.names.insert(tracks.names.begin(), "the base");
  tracks.plates.insert(tracks.plates.begin(), 0);
  tracks.x_m = with_zero_column(tracks.x_m);
  tracks.y_m = with_zero_column(tracks.y_m);
  if (tracks.has_headings()) {
    tracks.theta_rad = with_zero_column(tracks.theta_rad);
  }
}

/// Of a tracked base: its median place, and what 95 % of its distances from there are within.
struct BaseScatter {
  double middle_x_m = 0.0;
  double middle_y_m = 0.0;
  double scatter_m = 0.0;
};

/// @pre rows is not empty
BaseScatter base_scatter(const PointTracks& tracks, const std::vector<Eigen::Index>& rows) {
  const double x_m = median(mapped<double>(rows, [&](Eigen::Index t) { return tracks.x_m(t, 0); }));
  const double y_m = median(mapped<double>(rows, [&](Eigen::Index t) { return tracks.y_m(t, 0); }));
  auto off_m = mapped<double>(rows, [&](Eigen::Index t) {
    return std::hypot(tracks.x_m(t, 0) - x_m, tracks.y_m(t, 0) - y_m);
  });
  return {x_m, y_m, quantile(std::move(off_m), kMostBaseRows)};
}

/// The base is bolted down: what is left of its motion is noise, unless there is too much of it.
void settle_base(const std::vector<bool>& tracked, PointTracks& tracks, RunReport& report) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index t = 0; t < tracks.row_count(); ++t) {
    if (tracked[std::size_t(t)]) {
      rows.push_back(t);
    }
  }
  const BaseScatter base = base_scatter(tracks, rows);
  report.base_scatter_m = base.scatter_m;
  if (report.base_scatter_m > kBaseStandsStill_m) {
    report.note(
        "the base moves by more than 5 mm: left as it was tracked",
        fmt::format("95 % of the rows have it within {:.1f} mm", 1e3 * report.base_scatter_m));
    return;
  }
  const double off_m = std::hypot(base.middle_x_m, base.middle_y_m);
  if (off_m > kBaseStandsStill_m) {
    report.note(
        "the base lies more than 5 mm from where 'alignment' has it: left as it was tracked",
        fmt::format("{:.1f} mm", 1e3 * off_m));
    return;
  }
  tracks.x_m.col(0).setZero();
  tracks.y_m.col(0).setZero();
  if (tracks.has_headings()) {
    tracks.theta_rad.col(0).setZero();
  }
}

}  // namespace

void show_still_base(PointTracks& tracks, RunReport& report) {
  std::vector<Eigen::Index> hidden;
  std::vector<Eigen::Index> seen;
  std::complex<double> heading;
  for (Eigen::Index t = 0; tracks.plates.front() == 0 && t < tracks.row_count(); ++t) {
    if (!tracks.is_tracked(t, 0)) {
      hidden.push_back(t);
      continue;
    }
    seen.push_back(t);
    heading += tracks.has_headings() ? std::polar(1.0, tracks.theta_rad(t, 0)) : 0.0;
  }
  if (hidden.empty() || seen.empty()) {
    return;
  }
  const BaseScatter base = base_scatter(tracks, seen);
  if (base.scatter_m > kBaseStandsStill_m) {
    return;
  }
  for (const Eigen::Index t : hidden) {
    tracks.x_m(t, 0) = base.middle_x_m;
    tracks.y_m(t, 0) = base.middle_y_m;
    if (tracks.has_headings()) {
      tracks.theta_rad(t, 0) = std::arg(heading);
    }
  }
  report.note("rows that hide the base: it stands still, and lies there where it always does", {},
              std::ssize(hidden));
}

bool is_base_sought(const BaseAlignment& alignment) {
  return alignment.kind == BaseAlignment::Kind::base ||
         alignment.kind == BaseAlignment::Kind::straight;
}

BaseSighting sight_base(const std::string& log, const std::vector<bool>& tracked,
                        const BaseAlignment& alignment, const ArmDescription& arm,
                        const PointTracks& tracks) {
  return BaseFinder(log, tracked, alignment, arm, tracks).sight();
}

void align_base(const std::string& log, const std::vector<bool>& tracked,
                const BaseAlignment& alignment, const ArmDescription& arm, PointTracks& tracks,
                RunReport& report) {
  const BaseFinder finder(log, tracked, alignment, arm, tracks);
  report.base = is_base_sought(alignment) ? bases_of({finder.sight()}).front() : alignment.pose;
  if (alignment.kind == BaseAlignment::Kind::straight && tracks.has_headings()) {
    tracks.theta_rad.rowwise() -= finder.heading_offsets().transpose();
    tracks.theta_rad.array() += report.base.theta_rad;
  }
  transform(report.base, tracks);
  if (tracks.plates.front() != 0) {
    add_base(tracks);
  }
  settle_base(tracked, tracks, report);
}

}  // namespace limber
