#include "clock_match.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <unsupported/Eigen/FFT>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

constexpr double kRate_hz = 100.0;
constexpr double kRounding_s = 1e-6;
constexpr double kDifference_s = 0.1;
constexpr double kMinOverlap = 0.5;
constexpr double kMinOverlap_s = 5.0;
constexpr double kPeakWidth_s = 1.0;
constexpr double kPeakHalfWidth_s = 0.5;
constexpr double kTypicalLag_s = 0.1;  // of each stage; limber's virtual arms have 0.08 to 0.13
constexpr double kLongestLag_s = 0.4;
constexpr double kLagStep_s = 0.02;
constexpr double kClearlyBetter = 1e-4;  // of correlations

/// How fast each segment turns, on an even grid: one column per segment, zero where unknown.
struct TurnRates {
  double start_s = 0.0;
  Eigen::MatrixXd values;
};

/// A log's turns at its own times, on its own clock.
struct Turns {
  const std::vector<double>& time_s;
  Eigen::MatrixXd values;  // T×n, NaN if unknown
};

TurnRates rates_of(const Turns& turns, double start_s, Eigen::Index count) {
  TurnRates rates{start_s, Eigen::MatrixXd::Zero(count, turns.values.cols())};
  const auto sample = [&](double time_s, Eigen::Index column) {
    if (std::abs(time_s - turns.time_s.front()) < kRounding_s) {
      return turns.values(0, column);
    }
    if (std::abs(time_s - turns.time_s.back()) < kRounding_s) {
      return turns.values(turns.values.rows() - 1, column);
    }
    const auto after = std::upper_bound(turns.time_s.begin(), turns.time_s.end(), time_s);
    if (after == turns.time_s.begin() || after == turns.time_s.end()) {
      return std::nan("");
    }
    const auto b = static_cast<Eigen::Index>(after - turns.time_s.begin());
    const double from = turns.time_s[std::size_t(b - 1)];
    const double part = (time_s - from) / (turns.time_s[std::size_t(b)] - from);
    return turns.values(b - 1, column) +
           part * (turns.values(b, column) - turns.values(b - 1, column));
  };
  for (Eigen::Index k = 0; k < count; ++k) {
    const double time_s = start_s + double(k) / kRate_hz;
    for (Eigen::Index i = 0; i < turns.values.cols(); ++i) {
      const double change =
          sample(time_s + 0.5 * kDifference_s, i) - sample(time_s - 0.5 * kDifference_s, i);
      rates.values(k, i) = std::isfinite(change) ? change : 0.0;
    }
  }
  return rates;
}

TurnRates whole(const Turns& turns) {
  // From the first difference that the log has to its last.
  const double start_s = turns.time_s.front() + 0.5 * kDifference_s;
  const double length_s = turns.time_s.back() - 0.5 * kDifference_s - start_s;
  const auto count = static_cast<Eigen::Index>(std::max(0.0, length_s) * kRate_hz) + 1;
  return rates_of(turns, start_s, count);
}

Turns turns_of(const BackboneTrack& motion, const ArmDescription& arm) {
  Turns turns{motion.time_s, Eigen::MatrixXd(motion.row_count(), arm.segment_count())};
  int plate = 0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    const int end = plate + arm.segments[std::size_t(i)].gaps;
    turns.values.col(i) = motion.poses.col(3 * end + 2) - motion.poses.col(3 * plate + 2);
    plate = end;
  }
  return turns;
}

Turns turns_of(const CommandTrack& commands, const ArmDescription& arm) {
  Turns turns{commands.time_s, commands.measured};
  if (arm.no_load == NoLoadKind::straight) {
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

/// The turns of an arm that follows late: two lags of first order, one after the other, exact for
/// turns on straight lines between their times.
Turns lagging(const Turns& turns, double lag_s) {
  Turns late = turns;
  for (int stage = 0; lag_s > 0.0 && stage < 2; ++stage) {
    for (Eigen::Index i = 0; i < late.values.cols(); ++i) {
      double before = std::nan("");  // what the stage follows, and where it is
      double state = std::nan("");
      for (Eigen::Index t = 0; t < late.values.rows(); ++t) {
        const double value = late.values(t, i);
        if (!std::isfinite(value)) {
          continue;
        }
        if (std::isfinite(state)) {
          const double steps =
              (turns.time_s[std::size_t(t)] - turns.time_s[std::size_t(t - 1)]) / lag_s;
          const double slope = (value - before) / steps;
          state = value - slope + (state - before + slope) * std::exp(-steps);
        } else {
          state = value;
        }
        before = value;
        late.values(t, i) = state;
      }
    }
  }
  return late;
}

/// Σ_t a(t) b(t − s) for every shift s from 1 − |b| to |a| − 1, at index s + |b| − 1.
Eigen::VectorXd correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  Eigen::Index size = 1;
  while (size < a.size() + b.size()) {
    size *= 2;
  }
  const auto transform = [&](const Eigen::VectorXd& values) {
    std::vector<double> padded(std::size_t(size), 0.0);
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

/// Σ of the first k rows' squares, k = 0 … rows.
std::vector<double> energy_before(const Eigen::MatrixXd& values) {
  std::vector<double> sums = {0.0};
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    sums.push_back(sums.back() + values.row(k).squaredNorm());
  }
  return sums;
}

/// Normalised correlation at every shift; NaN if the overlap is too short.
Eigen::VectorXd normalised_correlation(const TurnRates& a, const TurnRates& b, bool signed_turns) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(a.values.rows() + b.values.rows() - 1);
  for (Eigen::Index i = 0; i < a.values.cols(); ++i) {
    const Eigen::VectorXd own = correlation(a.values.col(i), b.values.col(i));
    sum += signed_turns ? own : Eigen::VectorXd(own.cwiseAbs());
  }
  const std::vector<double> a_energy = energy_before(a.values);
  const std::vector<double> b_energy = energy_before(b.values);
  const Eigen::Index shorter = std::min(a.values.rows(), b.values.rows());
  const auto least = std::min<Eigen::Index>(
      shorter,
      static_cast<Eigen::Index>(std::max(kMinOverlap_s * kRate_hz, kMinOverlap * double(shorter))));
  for (Eigen::Index k = 0; k < sum.size(); ++k) {
    const Eigen::Index shift = k - (b.values.rows() - 1);
    const Eigen::Index begin = std::max<Eigen::Index>(0, shift);
    const Eigen::Index end = std::min(a.values.rows(), b.values.rows() + shift);
    const double energy =
        (a_energy[std::size_t(end)] - a_energy[std::size_t(begin)]) *
        (b_energy[std::size_t(end - shift)] - b_energy[std::size_t(begin - shift)]);
    sum[k] = end - begin < least || energy <= 0.0 ? std::nan("") : sum[k] / std::sqrt(energy);
  }
  return sum;
}

struct Peak {
  double value = -1.0;
  double shift = 0.0;  // in steps of the grid
};

/// The largest normalised correlation at most kPeakHalfWidth_s away from a shift.
Peak peak_near(Eigen::Index around, const TurnRates& a, const TurnRates& b, bool signed_turns) {
  const auto half = static_cast<Eigen::Index>(kPeakHalfWidth_s * kRate_hz);
  std::vector<double> values;
  for (Eigen::Index shift = around - half; shift <= around + half; ++shift) {
    const Eigen::Index begin = std::max<Eigen::Index>(0, shift);
    const Eigen::Index count = std::min(a.values.rows(), b.values.rows() + shift) - begin;
    double sum = 0.0;
    double energy = 0.0;
    if (count > 0) {
      const auto x = a.values.middleRows(begin, count);
      const auto y = b.values.middleRows(begin - shift, count);
      const Eigen::RowVectorXd products = x.cwiseProduct(y).colwise().sum();
      sum = signed_turns ? products.sum() : products.cwiseAbs().sum();
      energy = x.squaredNorm() * y.squaredNorm();
    }
    values.push_back(energy > 0.0 ? sum / std::sqrt(energy) : -1.0);
  }
  const auto best = std::max_element(values.begin(), values.end()) - values.begin();
  Peak peak{values[std::size_t(best)], double(around - half + best)};
  if (best > 0 && best + 1 < std::ssize(values)) {
    const double before = values[std::size_t(best - 1)];
    const double after = values[std::size_t(best + 1)];
    const double bend = before - 2.0 * peak.value + after;
    peak.shift += bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
  }
  return peak;
}

}  // namespace

ClockMatch match_clocks(const BackboneTrack& motion, const CommandTrack& commands,
                        const ArmDescription& arm) {
  const TurnRates seen = whole(turns_of(motion, arm));
  const Turns told = turns_of(commands, arm);
  const bool has_sign = arm.no_load != NoLoadKind::straight;
  const TurnRates typical = whole(lagging(told, kTypicalLag_s));
  const Eigen::VectorXd values = normalised_correlation(seen, typical, has_sign);
  ClockMatch match;
  Eigen::Index best = -1;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    if (!std::isnan(values[k])) {
      best = best < 0 || values[k] > values[best] ? k : best;
      match.opposite = std::min(match.opposite, values[k]);
    }
  }
  if (best < 0) {
    return match;
  }
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    if (double(std::abs(k - best)) > kPeakWidth_s * kRate_hz && !std::isnan(values[k])) {
      match.runner_up = std::max(match.runner_up, values[k]);
    }
  }
  const Eigen::Index around = best - (typical.values.rows() - 1);
  // Slow motions can't distinguish a lag from an offset: no more lag than the data need.
  for (int step = 0; step * kLagStep_s <= kLongestLag_s; ++step) {
    throw_if_interrupted();
    const double lag_s = step * kLagStep_s;
    const Peak peak = peak_near(around, seen, whole(lagging(told, lag_s)), has_sign);
    if (step == 0 || peak.value > match.correlation + kClearlyBetter) {
      match.correlation = peak.value;
      match.lag_s = lag_s;
      match.offset_s = seen.start_s - typical.start_s + peak.shift / kRate_hz;
    }
  }
  return match;
}

std::vector<double> segment_correlations(const BackboneTrack& motion, const CommandTrack& commands,
                                         const ArmDescription& arm, double offset_s) {
  const TurnRates seen = whole(turns_of(motion, arm));
  const TurnRates expected =
      rates_of(turns_of(commands, arm), seen.start_s - offset_s, seen.values.rows());
  std::vector<double> correlations;
  for (Eigen::Index i = 0; i < seen.values.cols(); ++i) {
    const double energy = seen.values.col(i).norm() * expected.values.col(i).norm();
    const double value =
        energy > 0.0 ? seen.values.col(i).dot(expected.values.col(i)) / energy : 0.0;
    correlations.push_back(arm.no_load == NoLoadKind::straight ? std::abs(value) : value);
  }
  return correlations;
}

}  // namespace limber
