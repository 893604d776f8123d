#include "tracker_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Eigenvalues>

#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kUnitTolerance = 0.15;  // of a length or a turn: units are farther apart
constexpr double kMaxMisfitShare = 0.1;  // of the arm's length: markers sit so near their plates

struct NamedUnit {
  const char* name;
  double si;
};
constexpr std::array<NamedUnit, 4> kLengthUnits = {
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}}};
constexpr std::array<NamedUnit, 2> kAngleUnits = {{{"rad", 1.0}, {"degrees", kRadPerDeg}}};

/// Scale of a line of plates laid onto bodies, and how far these are off it at worst.
struct LineFit {
  double units_per_metre = 0.0;
  double misfit_m = 0.0;
};

LineFit line_fit(const std::vector<double>& along_m, const Eigen::MatrixX3d& bodies,
                 const std::vector<int>& order) {
  const auto count = double(along_m.size());
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  const double centre_m = mean(along_m);
  for (std::size_t i = 0; i < along_m.size(); ++i) {
    centre += bodies.row(order[i]).head<2>().transpose() / count;
  }
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();
  double spread = 0.0;
  for (std::size_t i = 0; i < along_m.size(); ++i) {
    const double m = along_m[i] - centre_m;
    direction += m * (bodies.row(order[i]).head<2>().transpose() - centre);
    spread += m * m;
  }
  direction /= spread;
  LineFit fit;
  fit.units_per_metre = direction.norm();
  for (std::size_t i = 0; i < along_m.size(); ++i) {
    const Eigen::Vector2d off =
        bodies.row(order[i]).head<2>().transpose() - centre - (along_m[i] - centre_m) * direction;
    fit.misfit_m = std::max(fit.misfit_m, off.norm() / fit.units_per_metre);
  }
  return fit;
}

/// Bodies in the order in which they lie along the arm; the one that moves least first.
std::vector<int> order_along(const Eigen::MatrixX3d& bodies, const Eigen::VectorXd& moved) {
  const Eigen::MatrixX2d centred =
      bodies.leftCols<2>().rowwise() - bodies.leftCols<2>().colwise().mean();
  const Eigen::Matrix2d spread = centred.transpose() * centred;
  const Eigen::Vector2d axis =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
  const Eigen::VectorXd along = centred * axis;
  std::vector<int> order(std::size_t(bodies.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return along[a] < along[b]; });
  if (moved[order.front()] > moved[order.back()]) {
    std::reverse(order.begin(), order.end());
  }
  return order;
}

/// How far each body went at most, from rest to a held pulse.
Eigen::VectorXd motion_of_bodies(const MeanPose& rest, const std::vector<PulsePoses>& pulses) {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(rest.pose.rows());
  for (const PulsePoses& pulse : pulses) {
    moved = moved.cwiseMax((pulse.held.pose - rest.pose).leftCols<2>().rowwise().norm());
  }
  return moved;
}

double metres_per_unit(const ArmDescription& arm, const MeanPose& rest,
                       const std::vector<PulsePoses>& pulses) {
  const std::vector<double> along_m = rest_positions_m(arm);
  std::vector<int> as_sent(along_m.size());
  std::iota(as_sent.begin(), as_sent.end(), 0);
  const std::vector<int> order = order_along(rest.pose, motion_of_bodies(rest, pulses));
  const LineFit sent = line_fit(along_m, rest.pose, as_sent);
  const LineFit sorted = line_fit(along_m, rest.pose, order);
  const double near_m = kMaxMisfitShare * arm.length_m();
  const bool reversed = order.front() == as_sent.back() && order.back() == as_sent.front();
  if ((sent.misfit_m > near_m || reversed) && sorted.misfit_m < near_m) {
    throw CalibrationRefused(
        fmt::format("the marker bodies come in another order than the plates; along the arm, base "
                    "first, they are {}: let the driver send them so",
                    fmt::join(order, ", ")));
  }
  if (sent.misfit_m > near_m) {
    throw CalibrationRefused(
        fmt::format("the marker bodies do not lie on a straight line as the "
                    "plates do: one is {:.1f} cm off. Lay the arm straight",
                    100.0 * sent.misfit_m));
  }
  for (const NamedUnit& unit : kLengthUnits) {
    if (std::abs(sent.units_per_metre * unit.si - 1.0) < kUnitTolerance) {
      return unit.si;
    }
  }
  throw CalibrationRefused(fmt::format(
      "the tracked arm is {:.4g} units long; arm '{}' is {:.4g} m long, and no unit (m, cm, mm, "
      "in) fits. Is it this arm?",
      sent.units_per_metre * arm.length_m(), arm.name, arm.length_m()));
}

/// How many of `poses`' turns of θ go with one turn of the lines between neighbouring bodies.
double turn_ratio(const SeenPoses& poses, const CalibrationLog& log,
                  const std::vector<double>& along_m, double frame_period_s) {
  double product = 0.0;
  double square = 0.0;
  for (const PulsePoses& pulse : pulse_poses(poses, log, frame_period_s)) {
    const Eigen::MatrixX3d& a = pulse.before.pose;
    const Eigen::MatrixX3d& b = pulse.held.pose;
    // Lines over about a fifth of the arm: shorter ones turn by what noise moves their ends.
    const auto apart = Eigen::Index(std::max<std::size_t>(1, along_m.size() / 5));
    for (Eigen::Index i = 0; i + apart < a.rows(); ++i) {
      const Eigen::Vector2d was = (a.row(i + apart) - a.row(i)).head<2>();
      const Eigen::Vector2d is = (b.row(i + apart) - b.row(i)).head<2>();
      const double line_rad = std::atan2(was.x() * is.y() - was.y() * is.x(), was.dot(is));
      const Eigen::Index bodies = apart + 1;
      const double theta_rad = (b - a).col(2).segment(i, bodies).mean();
      product += theta_rad * line_rad;
      square += line_rad * line_rad;
    }
  }
  return square > 0.0 ? product / square : 0.0;
}

}  // namespace

TrackerCalibration tracker_units(const ArmDescription& arm, const SeenPoses& raw,
                                 const CalibrationLog& log) {
  const MeanPose rest = mean_pose(raw, 0, log.rest_end, "at rest");
  TrackerCalibration tracker;
  tracker.metres_per_unit = metres_per_unit(arm, rest, pulse_poses(raw, log, arm.frame_period_s()));
  double found = 0.0;
  for (const NamedUnit& unit : kAngleUnits) {
    tracker.radians_per_unit = unit.si;
    const double ratio =
        turn_ratio(in_metres(raw, tracker), log, rest_positions_m(arm), arm.frame_period_s());
    if (std::abs(std::abs(ratio) - 1.0) < 2.0 * kUnitTolerance) {
      tracker.radians_per_unit = std::copysign(unit.si, ratio);
      return tracker;
    }
    found = unit.si == 1.0 ? ratio : found;
  }
  throw CalibrationRefused(fmt::format(
      "headings turn {:.3g} times as far as positions do; expected 1 (rad) or 57.3 (degrees). Are "
      "the headings those of the same bodies?",
      found));
}

}  // namespace limber
