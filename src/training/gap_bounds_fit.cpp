#include "limber/training/gap_bounds_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limber/arm/space_pose.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

/// Of what was recorded but for the rarest, widened by at least `min_margin` and `min_share` of its
/// upper end: from, to.
std::pair<double, double> widened_range(std::vector<float>& values, double min_margin,
                                        double min_share) {
  const auto rare = std::ptrdiff_t(kRareShare * double(values.size()));
  std::nth_element(values.begin(), values.begin() + rare, values.end());
  const double low = values[rare];
  std::nth_element(values.begin(), values.end() - 1 - rare, values.end());
  const double high = *(values.end() - 1 - rare);
  const double margin = std::max({kMargin * (high - low), min_share * high, min_margin});
  return {low - margin, high + margin};
}

}  // namespace

GapBounds gap_bounds_of(const std::vector<Episode>& episodes) {
  refuse_if(episodes.empty(), "no episodes to take the bounds of gaps from; expected at least one");
  require_alike(episodes);
  const Eigen::Index gaps = episodes.front().point_count() - 1;
  const bool in_space = episodes.front().dimension == Dimension::space;
  const Eigen::VectorXf none = Eigen::VectorXf::Zero(gaps);
  GapBounds bounds{none, none, none, none, Eigen::VectorXf::Zero(in_space ? gaps : 0)};
  for (Eigen::Index g = 0; g < gaps; ++g) {
    std::vector<float> lengths;
    std::vector<float> turns;
    std::vector<float> bends;
    for (const Episode& episode : episodes) {
      for (int t = 0; t < episode.frame_count(); ++t) {
        if (episode.was_tracked(t) && in_space) {
          const auto pose = [&](Eigen::Index plate) {
            return space_pose_of(
                episode.backbone.row(t).segment<kSpacePoseSize>(kSpacePoseSize * plate));
          };
          const SpacePoseOf<float> step = between(pose(g), pose(g + 1));
          const Eigen::Vector3f omega = rotation_vector(step.rotation);
          lengths.push_back(step.position_m.norm());
          turns.push_back(omega.x());
          bends.push_back(std::hypot(omega.y(), omega.z()));
        } else if (episode.was_tracked(t)) {
          const auto step = episode.backbone.row(t).segment<kPoseSize>(kPoseSize * (g + 1)) -
                            episode.backbone.row(t).segment<kPoseSize>(kPoseSize * g);
          lengths.push_back(std::hypot(step[0], step[1]));
          turns.push_back(step[2]);
        }
      }
    }
    refuse_if(lengths.empty(), "the arm was tracked in no frame of the recordings to learn from");
    constexpr double kShortest_m = 1e-5;  // a gap keeps a direction, whatever was tracked
    const auto [shortest_m, longest_m] = widened_range(lengths, kShortest_m, kMinLengthMargin);
    const auto [least_rad, most_rad] = widened_range(turns, kMinTurnMargin_rad, 0.0);
    bounds.min_length_m[g] = float(std::max(shortest_m, kShortest_m));
    bounds.max_length_m[g] = float(std::max(longest_m, kShortest_m));
    bounds.min_turn_rad[g] = float(least_rad);
    bounds.max_turn_rad[g] = float(most_rad);
    if (in_space) {
      bounds.max_bend_rad[g] = float(widened_range(bends, kMinTurnMargin_rad, 0.0).second);
    }
  }
  return bounds;
}

}  // namespace limber
