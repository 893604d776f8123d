#include "level_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <unsupported/Eigen/FFT>

#include "limber/arm/no_load_model.hpp"
#include "limber/arm/space_no_load.hpp"

namespace limber {

namespace {

constexpr int kBends = 2;  // of a segment in space, about y and z
constexpr double kTimeRounding_s = 1e-6;
constexpr double kMinTurn_rad = 0.02;  // standard deviation; markers 50 mm apart see 0.01 in noise
constexpr double kMinChange = 0.02;    // of the limit, from lowest to highest
constexpr double kForgotten = 0.05;    // of an autocorrelation; what follows is noise
constexpr double kMaxExplained = 0.9999;  // of a variance: a model's own copy is no more than that
constexpr double kFreeNumbers = 3.0;      // slope, offset and one for the width of r

/// Without the mean over all runs.
Eigen::MatrixXd centred(const Eigen::MatrixXd& values) {
  return values.rowwise() - values.colwise().mean();
}

/// Autocorrelation of a column whose runs don't go on into each other, from 1 at lag 0.
Eigen::VectorXd autocorrelation(const Eigen::VectorXd& values,
                                const std::vector<Eigen::Index>& run_ends) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.size());
  Eigen::Index begin = 0;
  for (const Eigen::Index end : run_ends) {
    if (const Eigen::Index count = end - begin; count > 0) {
      const Eigen::VectorXd run = values.segment(begin, count);
      sum.head(count) += cross_correlation(run, run).tail(count);
    }
    begin = end;
  }
  return sum.size() > 0 && sum[0] > 0.0 ? Eigen::VectorXd(sum / sum[0]) : sum;
}

/// Bartlett: two series are as good as T / (1 + 2 Σ ρ_a ρ_b) independent pairs.
double independent_rows(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double sum = 1.0;
  for (Eigen::Index lag = 1; lag < a.size() && a[lag] > kForgotten && b[lag] > kForgotten; ++lag) {
    sum += 2.0 * a[lag] * b[lag];
  }
  return double(a.size()) / sum;
}

/// Bends of every segment, T×2s; NaN where a row is not known.
/// @param shapes_of  a row's shapes, 3s
template <class ShapesOf>
Eigen::MatrixXd bends_where_known(const ArmDescription& arm, const Eigen::MatrixXd& rows,
                                  const ShapesOf& shapes_of) {
  Eigen::MatrixXd bends =
      Eigen::MatrixXd::Constant(rows.rows(), kBends * arm.segment_count(), std::nan(""));
  for (Eigen::Index t = 0; t < rows.rows(); ++t) {
    if (rows.row(t).allFinite()) {
      const Eigen::VectorXd shapes = shapes_of(rows.row(t).transpose());
      bends.row(t) =
          shapes.reshaped(kShapeRows, arm.segment_count()).topRows<kBends>().reshaped().transpose();
    }
  }
  return bends;
}

}  // namespace

double Turns::at(double asked_s, Eigen::Index column) const {
  if (std::abs(asked_s - time_s.front()) < kTimeRounding_s) {
    return values(0, column);
  }
  if (std::abs(asked_s - time_s.back()) < kTimeRounding_s) {
    return values(values.rows() - 1, column);
  }
  const auto after = std::upper_bound(time_s.begin(), time_s.end(), asked_s);
  if (after == time_s.begin() || after == time_s.end()) {
    return std::nan("");
  }
  const auto b = Eigen::Index(after - time_s.begin());
  if (held) {
    return values(b - 1, column);
  }
  const double from = time_s[std::size_t(b - 1)];
  const double part = (asked_s - from) / (time_s[std::size_t(b)] - from);
  return values(b - 1, column) + part * (values(b, column) - values(b - 1, column));
}

Turns turns_of(const BackboneTrack& motion, const ArmDescription& arm) {
  if (arm.is_spatial()) {
    return {motion.time_s, bends_where_known(arm, motion.poses, [&](const Eigen::VectorXd& poses) {
              return shapes_of_poses(arm, poses);
            })};
  }
  Turns turns{motion.time_s, Eigen::MatrixXd(motion.row_count(), arm.segment_count())};
  int plate = 0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    const int end = plate + arm.segments[std::size_t(i)].gaps;
    turns.values.col(i) =
        motion.poses.col(kPoseSize * end + 2) - motion.poses.col(kPoseSize * plate + 2);
    plate = end;
  }
  return turns;
}

Turns turns_of(const CommandTrack& commands, const ArmDescription& arm) {
  Turns turns{commands.time_s, commands.values, !commands.measured};
  if (arm.no_load == NoLoadKind::straight) {
    return turns;
  }
  if (arm.is_spatial()) {
    const SpaceNoLoad model(arm);
    turns.values = bends_where_known(arm, commands.values, [&](const Eigen::VectorXd& command) {
      return Eigen::VectorXd(model.shape_of_strains() * model.strains(command));
    });
    return turns;
  }
  const NoLoadModel model(arm);
  for (int i = 0; i < arm.segment_count(); ++i) {
    for (Eigen::Index t = 0; t < turns.values.rows(); ++t) {
      const SegmentShape shape = model.segment_shape(i, turns.values(t, i));
      turns.values(t, i) =
          std::isfinite(turns.values(t, i)) ? shape.curvature_per_m * shape.length_m : std::nan("");
    }
  }
  return turns;
}

LevelTable levels_of(const BackboneTrack& motion, const CommandTrack& commands,
                     const ArmDescription& arm) {
  const Turns seen = turns_of(motion, arm);
  const Turns told{commands.time_s, commands.values, !commands.measured};
  const double start_s = std::max(motion.time_s.front(), commands.time_s.front());
  const double end_s = std::min(motion.time_s.back(), commands.time_s.back());
  const auto max_rows = Eigen::Index(std::max(0.0, end_s - start_s) * kLevelRate_hz) + 1;
  const Eigen::Index n = arm.segment_count();
  const Eigen::Index columns = commands.values.cols();
  LevelTable levels{Eigen::MatrixXd(max_rows, n), Eigen::MatrixXd(max_rows, columns), {}};
  Eigen::Index rows = 0;
  for (Eigen::Index k = 0; k < max_rows; ++k) {
    const double time_s = start_s + double(k) / kLevelRate_hz;
    for (Eigen::Index i = 0; i < n; ++i) {
      levels.turn_rad(rows, i) = seen.at(time_s, i);
    }
    for (Eigen::Index j = 0; j < columns; ++j) {
      levels.command(rows, j) = told.at(time_s, j);
    }
    const bool known =
        levels.turn_rad.row(rows).allFinite() && levels.command.row(rows).allFinite();
    rows += known ? 1 : 0;
  }
  levels.turn_rad.conservativeResize(rows, n);
  levels.command.conservativeResize(rows, columns);
  levels.run_ends = {rows};
  return levels;
}

void append(LevelTable& levels, const LevelTable& more) {
  const Eigen::Index before = levels.row_count();
  levels.turn_rad.conservativeResize(before + more.row_count(), more.turn_rad.cols());
  levels.command.conservativeResize(before + more.row_count(), more.command.cols());
  levels.turn_rad.bottomRows(more.row_count()) = more.turn_rad;
  levels.command.bottomRows(more.row_count()) = more.command;
  for (const Eigen::Index end : more.run_ends) {
    levels.run_ends.push_back(before + end);
  }
}

Eigen::VectorXd cross_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  Eigen::Index size = 1;
  while (size < a.size() + b.size()) {
    size *= 2;
  }
  const auto transform = [&](const Eigen::VectorXd& values) {
    std::vector<double> padded(size, 0.0);
    std::copy(values.begin(), values.end(), padded.begin());
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double>().fwd(spectrum, padded);
    return spectrum;
  };
  std::vector<std::complex<double>> product = transform(a);
  const std::vector<std::complex<double>> other = transform(b);
  for (std::size_t k = 0; k < product.size(); ++k) {
    product[k] *= std::conj(other[k]);
  }
  std::vector<double> circular;
  Eigen::FFT<double>().inv(circular, product);
  Eigen::VectorXd result(a.size() + b.size() - 1);
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    const Eigen::Index shift = k - (b.size() - 1);
    result[k] = circular[std::size_t((shift + size) % size)];
  }
  return result;
}

LevelCorrelations correlate_levels(const LevelTable& levels, const ArmDescription& arm) {
  const Eigen::Index n = arm.segment_count();
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  const std::vector<bool> nowhere(n, false);
  LevelCorrelations result{none, none, none, nowhere, nowhere};
  if (levels.row_count() == 0) {
    return result;
  }
  const Eigen::MatrixXd turn = centred(levels.turn_rad);
  const Eigen::MatrixXd command = centred(levels.command);
  std::vector<Eigen::VectorXd> turn_memory;
  std::vector<Eigen::VectorXd> command_memory;
  for (Eigen::Index i = 0; i < n; ++i) {
    result.turned[i] = turn.col(i).norm() > kMinTurn_rad * std::sqrt(double(turn.rows()));
    result.changed[i] = command.col(i).maxCoeff() - command.col(i).minCoeff() >
                        kMinChange * arm.segments[i].pressure_limit_kpa.half_width_kpa();
    turn_memory.push_back(autocorrelation(turn.col(i), levels.run_ends));
    command_memory.push_back(autocorrelation(command.col(i), levels.run_ends));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (!result.turned[std::size_t(i)] || !result.changed[std::size_t(j)]) {
        continue;
      }
      const double r =
          turn.col(i).dot(command.col(j)) / (turn.col(i).norm() * command.col(j).norm());
      const double rows =
          independent_rows(turn_memory[std::size_t(i)], command_memory[std::size_t(j)]);
      result.correlation(i, j) = r;
      result.independent_rows(i, j) = rows;
      result.evidence(i, j) = -0.5 * std::max(rows - kFreeNumbers, 0.0) *
                              std::log(1.0 - std::min(r * r, kMaxExplained));
    }
  }
  return result;
}

}  // namespace limber
