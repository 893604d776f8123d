#include "limber/training/run_errors.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr std::size_t kMinTubeRuns = 39;  // 95 % of fewer is their largest, or nearly so
// 95 % beside the median, of 127 plans on as many unseen arms of `wide` (docs/families.md): of the
// largest error on the way, of the tip's at the end, and of its heading's.
constexpr double kPathTail = 2.0;
constexpr double kEndTail = 2.6;
constexpr double kHeadingTail = 5.4;
constexpr int kParts = 3;         // of a segment's range, to look for where errors are large
constexpr double kLarger = 1.25;  // times the error of all runs: worth a sentence

/// What 95 % of runs do not exceed. The largest of a few runs is none of that: one outlier would
/// rule the arm, and without one it is too small. So of few it is the usual multiple of the median.
double largest_expected(const std::vector<double>& values, double tail) {
  return values.size() < PredictionError::kMinRuns ? tail * median(values)
                                                   : conformal_quantile(values);
}

}  // namespace

void RunErrors::add(double max_m, double off_path_m, const GrowingErrors& errors, int frames,
                    const Pressures& mean_kpa) {
  max_m_.push_back(max_m);
  off_path_m_.push_back(off_path_m);
  motions_.push_back(errors);
  frames_ += frames;
  mean_kpa_.push_back(mean_kpa);
}

std::optional<double> RunErrors::largest_at_end(double MotionErrors::*value, double tail) const {
  auto values = mapped<double>(
      motions_, [&](const GrowingErrors& motion) { return motion.of.front().*value; });
  std::erase_if(values, [](double one) { return std::isnan(one); });  // headings of lifted poses
  return values.empty() ? std::nullopt : std::optional(largest_expected(values, tail));
}

std::optional<PredictionError> RunErrors::result(double frame_period_s) const {
  if (max_m_.empty()) {
    return std::nullopt;
  }
  PredictionError result;
  result.runs = int(max_m_.size());
  result.run_s = frames_ / result.runs * frame_period_s;
  result.max_position_m = largest_expected(max_m_, kPathTail);
  result.off_path_m = largest_expected(off_path_m_, kPathTail);
  result.end_position_m = largest_at_end(&MotionErrors::end_m, kEndTail).value();
  result.end_orientation_rad = largest_at_end(&MotionErrors::end_heading_rad, kHeadingTail);
  return result;
}

std::optional<Tube> RunErrors::tube(double arm_length_m) const {
  if (motions_.size() / 2 < kMinTubeRuns) {
    return std::nullopt;
  }
  Tube tube = narrowest_tube(motions_, arm_length_m).tube;
  // The end has quantiles of its own, as in PredictionError: the goal asks for them, not obstacles.
  const double factor = tube.levels.front().factor;
  tube.end_scale_m =
      std::max(kMinScaleM, largest_at_end(&MotionErrors::end_m, kEndTail).value_or(0.0)) / factor;
  tube.end_heading_scale_rad =
      std::max(kMinScaleRad,
               largest_at_end(&MotionErrors::end_heading_rad, kHeadingTail).value_or(0.0)) /
      factor;
  tube.source = "recorded motions that networks had not learnt from, off their path";
  return tube;
}

std::string RunErrors::widest_where(const std::string& unit) const {
  std::string found;
  if (off_path_m_.empty()) {
    return found;
  }
  const double all_m = conformal_quantile(off_path_m_);
  double largest_m = kLarger * all_m;
  for (Eigen::Index i = 0; i < mean_kpa_.front().size(); ++i) {
    const auto of_segment = [&](const Pressures& a, const Pressures& b) { return a[i] < b[i]; };
    const auto [lowest, highest] = std::ranges::minmax_element(mean_kpa_, of_segment);
    const float low = (*lowest)[i];
    const float width = ((*highest)[i] - low) / kParts;
    for (int part = 0; part < kParts; ++part) {
      const float from = low + width * float(part);
      std::vector<double> there_m;
      for (std::size_t run = 0; run < off_path_m_.size(); ++run) {
        if (mean_kpa_[run][i] >= from && mean_kpa_[run][i] <= from + width) {
          there_m.push_back(off_path_m_[run]);
        }
      }
      if (there_m.size() < kMinTubeRuns / 2 || conformal_quantile(there_m) <= largest_m) {
        continue;
      }
      largest_m = conformal_quantile(there_m);
      found = fmt::format(
          "errors are largest with {} at {:.3g} to {:.3g} {}: {:.1f} cm off the path in {} of {} "
          "motions, {:.1f} cm over all; more motions there would narrow the tube",
          segment_name(i), from, from + width, unit, kCmPerM * largest_m, there_m.size(),
          off_path_m_.size(), kCmPerM * all_m);
    }
  }
  return found;
}

}  // namespace limber
