#include "segment_turns.hpp"

#include <algorithm>
#include <cmath>

#include "limber/arm/no_load_model.hpp"

namespace limber {

namespace {

constexpr double kTimeRounding_s = 1e-6;

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
  const auto b = static_cast<Eigen::Index>(after - time_s.begin());
  if (held) {
    return values(b - 1, column);
  }
  const double from = time_s[std::size_t(b - 1)];
  const double part = (asked_s - from) / (time_s[std::size_t(b)] - from);
  return values(b - 1, column) + part * (values(b, column) - values(b - 1, column));
}

Turns turns_of(const BackboneTrack& motion, const ArmDescription& arm) {
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

}  // namespace limber
