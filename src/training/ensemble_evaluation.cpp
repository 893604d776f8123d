#include "limber/training/ensemble_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr double kCovered = 0.95;

/// Ranks from 0, ties sharing their mean.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> result(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) {
      ++end;
    }
    for (std::size_t i = first; i < end; ++i) {
      result[order[i]] = 0.5 * double(first + end - 1);
    }
    first = end;
  }
  return result;
}

SpreadStatistics spread_statistics(const std::vector<double>& spread_cm,
                                   const std::vector<double>& error_cm) {
  SpreadStatistics result;
  if (spread_cm.empty()) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone, kNone, kNone};
  }
  const auto count = double(spread_cm.size());
  result.mean_cm = mean(spread_cm);
  std::vector<double> factors;
  for (std::size_t i = 0; i < spread_cm.size(); ++i) {
    result.covered_by_two += error_cm[i] <= 2.0 * spread_cm[i] ? 1.0 / count : 0.0;
    factors.push_back(error_cm[i] / std::max(spread_cm[i], std::numeric_limits<double>::min()));
  }
  result.rank_correlation = rank_correlation(spread_cm, error_cm);
  result.factor_for_95 = quantile(std::move(factors), kCovered);
  return result;
}

EnsembleErrors errors_of(const EnsembleForward& ensemble, const std::vector<Episode>& episodes,
                         Restart restart, int jobs) {
  auto members = mapped<std::vector<FrameMatrix>>(ensemble.member_count(), [&](int member) {
    return predict(ensemble.member(member), episodes, restart, jobs);
  });
  const std::vector<FrameMatrix> mean = mean_of(members, ensemble.member(0).dimension());
  TipErrorSeries series;
  std::vector<double> spread_cm;
  std::vector<double> error_cm;
  for (std::size_t episode = 0; episode < episodes.size(); ++episode) {
    const TipErrorSeries one = tip_errors(mean[episode], episodes[episode]);
    append(series, one);
    const Dimension dimension = episodes[episode].dimension;
    for (std::size_t i = 0; i < one.position_cm.size(); ++i) {
      if (std::isnan(one.position_cm[i])) {
        continue;
      }
      const auto t = Eigen::Index(i) + 1;
      const auto square = sum_of<double>(members, [&](const std::vector<FrameMatrix>& member) {
        return double(
            (tip_place(member[episode], t, dimension) - tip_place(mean[episode], t, dimension))
                .squaredNorm());
      });
      spread_cm.push_back(kCmPerM * std::sqrt(square / double(members.size())));
      error_cm.push_back(one.position_cm[i]);
    }
  }
  return {summarise(series), spread_statistics(spread_cm, error_cm)};
}

}  // namespace

EnsembleEvaluation evaluate_ensemble(const EnsembleForward& ensemble,
                                     const std::vector<Episode>& episodes, int jobs) {
  const auto errors = [&](Restart restart) { return errors_of(ensemble, episodes, restart, jobs); };
  return {ensemble.member_count(), errors(Restart::every_frame), errors(Restart::every_32_frames),
          errors(Restart::every_motion), errors(Restart::at_the_start_only)};
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> of_a = ranks(a);
  const std::vector<double> of_b = ranks(b);
  const double mean = 0.5 * (double(a.size()) - 1.0);
  double product = 0.0;
  double square_a = 0.0;
  double square_b = 0.0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    product += (of_a[i] - mean) * (of_b[i] - mean);
    square_a += (of_a[i] - mean) * (of_a[i] - mean);
    square_b += (of_b[i] - mean) * (of_b[i] - mean);
  }
  return square_a > 0.0 && square_b > 0.0 ? product / std::sqrt(square_a * square_b)
                                          : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace limber
