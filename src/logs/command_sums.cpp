#include "command_sums.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/arm_commands.hpp"
#include "limber/arm/names.hpp"

namespace limber {

namespace {

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
  std::vector<std::string> sums;
  for (int i = 0; i < arm.channel_count(); ++i) {
    sums.push_back(command_sum(arm, i));
  }
  return sums;
}

}  // namespace

void hold_setpoints(Eigen::MatrixXd& values) {
  for (Eigen::Index t = 1; t < values.rows(); ++t) {
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      if (std::isnan(values(t, k))) {
        values(t, k) = values(t - 1, k);
      }
    }
  }
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
  }
  return mapping;
}

}  // namespace limber
