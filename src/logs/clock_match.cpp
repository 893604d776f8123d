#include "clock_match.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "level_correlation.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

constexpr double kClockRate_hz = 100.0;
// Fast motions tell most over short times; slow ones drown there in noise.
constexpr std::array<double, 3> kDifferences_s = {0.1, 0.5, 2.0};
constexpr double kActivityDifference_s = 0.5;
constexpr double kMinOverlap = 0.5;
constexpr double kMinOverlap_s = 5.0;
constexpr double kPeakWidth_s = 1.0;
constexpr double kPeakWidths = 1.5;  // of the difference: differences are alike so far apart
constexpr double kPeakHalfWidth_s = 0.5;
constexpr double kTypicalLag_s = 0.1;  // of each stage; limber's virtual arms have 0.08 to 0.13
constexpr double kLongestLag_s = 0.4;
constexpr double kLagStep_s = 0.02;
constexpr double kClearlyBetter = 1e-4;  // of correlations
constexpr double kMinCorrelation = 0.3;  // below, the logs do not belong together
constexpr double kAmbiguous = 0.9;       // a runner-up this good could as well be the answer

/// How fast each segment turns, on an even grid: one column per segment, zero where unknown.
struct TurnRates {
  double start_s = 0.0;
  Eigen::MatrixXd values;
};

/// Changes over `difference_s` about each time, from the first that the log has to its last.
TurnRates rates_of(const Turns& turns, double difference_s) {
  const double start_s = turns.time_s.front() + 0.5 * difference_s;
  const double length_s = turns.time_s.back() - 0.5 * difference_s - start_s;
  const auto count = Eigen::Index(std::max(0.0, length_s) * kClockRate_hz) + 1;
  TurnRates rates{start_s, Eigen::MatrixXd::Zero(count, turns.values.cols())};
  for (Eigen::Index k = 0; k < count; ++k) {
    const double time_s = start_s + double(k) / kClockRate_hz;
    for (Eigen::Index i = 0; i < turns.values.cols(); ++i) {
      const double change =
          turns.at(time_s + 0.5 * difference_s, i) - turns.at(time_s - 0.5 * difference_s, i);
      rates.values(k, i) = std::isfinite(change) ? change : 0.0;
    }
  }
  return rates;
}

/// The same commands with rows at least at the clock's rate: set points that are logged where they
/// change alone say nothing of how an arm follows them in between.
CommandTrack in_short_steps(const CommandTrack& commands) {
  CommandTrack result;
  result.measured = commands.measured;
  std::vector<Eigen::Index> rows;
  for (std::size_t t = 0; t < commands.time_s.size(); ++t) {
    const double from_s = commands.time_s[t];
    const double to_s = t + 1 < commands.time_s.size() ? commands.time_s[t + 1] : from_s;
    double time_s = from_s;
    for (int step = 1; step == 1 || time_s < to_s; ++step) {
      result.time_s.push_back(time_s);
      rows.push_back(Eigen::Index(t));
      time_s = from_s + step / kClockRate_hz;
    }
  }
  result.values = commands.values(rows, Eigen::all);
  return result;
}

/// One lag of first order, exact for turns on straight lines between their times, or held.
void lag_behind(const std::vector<double>& time_s, double lag_s, bool held,
                Eigen::Ref<Eigen::VectorXd> values) {
  Eigen::Index last = -1;  // row that is known
  double before = 0.0;     // what is followed there, and where it is
  double state = 0.0;
  for (Eigen::Index t = 0; t < values.size(); ++t) {
    const double value = values[t];
    if (!std::isfinite(value)) {
      continue;
    }
    if (last >= 0) {
      const double steps = (time_s[std::size_t(t)] - time_s[std::size_t(last)]) / lag_s;
      const double slope = held ? 0.0 : (value - before) / steps;
      const double target = held ? before : value;
      state = target - slope + (state - before + slope) * std::exp(-steps);
    } else {
      state = value;
    }
    last = t;
    before = value;
    values[t] = state;
  }
}

/// The turns of an arm that follows late: two lags, one after the other.
Turns lagging(const Turns& turns, double lag_s) {
  Turns late = turns;
  for (int stage = 0; lag_s > 0.0 && stage < 2; ++stage) {
    for (Eigen::Index i = 0; i < late.values.cols(); ++i) {
      lag_behind(turns.time_s, lag_s, late.held, late.values.col(i));
    }
    late.held = false;  // what follows moves evenly
  }
  return late;
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
    const Eigen::VectorXd own = cross_correlation(a.values.col(i), b.values.col(i));
    sum += signed_turns ? own : Eigen::VectorXd(own.cwiseAbs());
  }
  const std::vector<double> a_energy = energy_before(a.values);
  const std::vector<double> b_energy = energy_before(b.values);
  const Eigen::Index shorter = std::min(a.values.rows(), b.values.rows());
  const auto min_rows = std::min<Eigen::Index>(
      shorter,
      Eigen::Index(std::max(kMinOverlap_s * kClockRate_hz, kMinOverlap * double(shorter))));
  for (Eigen::Index k = 0; k < sum.size(); ++k) {
    const Eigen::Index shift = k - (b.values.rows() - 1);
    const Eigen::Index begin = std::max<Eigen::Index>(0, shift);
    const Eigen::Index end = std::min(a.values.rows(), b.values.rows() + shift);
    const double energy =
        (a_energy[std::size_t(end)] - a_energy[std::size_t(begin)]) *
        (b_energy[std::size_t(end - shift)] - b_energy[std::size_t(begin - shift)]);
    sum[k] = end - begin < min_rows || energy <= 0.0 ? std::nan("") : sum[k] / std::sqrt(energy);
  }
  return sum;
}

struct Peak {
  double value = -1.0;
  double shift = 0.0;  // in steps of the grid
};

/// The largest normalised correlation at most kPeakHalfWidth_s away from a shift.
Peak peak_near(Eigen::Index around, const TurnRates& a, const TurnRates& b, bool signed_turns) {
  const auto half = Eigen::Index(kPeakHalfWidth_s * kClockRate_hz);
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

/// What of two logs can be compared.
enum class Alike {
  turns,     // of each segment
  sizes,     // of each segment's turns: to which side is not known
  activity,  // in all: no column belongs to a segment
};

Alike alike_of(const ArmDescription& arm) {
  if (arm.no_load != NoLoadKind::straight) {
    return Alike::turns;
  }
  return arm.is_spatial() ? Alike::activity : Alike::sizes;
}

/// How much moves at all, whichever segment and to whichever side: one column.
TurnRates activity(const Turns& turns, double difference_s) {
  TurnRates rates = rates_of(turns, difference_s);
  for (Eigen::Index i = 0; i < rates.values.cols(); ++i) {
    const double size = rates.values.col(i).norm();
    rates.values.col(i) /= size > 0.0 ? size : 1.0;
  }
  Eigen::MatrixXd sum = rates.values.rowwise().norm();
  sum.array() -= sum.mean();
  return {rates.start_s, std::move(sum)};
}

/// How far the clocks are apart by changes over `difference_s`.
ClockMatch match_by(const Turns& turned, const Turns& told, Alike alike, double difference_s) {
  const bool has_sign = alike != Alike::sizes;
  const auto rates = [&](const Turns& turns) {
    return alike == Alike::activity ? activity(turns, difference_s) : rates_of(turns, difference_s);
  };
  const TurnRates seen = rates(turned);
  const TurnRates typical = rates(lagging(told, kTypicalLag_s));
  const Eigen::VectorXd values = normalised_correlation(seen, typical, has_sign);
  ClockMatch match;
  Eigen::Index best = -1;
  Eigen::Index opposite = 0;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    if (!std::isnan(values[k])) {
      best = best < 0 || values[k] > values[best] ? k : best;
      opposite = values[k] < match.opposite ? k : opposite;
      match.opposite = std::min(match.opposite, values[k]);
    }
  }
  if (best < 0) {
    return match;
  }
  const Eigen::Index no_shift = typical.values.rows() - 1;
  const auto offset_s = [&](double shift) {
    return seen.start_s - typical.start_s + shift / kClockRate_hz;
  };
  match.opposite_offset_s = offset_s(double(opposite - no_shift));
  const double peak_width_s = std::max(kPeakWidth_s, kPeakWidths * difference_s);
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    if (double(std::abs(k - best)) > peak_width_s * kClockRate_hz && !std::isnan(values[k])) {
      match.runner_up = std::max(match.runner_up, values[k]);
    }
  }
  // A lag and an offset look alike to slow motions: no more lag than the data ask for.
  for (int step = 0; step * kLagStep_s <= kLongestLag_s; ++step) {
    throw_if_interrupted();
    const double lag_s = step * kLagStep_s;
    const Peak peak = peak_near(best - no_shift, seen, rates(lagging(told, lag_s)), has_sign);
    if (step == 0 || peak.value > match.correlation + kClearlyBetter) {
      match.correlation = peak.value;
      match.lag_s = lag_s;
      match.offset_s = offset_s(peak.shift);
    }
  }
  return match;
}

}  // namespace

bool ClockMatch::is_decisive() const {
  return correlation >= kMinCorrelation && runner_up <= kAmbiguous * correlation &&
         -opposite <= correlation;
}

ClockMatch match_clocks(const BackboneTrack& motion, const CommandTrack& commands,
                        const ArmDescription& arm) {
  const Turns turned = turns_of(motion, arm);
  const CommandTrack in_steps = commands.measured ? CommandTrack() : in_short_steps(commands);
  const Turns told = turns_of(commands.measured ? commands : in_steps, arm);
  ClockMatch best;
  for (const double difference_s : kDifferences_s) {
    const ClockMatch match = match_by(turned, told, alike_of(arm), difference_s);
    if (match.is_decisive()) {
      return match;
    }
    if (match.correlation - match.runner_up > best.correlation - best.runner_up ||
        best.correlation <= 0.0) {
      best = match;
    }
  }
  return best;
}

double offset_by_activity(const BackboneTrack& motion, const CommandTrack& commands,
                          const ArmDescription& arm) {
  const TurnRates seen = activity(turns_of(motion, arm), kActivityDifference_s);
  const TurnRates told = activity(turns_of(commands, arm), kActivityDifference_s);
  const Eigen::VectorXd values = normalised_correlation(seen, told, true);
  Eigen::Index best = told.values.rows() - 1;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    best = !std::isnan(values[k]) && !(values[k] <= values[best]) ? k : best;
  }
  return seen.start_s - told.start_s + double(best - (told.values.rows() - 1)) / kClockRate_hz;
}

}  // namespace limber
