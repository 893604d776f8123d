#include "valve_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"

namespace limber {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kFastestS = 1e-4;  // a time constant below it can't be distinguished from none
constexpr double kSlowestS = 50.0;

/// Parameters as the optimiser sees them: the dead time in frames, logarithms of all others, so
/// that a step of 1 means something in each.
struct Coordinates {
  double rate_hz = 20.0;
  double limit_kpa = 100.0;
  bool limits_inflating = true;  ///< whether each direction's rate is limited
  bool limits_venting = true;

  static constexpr int kCount = 6;
  static constexpr double kFirstBand = 2e-3;  // of the limit
  static constexpr double kMinBand = 1e-4;    // of the limit: none

  SegmentValves valves(const Eigen::VectorXd& x) const {
    const auto time = [](double v) { return std::clamp(std::exp(v), kFastestS, kSlowestS); };
    SegmentValves result;
    result.inflating = {time(x[0]), limits_inflating ? limit_kpa * std::exp(x[2]) : kNoLimit};
    result.venting = {time(x[1]), limits_venting ? limit_kpa * std::exp(x[3]) : kNoLimit};
    result.dead_time_s = std::clamp(x[4] / rate_hz, 0.0, kLongestDeadTimeS);
    result.dead_band_kpa = x[5] < std::log(kMinBand) ? 0.0 : limit_kpa * std::exp(x[5]);
    return result;
  }
  Eigen::VectorXd of(const SegmentValves& valves) const {
    const auto rate = [&](double v) { return std::isfinite(v) ? std::log(v / limit_kpa) : 0.0; };
    Eigen::VectorXd x(kCount);
    x << std::log(std::max(valves.inflating.time_constant_s, kFastestS)),
        std::log(std::max(valves.venting.time_constant_s, kFastestS)),
        rate(valves.inflating.rate_limit_kpa_per_s), rate(valves.venting.rate_limit_kpa_per_s),
        valves.dead_time_s * rate_hz,
        std::log(std::max(valves.dead_band_kpa / limit_kpa, kMinBand));
    return x;
  }
};

/// Output errors of runs, each bent so that its square is the Cauchy loss of the error, ln(1 + r²)
/// of r = error / scale_kpa: quadratic below the scale, nearly flat far above it.
struct OutputErrors {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const std::vector<ValveRun>* runs;
  bool has_sides;
  Coordinates coordinates;
  double scale_kpa;
  int count;

  int inputs() const { return Coordinates::kCount; }
  int values() const { return count; }

  double bent(double error) const {
    const double ratio = error / scale_kpa;
    return std::copysign(std::sqrt(std::log1p(ratio * ratio)), error);
  }

  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residual) const {
    const ValveMotion motion(coordinates.valves(x), has_sides, 1.0 / coordinates.rate_hz);
    std::vector<double> pressure;
    Eigen::Index at = 0;
    for (const ValveRun& run : *runs) {
      simulate(motion, run, pressure);
      for (int k = 1; k < run.count; ++k) {
        residual[at++] = bent(pressure[std::size_t(k)] - run.measured(run.first + k));
      }
    }
    return 0;
  }
};

int error_count(const std::vector<ValveRun>& runs) {
  return sum_of<int>(runs, [&](const ValveRun& run) { return run.count - 1; });
}

class Fitter {
 public:
  Fitter(const std::vector<ValveRun>& runs, bool has_sides, double rate_hz, double limit_kpa)
      : errors_{
            &runs, has_sides, {rate_hz, limit_kpa}, kFirstScale * limit_kpa, error_count(runs)} {}

  double loss(const Eigen::VectorXd& x) const {
    Eigen::VectorXd residual(errors_.count);
    errors_(x, residual);
    return residual.squaredNorm() / errors_.count;
  }

  /// Levenberg–Marquardt with finite differences.
  Eigen::VectorXd optimise(Eigen::VectorXd x, int max_evaluations) const {
    constexpr double kStepSquared = 1e-10;  // relative steps of 1e-5: far above rounding
    Eigen::NumericalDiff<OutputErrors> function(errors_, kStepSquared);
    Eigen::LevenbergMarquardt<Eigen::NumericalDiff<OutputErrors>> search(function);
    search.parameters.maxfev = max_evaluations;
    search.parameters.ftol = kConverged;
    search.parameters.xtol = kConverged;
    search.minimize(x);
    // Beyond a bound nothing changes any more: a later search begins on it.
    return errors_.coordinates.of(errors_.coordinates.valves(x));
  }

  /// The scale becomes three typical errors at `x` of frames in motion, so that spikes don't
  /// decide, and long holds don't say what is typical.
  void rescale(const Eigen::VectorXd& x) {
    constexpr double kTypicalErrors = 3.0;
    constexpr double kMin = 5e-4;       // of the limit: finer than any sensor
    constexpr double kUnderWay = 0.02;  // of the limit, from the set point
    const ValveMotion motion(errors_.coordinates.valves(x), errors_.has_sides,
                             1.0 / errors_.coordinates.rate_hz);
    std::vector<double> sizes;
    std::vector<double> pressure;
    for (const ValveRun& run : *errors_.runs) {
      simulate(motion, run, pressure);
      for (int k = 1; k < run.count; ++k) {
        const double measured = run.measured(run.first + k);
        if (std::abs(run.setpoint(run.first + k) - measured) >
            kUnderWay * errors_.coordinates.limit_kpa) {
          sizes.push_back(std::abs(pressure[std::size_t(k)] - measured));
        }
      }
    }
    if (sizes.empty()) {
      return;
    }
    errors_.scale_kpa = std::max(kTypicalErrors * kScaleOfMedian * median(std::move(sizes)),
                                 kMin * errors_.coordinates.limit_kpa);
  }

  Coordinates& coordinates() { return errors_.coordinates; }

 private:
  static constexpr double kFirstScale = 0.05;  // of the limit
  static constexpr double kConverged = 1e-7;
  OutputErrors errors_;
};

/// The fastest that pressures moved, but for spikes and noise: of the frame-to-frame changes over
/// `kSpan` frames the 99th percentile.
double fastest_kpa_per_s(const std::vector<ValveRun>& runs, double rate_hz, double limit_kpa) {
  constexpr int kSpan = 2;
  constexpr double kHigh = 0.99;
  constexpr double kMoving = 0.005;  // of the limit
  std::vector<double> speeds;
  for (const ValveRun& run : runs) {
    for (int k = run.first + kSpan; k < run.first + run.count; ++k) {
      const double change = std::abs(run.measured(k) - run.measured(k - kSpan));
      if (change > kMoving * limit_kpa) {
        speeds.push_back(change * rate_hz / kSpan);
      }
    }
  }
  return speeds.empty() ? limit_kpa : quantile(std::move(speeds), kHigh);
}

/// The first so many frames' worth of runs, evenly picked: for the coarse search.
std::vector<ValveRun> thinned(const std::vector<ValveRun>& runs, int max_frames) {
  const int step = 1 + error_count(runs) / max_frames;
  std::vector<ValveRun> chosen;
  for (std::size_t i = 0; i < runs.size(); i += std::size_t(step)) {
    chosen.push_back(runs[i]);
  }
  return chosen;
}

/// Best points of a grid over time constant, rate limit and dead time, each improved a little.
SegmentValves coarse_fit(const std::vector<ValveRun>& runs, bool has_sides, double rate_hz,
                         double limit_kpa) {
  constexpr double kTimesS[] = {0.01, 0.03, 0.08, 0.2, 0.5, 1.2};
  constexpr double kDeadTimesS[] = {0.0, 0.01, 0.025, 0.05, 0.075, 0.1, 0.15,
                                    0.2, 0.25, 0.3,   0.4,  0.5,   0.7, 1.0};
  constexpr std::size_t kStarts = 3;
  constexpr int kEvaluations = 60;
  const double fastest = fastest_kpa_per_s(runs, rate_hz, limit_kpa);
  const Fitter fitter(runs, has_sides, rate_hz, limit_kpa);
  const Coordinates coordinates{rate_hz, limit_kpa};
  const double first_band = Coordinates::kFirstBand * limit_kpa;
  std::vector<std::pair<double, Eigen::VectorXd>> starts;
  for (const double time_s : kTimesS) {
    for (const double dead_time_s : kDeadTimesS) {
      for (const double rate : {0.6 * fastest, fastest, 10.0 * fastest}) {
        const Eigen::VectorXd x =
            coordinates.of({{time_s, rate}, {time_s, rate}, dead_time_s, first_band});
        starts.emplace_back(fitter.loss(x), x);
      }
    }
  }
  std::ranges::stable_sort(starts, {}, [](const auto& start) { return start.first; });
  starts.resize(kStarts);
  for (auto& [loss, x] : starts) {
    x = fitter.optimise(x, kEvaluations);
    loss = fitter.loss(x);
  }
  return coordinates.valves(
      std::ranges::min_element(starts, {}, [](const auto& start) { return start.first; })->second);
}

/// Removes a direction's rate limit if the data say nothing about it.
void drop_idle_limits(Fitter& fitter, Eigen::VectorXd& x) {
  constexpr double kAsGood = 1.01;   // of the loss
  constexpr double kNothing = 1e-4;  // a hundredth of the errors that count as small
  constexpr int kEvaluations = 60;
  for (bool Coordinates::*limits : {&Coordinates::limits_inflating, &Coordinates::limits_venting}) {
    const double loss = fitter.loss(x);
    fitter.coordinates().*limits = false;
    const Eigen::VectorXd without = fitter.optimise(x, kEvaluations);
    if (fitter.loss(without) <= kAsGood * loss + kNothing) {
      x = without;
    } else {
      fitter.coordinates().*limits = true;
    }
  }
}

/// Numbers without meaningless digits, so that files and lines stay readable.
SegmentValves rounded(SegmentValves valves) {
  const auto to = [](double unit, double value) { return std::round(value / unit) * unit; };
  constexpr double kPerSecond = 1e5;
  const auto time = [](double value) { return std::round(value * kPerSecond) / kPerSecond; };
  const auto digits = [&](double value) {
    if (!std::isfinite(value) || value <= 0.0) {
      return value;
    }
    constexpr double kDigits = 5.0;
    return to(std::pow(10.0, std::floor(std::log10(value)) - kDigits + 1.0), value);
  };
  for (ValveDirection* direction : {&valves.inflating, &valves.venting}) {
    direction->time_constant_s = time(direction->time_constant_s);
    direction->rate_limit_kpa_per_s = digits(direction->rate_limit_kpa_per_s);
  }
  valves.dead_time_s = time(valves.dead_time_s);
  valves.dead_band_kpa = digits(valves.dead_band_kpa);
  return valves;
}

}  // namespace

SegmentValves fit_valves(const std::vector<ValveRun>& runs, bool has_sides, double rate_hz,
                         double limit_kpa) {
  constexpr int kCoarseFrames = 5000;
  constexpr int kRounds = 2;
  constexpr int kEvaluations = 150;
  Fitter fitter(runs, has_sides, rate_hz, limit_kpa);
  Eigen::VectorXd x = fitter.coordinates().of(
      coarse_fit(thinned(runs, kCoarseFrames), has_sides, rate_hz, limit_kpa));
  for (int round = 0; round < kRounds; ++round) {
    fitter.rescale(x);
    x = fitter.optimise(x, kEvaluations);
  }
  drop_idle_limits(fitter, x);
  return rounded(fitter.coordinates().valves(x));
}

}  // namespace limber
