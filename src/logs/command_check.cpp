// The columns of commands where no mapping names them.
#include "command_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/arm_commands.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/log_units.hpp"
#include "limber/logs/import_mapping.hpp"
#include "longest_gap.hpp"

namespace limber {

namespace {

/// The names that limber gives the columns of segments' commands.
CommandColumns default_columns(const ArmDescription& arm, int first) {
  CommandColumns columns;
  columns.unit = arm.command.unit;
  for (int i = first; i < first + arm.channel_count(); ++i) {
    columns.columns.push_back(quantity_column(arm.command, followed_name(arm.command), i));
    columns.setpoint.push_back(quantity_column(arm.command, "setpoint", i));
  }
  columns.setpoint_optional = true;
  return columns;
}

/// Those of the arm file's `commands`, by their names.
CommandColumns summed_columns(const ArmDescription& arm) {
  CommandColumns columns;
  columns.unit = arm.command.unit;
  columns.summed = true;
  for (const ArmCommand& command : arm.commands) {
    columns.columns.push_back(command.name);
    columns.setpoint.push_back("setpoint_" + command.name);
  }
  columns.setpoint_optional = true;
  return columns;
}

/// T×M to T×n. A command that is missing leaves the segments alone that it does not act on.
Eigen::MatrixXd summed(const Eigen::MatrixXd& values, const Eigen::MatrixXd& shares) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(values.rows(), shares.rows());
  for (Eigen::Index i = 0; i < shares.rows(); ++i) {
    for (Eigen::Index k = 0; k < shares.cols(); ++k) {
      if (shares(i, k) != 0.0) {
        sums.col(i) += shares(i, k) * values.col(k);
      }
    }
  }
  return sums;
}

std::vector<std::string> sums_of(const ArmDescription& arm) {
  return mapped<std::string>(arm.channel_count(), [&](int i) { return command_sum(arm, i); });
}

constexpr double kOvershoot = 1.05;
constexpr double kConstant = 0.02;  // of the limit, range over the whole log
constexpr double kHigh = 0.99;      // quantile of the sizes: spikes decide nothing

/// Numbers of one segment's column.
struct ColumnFacts {
  std::vector<double> sizes;  // PressureLimits::size_kpa, sorted
  double farthest = 0.0;      // the value of the last
  double lowest = 0.0;
  double highest = 0.0;
};

ColumnFacts facts_of(const Eigen::MatrixXd& values, Eigen::Index column,
                     const PressureLimits& limits) {
  ColumnFacts facts;
  double largest = -1.0;
  for (Eigen::Index t = 0; t < values.rows(); ++t) {
    const double value = values(t, column);
    if (std::isfinite(value)) {
      facts.lowest = facts.sizes.empty() ? value : std::min(facts.lowest, value);
      facts.highest = facts.sizes.empty() ? value : std::max(facts.highest, value);
      facts.sizes.push_back(limits.size_kpa(value));
      if (facts.sizes.back() > largest) {
        largest = facts.sizes.back();
        facts.farthest = limits.is_symmetric() ? std::abs(value) : value;
      }
    }
  }
  std::sort(facts.sizes.begin(), facts.sizes.end());
  return facts;
}

std::string name_of(const CommandColumns& commands, Eigen::Index i) {
  return commands.columns.empty() ? fmt::format("{}' and '{}", commands.right[std::size_t(i)],
                                                commands.left[std::size_t(i)])
                                  : commands.columns[std::size_t(i)];
}

std::string unit_advice(double ratio, const ImportMapping& mapping) {
  const std::string unit = unit_suspicion(ratio, mapping.commands.unit);
  return unit.empty() ? "Is it the right column, and the right arm?"
                      : fmt::format("The mapping reads it in {}: {}", mapping.commands.unit, unit);
}

/// @throws InputError where so many rows are so far beyond the limit that it is another unit.
void require_within(const std::string& log, const std::string& column, const ArmDescription& arm,
                    Eigen::Index i, const ColumnFacts& facts, const ImportMapping& mapping) {
  const PressureLimits& limits = arm.limits_of_channel(int(i));
  const double limit = limits.largest_kpa();
  const auto beyond = facts.sizes.end() -
                      std::upper_bound(facts.sizes.begin(), facts.sizes.end(), kFarBeyond * limit);
  if (double(beyond) > kMaxFarBeyond * double(facts.sizes.size())) {
    const std::string& unit = arm.command.unit;
    throw InputError(fmt::format(
        "{}: '{}' ({}) reaches {:.4g} {}; the limit of arm '{}' is {} {}. {}", log, column,
        channel_name(arm, i), facts.farthest, unit, arm.name, limits_to_yaml(limits), unit,
        unit_advice(quantile(facts.sizes, kHigh) / limit, mapping)));
  }
}

std::int64_t bridge_gaps(double longest_gap_s, const std::vector<double>& time_s,
                         Eigen::Ref<Eigen::VectorXd> values) {
  std::int64_t bridged = 0;
  Eigen::Index before = -1;
  for (Eigen::Index t = 0; t < values.size(); ++t) {
    if (!std::isfinite(values[t])) {
      continue;
    }
    if (before >= 0 && time_s[std::size_t(t)] - time_s[std::size_t(before)] <= longest_gap_s) {
      for (Eigen::Index gap = before + 1; gap < t; ++gap) {
        const double part = (time_s[std::size_t(gap)] - time_s[std::size_t(before)]) /
                            (time_s[std::size_t(t)] - time_s[std::size_t(before)]);
        values[gap] = values[before] + part * (values[t] - values[before]);
        ++bridged;
      }
    }
    before = t;
  }
  return bridged;
}

/// An empty cell says nothing new: the set point before it stays in force.
std::int64_t hold_over_gaps(Eigen::Ref<Eigen::VectorXd> values) {
  std::int64_t held = 0;
  for (Eigen::Index t = 1; t < values.size(); ++t) {
    if (!std::isfinite(values[t]) && std::isfinite(values[t - 1])) {
      values[t] = values[t - 1];
      ++held;
    }
  }
  return held;
}

}  // namespace

void hold_setpoints(Eigen::MatrixXd& values) {
  for (auto column : values.colwise()) {
    hold_over_gaps(column);
  }
}

ImportMapping default_import_mapping(const ArmDescription& arm) {
  ImportMapping mapping;
  mapping.commands = arm.commands.empty() ? default_columns(arm, 0) : summed_columns(arm);
  return mapping;
}

CommandColumns as_counted_in(const std::vector<std::string>& names, CommandColumns commands,
                             const ArmDescription& arm) {
  if (!commands.setpoint_optional) {
    return commands;
  }
  const auto are_there = [&](const std::vector<std::string>& columns) {
    return std::ranges::all_of(columns, [&](const std::string& name) {
      return std::ranges::find(names, name) != names.end();
    });
  };
  const auto begin_there = [&](const CommandColumns& columns) {
    return are_there({columns.columns.front()}) || are_there({columns.setpoint.front()});
  };
  if (commands.summed && !begin_there(commands) && begin_there(default_columns(arm, 0))) {
    commands = default_columns(arm, 0);
  }
  const CommandColumns from_1 = default_columns(arm, 1);
  if (!begin_there(commands) && (are_there(from_1.columns) || are_there(from_1.setpoint))) {
    commands = from_1;
  }
  const bool has_setpoints = are_there(commands.setpoint);
  if (has_setpoints && !are_there({commands.columns.front()})) {
    commands.columns = commands.setpoint;
    commands.measured = false;
  } else if (!has_setpoints && !arm.command.is_pressure_kpa()) {
    commands.measured = false;  // commands alone are set points
  }
  if (!commands.measured) {
    commands.setpoint.clear();
    commands.setpoint_optional = false;
  }
  return commands;
}

void sum_commands(const ImportMapping& mapping, const ArmDescription& arm, CommandTrack& commands,
                  RunReport& report) {
  if (!mapping.commands.summed) {
    return;
  }
  const Eigen::MatrixXd shares = command_shares(arm);
  if (!commands.measured) {
    hold_setpoints(commands.values);
  }
  commands.values = summed(commands.values, shares);
  if (commands.setpoint.size() > 0) {
    hold_setpoints(commands.setpoint);
    commands.setpoint = summed(commands.setpoint, shares);
  }
  std::vector<std::string> sums = sums_of(arm);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = fmt::format("{} = {}", channel_name(arm, Eigen::Index(i)), sums[i]);
  }
  report.note("logs whose commands were summed to those of segments, as the arm file says",
              fmt::format("{}", fmt::join(sums, ", ")));
}

ImportMapping with_sums_named(ImportMapping mapping, const ArmDescription& arm) {
  if (mapping.commands.summed) {
    mapping.commands.columns = sums_of(arm);
    mapping.commands.setpoint.clear();
    for (const std::string& sum : mapping.commands.columns) {
      mapping.commands.setpoint.push_back("set point of " + sum);
    }
  }
  return mapping;
}

void check_commands(const std::string& log, const ImportMapping& mapping, const ArmDescription& arm,
                    CommandTrack& commands, RunReport& report) {
  const std::string& unit = arm.command.unit;
  const double longest_gap_s = longest_gap_in_s(mapping.longest_gap_s, commands.time_s);
  int constant = 0;
  double max_ratio = 0.0;
  for (Eigen::Index i = 0; i < commands.values.cols(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(int(i));
    const double limit = limits.largest_kpa();
    const std::string name = name_of(mapping.commands, i);
    const ColumnFacts facts = facts_of(commands.values, i, limits);
    if (facts.sizes.empty()) {
      throw InputError(
          fmt::format("{}: column '{}' ({}) holds no number", log, name, channel_name(arm, i)));
    }
    require_within(log, name, arm, i, facts, mapping);
    if (commands.setpoint.size() > 0) {
      require_within(log, mapping.commands.setpoint[std::size_t(i)], arm, i,
                     facts_of(commands.setpoint, i, limits), mapping);
      hold_over_gaps(commands.setpoint.col(i));  // frames may pass over the row that has it
    }
    if (facts.sizes.back() > kOvershoot * limit) {
      report.note("a command more than 5 % beyond its limit",
                  fmt::format("'{}': {:.4g} {}, limit {}", name, facts.farthest, unit,
                              limits_to_yaml(limits)));
    }
    max_ratio = std::max(max_ratio, facts.sizes.back() / limit);
    if (facts.highest - facts.lowest < kConstant * limit) {
      ++constant;
      report.note("a command that never changes: nothing can be learnt about what it moves",
                  fmt::format("'{}' ({}) stays within {:.4g} … {:.4g} {}", name,
                              channel_name(arm, i), facts.lowest, facts.highest, unit));
    }
    const std::int64_t bridged =
        commands.measured ? bridge_gaps(longest_gap_s, commands.time_s, commands.values.col(i))
                          : hold_over_gaps(commands.values.col(i));
    if (bridged > 0) {
      report.note(commands.measured ? "missing commands put between their neighbours in time"
                                    : "missing set points: those before them stay in force",
                  fmt::format("'{}'", name), bridged);
    }
  }
  if (constant == commands.values.cols()) {
    throw InputError(
        fmt::format("{}: no {} ever changes by more than {:.0f} % "
                    "of its limit: nothing can be learnt from it. {}",
                    log, arm.command.name, 100.0 * kConstant, unit_advice(max_ratio, mapping)));
  }
}

}  // namespace limber
