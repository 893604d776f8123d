#include "column_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/data/assignment.hpp"

namespace limber {

namespace {

constexpr double kForGiven = 1.0;  // [nats] what stands still, or nearly, keeps its column
constexpr double kWeak = 0.4;      // of correlations; good logs of real arms reach 0.8 and more
constexpr double kOften = 10.0;    // independent rows

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
  if (!levels.turned[i]) {
    segment.undecidable = Undecidable::turned_little;
  } else if (!levels.changed[segment.column]) {
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
      segment.alike = order[i];
    }
  }
}

constexpr double kNothing = 0.2;  // of correlations: nothing follows its column

/// "segment 0: a - b, segment 1: -(c)", for an arm file's `commands`.
std::string fitting_sums(const ColumnFit& fit, const CommandColumns& commands) {
  std::vector<std::string> sums;
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const std::string& sum = commands.columns[std::size_t(fit.segments[i].column)];
    sums.push_back(fmt::format(fmt::runtime(fit.segments[i].turned ? "{}: -({})" : "{}: {}"),
                               segment_name(Eigen::Index(i)), sum));
  }
  return fmt::format("{}", fmt::join(sums, ", "));
}

/// "right: [a, b], left: [c, d]" or "columns: [a, -b]", as a mapping would have to say it.
std::string fitting_mapping(const ColumnFit& fit, const CommandColumns& commands) {
  if (commands.summed) {
    return fitting_sums(fit, commands);
  }
  std::vector<std::string> first;
  std::vector<std::string> second;
  for (const FittedColumn& segment : fit.segments) {
    const auto at = std::size_t(segment.column);
    if (!commands.columns.empty()) {
      const std::string& name = commands.columns[at];
      first.push_back(!segment.turned ? name : name.starts_with('-') ? name.substr(1) : "-" + name);
    } else {
      first.push_back(segment.turned ? commands.left[at] : commands.right[at]);
      second.push_back(segment.turned ? commands.right[at] : commands.left[at]);
    }
  }
  return second.empty() ? fmt::format("{}: [{}]", commands.measured ? "columns" : "setpoints",
                                      fmt::join(first, ", "))
                        : fmt::format("right: [{}], left: [{}]", fmt::join(first, ", "),
                                      fmt::join(second, ", "));
}

/// "segment 0 0.95 (as given -0.12), segment 1 …"
std::string correlations_text(const ColumnFit& fit) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const FittedColumn& segment = fit.segments[i];
    parts.push_back(segment.undecidable == Undecidable::no || segment.follows_weakly
                        ? fmt::format("{} {:.2f} (as given {:.2f})", segment_name(Eigen::Index(i)),
                                      segment.correlation, segment.as_given)
                        : fmt::format("{} can't be told", segment_name(Eigen::Index(i))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string why(const FittedColumn& segment) {
  switch (segment.undecidable) {
    case Undecidable::turned_little:
      return "it hardly turned";
    case Undecidable::told_little:
      return "its column hardly changed";
    case Undecidable::moved_seldom:
      return "it moved too seldom";
    case Undecidable::told_alike:
      return fmt::format("it was told much the same as {}", segment_name(segment.alike));
    case Undecidable::no:
      break;
  }
  return {};
}

/// Whether every segment that moved often follows nothing of what its column says.
bool follows_nothing(const ColumnFit& fit) {
  const auto can_tell = [](const FittedColumn& segment) {
    return segment.undecidable == Undecidable::no;
  };
  const auto follows = [&](const FittedColumn& segment) {
    return can_tell(segment) && (!segment.follows_weakly || segment.as_given > kNothing);
  };
  return std::ranges::any_of(fit.segments, can_tell) && std::ranges::none_of(fit.segments, follows);
}

std::string all_of(const std::vector<std::string>& logs) {
  return logs.size() == 1 ? logs.front()
                          : fmt::format("{} and {} more", logs.front(), logs.size() - 1);
}

}  // namespace

double bends_left(const ArmDescription& arm, Eigen::Index segment) {
  switch (arm.no_load) {
    case NoLoadKind::strain_polynomial:
      return -1.0;
    case NoLoadKind::curvature:
      return arm.segments[segment].curvature_per_unit > 0.0 ? 1.0 : -1.0;
    default:
      return 0.0;
  }
}

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
    segment.column = fit.belongs ? i : order[i];
    const double r = agreement(levels, arm, i, segment.column);
    segment.turned = !fit.belongs && r < 0.0;
    segment.correlation = segment.turned ? -r : r;
    find_undecidable(levels, fit.given_evidence, i, segment);
    fit.segments.push_back(segment);
  }
  return fit;
}

void refuse_columns(const std::string& log, const ColumnFit& fit, const ImportMapping& mapping,
                    const ArmDescription& arm) {
  bool permuted = false;
  bool all_turned = true;
  bool turned = false;
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const FittedColumn& segment = fit.segments[i];
    permuted = permuted || segment.column != Eigen::Index(i);
    turned = turned || segment.turned;
    all_turned = all_turned && (segment.turned || segment.undecidable != Undecidable::no);
  }
  std::string what;
  if (permuted) {
    what = fmt::format("the {}s' columns are not in the segments' order{}", arm.command.name,
                       turned ? ", and some have the other sign" : "");
  } else {
    what = fmt::format("{} bends to the other side than its {} says: positive bends {}",
                       all_turned ? "the arm" : "a segment", arm.command.name,
                       arm.no_load == NoLoadKind::curvature
                           ? "to the side of curvature_per_unit's sign, left for +"
                           : "right, towards -y");
  }
  throw InputError(fmt::format(
      "{}: {}. What would fit: '{}'. Correlations of levels then: {}. Change the mapping{}{}", log,
      what, fitting_mapping(fit, mapping.commands), correlations_text(fit),
      mapping.commands.summed ? ", or 'commands' in the arm file" : "",
      all_turned && turned
          ? "; or the plane is seen from the other side: turn y (or 'up'); or the arm gets longer "
            "under pressure, and bends away from it: the right is the side that it bends to"
          : ""));
}

void check_columns(const std::vector<std::string>& logs, const std::vector<LevelTable>& levels,
                   const ImportMapping& mapping, const ArmDescription& arm,
                   std::vector<SegmentCheck>& checks) {
  LevelTable all;
  for (const LevelTable& own : levels) {
    append(all, own);
  }
  const ColumnFit fit = fit_columns(correlate_levels(all, arm), arm);
  if (!fit.belongs) {
    refuse_columns(all_of(logs), fit, mapping, arm);
  }
  for (std::size_t run = 0; run < levels.size() && levels.size() > 1; ++run) {
    const ColumnFit own = fit_columns(correlate_levels(levels[run], arm), arm, kDecisiveAlone);
    if (!own.belongs) {
      refuse_columns(logs[run] + " (the other logs fit the mapping)", own, mapping, arm);
    }
  }
  if (follows_nothing(fit)) {
    throw InputError(fmt::format(
        "{}: the arm does not do what its {}s say: correlations of levels are {}. Do the columns, "
        "the logs and the arm belong together, and are their times on one clock?",
        all_of(logs), arm.command.name, correlations_text(fit)));
  }
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const FittedColumn& segment = fit.segments[i];
    checks.push_back({segment.as_given, segment.follows_weakly, why(segment)});
  }
}

}  // namespace limber
