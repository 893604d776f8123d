#include "limber/network/tube_shape.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr double kShareInside = 0.99;  // of the runs, below the shape
/// The same for the last third of the plates and for the end, where a wide tube costs plans most.
constexpr double kShareAtTip = 0.95;
constexpr double kTipPlates = 1.0 / 3.0;
constexpr double kFullAfterShare = 0.15;     // of the arm's length
constexpr double kQuantileConfidence = 0.5;  // a measured quantile is too small as often as not

/// What 95 % of these motions stay below, of the plates.
TubeLevel level_by(const Tube& shape, const std::vector<MotionErrors>& motions) {
  const auto scores = mapped<double>(motions, [&](const MotionErrors& motion) {
    return score_of(motion.plate_m, shape.plate_scale_m);
  });
  TubeLevel level;
  level.level = Tube::kDefaultLevel;
  level.factor = conformal_quantile(scores, level.level);
  level.runs = int(scores.size());
  level.outside =
      int(std::ranges::count_if(scores, [&](double score) { return score > level.factor; }));
  level.confidence = kQuantileConfidence;
  return level;
}

}  // namespace

RoomGrowth growth_of(std::size_t candidate, double arm_length_m) {
  return {kStartShares[candidate], kFullAfterShare * arm_length_m};
}

std::vector<MotionErrors> errors_of(const std::vector<GrowingErrors>& motions,
                                    std::size_t candidate) {
  return mapped<MotionErrors>(motions,
                              [&](const GrowingErrors& motion) { return motion.of[candidate]; });
}

Tube tube_shape(const std::vector<MotionErrors>& runs, const RoomGrowth& growth) {
  assert(!runs.empty());
  Tube tube;
  tube.growth = growth;
  const auto below = [&](double share, auto&& value) {
    auto values = mapped<double>(runs, [&](const MotionErrors& run) { return value(run); });
    return conformal_quantile(std::move(values), share);
  };
  const std::size_t plates = runs.front().plate_m.size();
  for (std::size_t plate = 0; plate < plates; ++plate) {
    const bool is_inside = double(plate) < (1.0 - kTipPlates) * double(plates);
    tube.plate_scale_m.push_back(
        std::max(kMinScaleM, below(is_inside ? kShareInside : kShareAtTip,
                                   [&](const MotionErrors& run) { return run.plate_m[plate]; })));
  }
  tube.end_scale_m =
      std::max(kMinScaleM, below(kShareAtTip, [](const MotionErrors& r) { return r.end_m; }));
  tube.end_heading_scale_rad = std::max(
      kMinScaleRad, below(kShareInside, [](const MotionErrors& r) { return r.end_heading_rad; }));
  return tube;
}

double score_of(const std::vector<double>& plate_m, const std::vector<double>& plate_scale_m) {
  double score = 0.0;
  for (std::size_t plate = 0; plate < plate_m.size(); ++plate) {
    score = std::max(score, plate_m[plate] / plate_scale_m[plate]);
  }
  return score;
}

GrowingTube narrowest_tube(const std::vector<GrowingErrors>& motions, double arm_length_m) {
  assert(motions.size() > 1);
  const auto half = std::ptrdiff_t(motions.size() / 2);
  GrowingTube narrowest;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < kStartShares.size(); ++g) {
    const std::vector<MotionErrors> errors = errors_of(motions, g);
    Tube tube = tube_shape({errors.begin(), errors.begin() + half}, growth_of(g, arm_length_m));
    tube.levels = {level_by(tube, {errors.begin() + half, errors.end()})};
    const auto tip_share = sum_of<double>(motions, [&](const GrowingErrors& motion) {
      return motion.tip_share[g] / double(motions.size());
    });
    const double mean_m = tube.levels.front().factor * tube.plate_scale_m.back() * tip_share;
    if (mean_m < least_m) {
      least_m = mean_m;
      narrowest = {g, std::move(tube)};
    }
  }
  return narrowest;
}

}  // namespace limber
