#include "column_fit.hpp"

#include <algorithm>
#include <cmath>

#include "limber/data/assignment.hpp"

namespace limber {

namespace {

constexpr double kForGiven = 1.0;  // [nats] what stands still, or nearly, keeps its column
constexpr double kWeak = 0.4;      // of correlations; good logs of real arms reach 0.8 and more
constexpr double kOften = 10.0;    // independent rows

/// +1 where a larger command bends to the left, −1 to the right, 0 where nothing is known of it.
double bends_left(const ArmDescription& arm, Eigen::Index segment) {
  switch (arm.no_load) {
    case NoLoadKind::strain_polynomial:
      return -1.0;
    case NoLoadKind::curvature:
      return arm.segments[static_cast<std::size_t>(segment)].curvature_per_unit > 0.0 ? 1.0 : -1.0;
    default:
      return 0.0;
  }
}

/// Correlation as the arm file expects it: positive where it agrees. Without a sign of its own a
/// segment agrees with either.
double agreement(const LevelCorrelations& levels, const ArmDescription& arm, Eigen::Index segment,
                 Eigen::Index column) {
  const double sign = bends_left(arm, segment);
  const double r = levels.correlation(segment, column);
  return sign == 0.0 ? std::abs(r) : sign * r;
}

void find_undecidable(const LevelCorrelations& levels, double given, Eigen::Index i,
                      FittedColumn& segment) {
  const auto at = static_cast<std::size_t>(i);
  if (!levels.turned[at]) {
    segment.undecidable = Undecidable::turned_little;
  } else if (!levels.changed[static_cast<std::size_t>(segment.column)]) {
    segment.undecidable = Undecidable::told_little;
  } else if (segment.correlation < kWeak && levels.independent_rows(i, segment.column) > kOften) {
    segment.follows_weakly = true;
  } else if (levels.evidence(i, segment.column) < kDecisive) {
    segment.undecidable = Undecidable::moved_seldom;
  } else if (segment.column == i && levels.evidence.rows() > 1) {
    Eigen::MatrixXd others = levels.evidence;
    others(i, i) = -(levels.evidence.sum() + 1.0);
    const std::vector<Eigen::Index> order = best_assignment(others);
    if (given - assigned_sum(others, order) < kDecisive) {
      segment.undecidable = Undecidable::told_alike;
      segment.alike = order[at];
    }
  }
}

}  // namespace

ColumnFit fit_columns(const LevelCorrelations& levels, const ArmDescription& arm, double decisive) {
  const Eigen::Index n = arm.segment_count();
  ColumnFit fit;
  for (Eigen::Index i = 0; i < n; ++i) {
    fit.given_evidence += agreement(levels, arm, i, i) > 0.0 ? levels.evidence(i, i) : 0.0;
  }
  const Eigen::MatrixXd preferred = levels.evidence + kForGiven * Eigen::MatrixXd::Identity(n, n);
  const std::vector<Eigen::Index> order = best_assignment(preferred);
  fit.best_evidence = assigned_sum(levels.evidence, order);
  fit.belongs = fit.best_evidence < fit.given_evidence + decisive;
  for (Eigen::Index i = 0; i < n; ++i) {
    FittedColumn segment;
    segment.as_given = agreement(levels, arm, i, i);
    segment.column = fit.belongs ? i : order[static_cast<std::size_t>(i)];
    const double r = agreement(levels, arm, i, segment.column);
    segment.turned = !fit.belongs && r < 0.0;
    segment.correlation = segment.turned ? -r : r;
    find_undecidable(levels, fit.given_evidence, i, segment);
    fit.segments.push_back(segment);
  }
  return fit;
}

}  // namespace limber
