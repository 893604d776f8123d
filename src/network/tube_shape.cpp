#include "limber/network/tube_shape.hpp"

#include <algorithm>
#include <cassert>

namespace limber {

namespace {

constexpr double kShareInside = 0.99;  // of the runs, below the shape
/// The same for the last third of the plates and for the end, where a wide tube costs plans most.
constexpr double kShareAtTip = 0.95;
constexpr double kTipPlates = 1.0 / 3.0;
constexpr double kStartShare = 0.4;       // what arms are off in their first frames
constexpr double kFullAfterShare = 0.15;  // of the arm's length

}  // namespace

RoomGrowth usual_growth(double arm_length_m) {
  return {kStartShare, kFullAfterShare * arm_length_m};
}

Tube tube_shape(const std::vector<MotionErrors>& runs, const RoomGrowth& growth) {
  assert(!runs.empty());
  Tube tube;
  tube.growth = growth;
  const auto below = [&](double share, auto&& value) {
    std::vector<double> values;
    for (const MotionErrors& run : runs) {
      values.push_back(value(run));
    }
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

}  // namespace limber
