#include "limber/logs/command_shares.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include "backbone_building.hpp"
#include "column_check.hpp"
#include "command_check.hpp"
#include "level_correlation.hpp"
#include "limber/arm/arm_commands.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/yaml_reader.hpp"
#include "log_clock.hpp"
#include "log_runs.hpp"

namespace limber {

namespace {

constexpr double kPeriod_s = 1.0 / kLevelRate_hz;
constexpr int kMaxLagPeriods = 10;
constexpr double kClearlyLess = 0.002;  // of what is left unexplained: no lag for less than that
constexpr Eigen::Index kPieces = 10;    // of the jackknife
constexpr double kMinShare = 0.05;      // of a segment's largest
// Of the largest variance: commands moved too little along such a direction to say what it does.
constexpr double kUnmoved = 1e-3;
constexpr double kAlike = 0.99;        // of correlations
constexpr double kMinExplained = 0.2;  // of a turn's variance; six motors' logs reach 0.9

/// The names of the mapping's command columns.
std::vector<std::string> own_commands(const fs::path& mapping) {
  const YamlReader root = YamlReader::from_file(mapping);
  const YamlReader node = root.at(root.has("pressures") ? "pressures" : "commands");
  node.refuse_if(!node.has("columns") && !node.has("setpoints"),
                 "expected 'columns', or 'setpoints', one for each of the arm's own commands");
  std::vector<std::string> names;
  const YamlReader columns = node.at(node.has("columns") ? "columns" : "setpoints");
  for (const YamlReader& element : columns.elements()) {
    names.push_back(element.text());
    element.refuse_if(names.back().starts_with('-'),
                      "expected a column without a sign: signs are what is looked for");
  }
  return names;
}

/// The arm as if its file listed them.
ArmDescription with_commands(ArmDescription arm, const std::vector<std::string>& names) {
  arm.commands.clear();
  for (const std::string& name : names) {
    arm.commands.push_back({name, std::vector<double>(arm.segments.size(), 0.0)});
  }
  return arm;
}

/// Turns of segments and all command columns of the logs.
LevelTable levels_in(const std::vector<fs::path>& logs, const ImportMapping& mapping,
                     const ArmDescription& arm) {
  LevelTable levels;
  for (const fs::path& log : logs) {
    for (LogRun& run : read_csv_runs(log, mapping, arm, true)) {
      throw_if_interrupted();
      const std::string name = log.string();
      put_in_order(name, run.points, run.report);
      put_in_order(name, run.commands, run.report);
      check_clock(name, run.time, run.points.time_s, arm);
      if (!run.commands.measured) {
        hold_setpoints(run.commands.values);
      }
      const BackboneTrack motion =
          build_backbone(name, std::move(run.points), mapping, arm, run.report);
      append(levels, levels_of(motion, run.commands, arm));
    }
  }
  return levels;
}

/// Behind a first-order lag that begins settled in each run.
Eigen::MatrixXd behind(double lag_s, const LevelTable& levels) {
  Eigen::MatrixXd lagged = levels.command;
  const double share = 1.0 - std::exp(-kPeriod_s / lag_s);
  Eigen::Index begin = 0;
  for (const Eigen::Index end : levels.run_ends) {
    for (Eigen::Index t = begin + 1; lag_s > 0.0 && t < end; ++t) {
      lagged.row(t) = (1.0 - share) * lagged.row(t - 1) + share * levels.command.row(t);
    }
    begin = end;
  }
  return lagged;
}

/// Of (1, commands, turns): second moments about 0.
using Moments = Eigen::MatrixXd;

Moments moments_of(const Eigen::MatrixXd& commands, const Eigen::MatrixXd& turns) {
  Eigen::MatrixXd rows(commands.rows(), 1 + commands.cols() + turns.cols());
  rows << Eigen::VectorXd::Ones(commands.rows()), commands, turns;
  return rows.transpose() * rows;
}

/// Turns by commands, each with an offset.
struct Regression {
  Eigen::MatrixXd slopes;       // M×n [rad per unit], the smallest that explain as much
  Eigen::VectorXd explained;    // n, of the turns' variances
  Eigen::MatrixXd correlation;  // M×M, of the commands
};

Regression regress(const Moments& moments, Eigen::Index commands) {
  const Eigen::Index m = commands;
  const Eigen::Index n = moments.cols() - 1 - m;
  const double rows = std::max(moments(0, 0), 1.0);
  const Eigen::MatrixXd mean = moments.row(0).tail(m + n) / rows;
  const Eigen::MatrixXd covariance =
      moments.bottomRightCorner(m + n, m + n) / rows - mean.transpose() * mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance.topLeftCorner(m, m));
  const Eigen::VectorXd& variance = solver.eigenvalues();
  const double least = std::max(kUnmoved * variance.maxCoeff(), 1e-300);
  const Eigen::VectorXd inverse =
      (variance.array() > least).select(variance.array().max(least).inverse(), 0.0);
  const Eigen::MatrixXd& axes = solver.eigenvectors();
  Regression result;
  result.slopes = axes * inverse.asDiagonal() * axes.transpose() * covariance.topRightCorner(m, n);
  const Eigen::ArrayXd turned = covariance.diagonal().tail(n).array().max(1e-300);
  const Eigen::ArrayXd followed =
      (result.slopes.transpose() * covariance.topRightCorner(m, n)).diagonal().array();
  result.explained = followed / turned;
  const Eigen::VectorXd scale = covariance.diagonal().head(m).array().max(1e-300).sqrt().inverse();
  result.correlation = scale.asDiagonal() * covariance.topLeftCorner(m, m) * scale.asDiagonal();
  return result;
}

struct LaggedRegression {
  double lag_s = 0.0;
  Regression all;
  std::vector<Regression> left_out;  // without each of the pieces
};

LaggedRegression regress_levels(const LevelTable& levels) {
  LaggedRegression best;
  double best_left = 0.0;
  for (int lag = 0; lag <= kMaxLagPeriods; ++lag) {
    throw_if_interrupted();
    const Eigen::MatrixXd commands = behind(lag * kPeriod_s, levels);
    std::vector<Moments> pieces;
    Moments sum;
    for (Eigen::Index p = 0; p < kPieces; ++p) {
      const Eigen::Index begin = p * levels.row_count() / kPieces;
      const Eigen::Index count = (p + 1) * levels.row_count() / kPieces - begin;
      pieces.push_back(
          moments_of(commands.middleRows(begin, count), levels.turn_rad.middleRows(begin, count)));
      sum = p == 0 ? pieces.back() : Moments(sum + pieces.back());
    }
    Regression all = regress(sum, commands.cols());
    const double left = (1.0 - all.explained.array()).sum();
    if (lag > 0 && left >= (1.0 - kClearlyLess) * best_left) {
      continue;
    }
    best_left = left;
    best = {lag * kPeriod_s, std::move(all), {}};
    for (const Moments& piece : pieces) {
      best.left_out.push_back(regress(sum - piece, commands.cols()));
    }
  }
  return best;
}

/// Half of the 95 % interval of a slope, by the jackknife.
double half_interval(const LaggedRegression& fit, Eigen::Index k, Eigen::Index i) {
  const auto slopes =
      mapped<double>(fit.left_out, [&](const Regression& one) { return one.slopes(k, i); });
  return kTwoSided95 * jackknife_error(slopes);
}

/// Of segment i, M numbers.
Eigen::VectorXd shares_of_segment(const LaggedRegression& fit, const ArmDescription& arm,
                                  Eigen::Index i) {
  const double sign = bends_left(arm, i) < 0.0 ? -1.0 : 1.0;
  Eigen::VectorXd shares = sign * fit.all.slopes.col(i);
  const double largest = shares.lpNorm<Eigen::Infinity>();
  for (Eigen::Index k = 0; k < shares.size(); ++k) {
    if (std::abs(shares[k]) < std::max(kMinShare * largest, half_interval(fit, k, i))) {
      shares[k] = 0.0;
    }
  }
  if (shares.isZero(0.0) || fit.all.explained[i] < kMinExplained) {
    throw InputError(fmt::format(
        "{}: no command moves it for certain; all together explain {:.0f} % of its turning, "
        "expected {:.0f} % at least. Record a log in which every command moves on its own, and "
        "check that columns and times are right",
        segment_name(i), 100.0 * fit.all.explained[i], 100.0 * kMinExplained));
  }
  shares /= shares.lpNorm<1>();
  for (double& share : shares) {
    share = number_in(fmt::format("{:.3g}", share)).value_or(share);  // as good as they are known
  }
  return shares;
}

/// The arm with the shares found, for its own words.
ArmDescription with_shares(ArmDescription arm, const CommandShares& shares) {
  arm.commands = shares.commands;
  return arm;
}

/// The lines of an arm file that say so, the last with its line break.
std::string commands_block(const ArmDescription& arm) {
  const std::string keys = arm_keys_to_yaml(arm);
  return keys.substr(keys.find("\ncommands:\n") + 1);
}

}  // namespace

CommandShares find_command_shares(const std::vector<fs::path>& logs, const fs::path& mapping,
                                  const ArmDescription& arm) {
  const std::vector<std::string> names = own_commands(mapping);
  const ArmDescription asked = with_commands(arm, names);
  const LevelTable levels = levels_in(logs, read_import_mapping(mapping, asked), asked);
  if (levels.row_count() < 2 * kPieces) {
    throw InputError(fmt::format(
        "{}{}: {:.1f} s in which everything was logged; expected {:.0f} s at least",
        logs.front().string(), logs.size() > 1 ? fmt::format(" and {} more", logs.size() - 1) : "",
        kPeriod_s * double(levels.row_count()), kPeriod_s * 2.0 * double(kPieces)));
  }
  const LaggedRegression fit = regress_levels(levels);
  CommandShares found;
  found.lag_s = fit.lag_s;
  Eigen::MatrixXd shares(arm.segment_count(), Eigen::Index(names.size()));
  for (int i = 0; i < arm.segment_count(); ++i) {
    shares.row(i) = shares_of_segment(fit, arm, i);
    found.explained.push_back(fit.all.explained[i]);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto column = shares.col(Eigen::Index(k));
    if (column.isZero(0.0)) {
      found.idle.push_back(names[k]);
    } else {
      found.commands.push_back({names[k], {column.begin(), column.end()}});
    }
    for (std::size_t other = 0; other < k; ++other) {
      if (std::abs(fit.all.correlation(Eigen::Index(other), Eigen::Index(k))) > kAlike) {
        found.alike.emplace_back(names[other], names[k]);
      }
    }
  }
  // Refuses what an arm file would be refused for.
  (void)read_arm_keys(arm_keys_to_yaml(with_shares(arm, found)), "the shares found");
  return found;
}

Json to_json(const CommandShares& shares, const ArmDescription& arm) {
  Json json = {{"lag_s", shares.lag_s}, {"explained", shares.explained}};
  json["commands"] = Json::array();
  for (const ArmCommand& command : shares.commands) {
    json["commands"].push_back({{"name", command.name}, {"shares", command.shares}});
  }
  json["idle"] = shares.idle;
  json["alike"] = shares.alike;
  json["yaml"] = commands_block(with_shares(arm, shares));
  return json;
}

std::string to_text(const CommandShares& shares, const ArmDescription& arm) {
  const ArmDescription found = with_shares(arm, shares);
  std::string text = fmt::format("the arm follows its commands by {:.1f} s\n", shares.lag_s);
  for (int i = 0; i < arm.segment_count(); ++i) {
    text += fmt::format("{} = {}, which explains {:.0f} % of its turning\n", segment_name(i),
                        command_sum(found, i), 100.0 * shares.explained[std::size_t(i)]);
  }
  for (const auto& [one, other] : shares.alike) {
    text += fmt::format(
        "{} and {} never moved apart from each other: what both do is split evenly\n", one, other);
  }
  if (!shares.idle.empty()) {
    text += fmt::format("{}: no segment follows; left out, so leave it out of the mapping too\n",
                        fmt::join(shares.idle, ", "));
  }
  text += "for the arm file; limits of segments are then those of one command:\n\n" +
          commands_block(found);
  text.pop_back();  // its last line break
  return text;
}

}  // namespace limber
