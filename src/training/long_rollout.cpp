#include "limber/training/long_rollout.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/network/backbone_layout.hpp"

namespace limber {

namespace {

constexpr double kFarthest = 2.0;  // of the arm's length

/// Frame `step` of a walk over 0, 1, …, count − 1, count − 2, …, 0, 1, …
int there_and_back(int step, int count) {
  const int period = 2 * (count - 1);
  const int at = step % period;
  return at < count ? at : period - at;
}

double arm_length_m(const ForwardModel& model) {
  return sum_of<double>(model.segment_count(),
                        [&](int i) { return model.no_load().segment(i).length_m; });
}

/// Whether some gap of a predicted shape, by its gaps (NetworkLayout), lies on a bound.
bool is_held(const GapBounds& bounds, const Eigen::VectorXd& gaps, Dimension dimension) {
  constexpr double kRounding = 1e-5;  // of float poses about the base [m, rad]
  const int places = position_size(dimension);
  for (Eigen::Index g = 0; g < bounds.min_length_m.size(); ++g) {
    const Eigen::VectorXd gap = gaps.segment(gap_size(dimension) * g, gap_size(dimension));
    const double length = gap.head(places).norm();
    const double turn = gap[places];
    if (length <= double(bounds.min_length_m[g]) + kRounding ||
        length >= double(bounds.max_length_m[g]) - kRounding ||
        turn <= double(bounds.min_turn_rad[g]) + kRounding ||
        turn >= double(bounds.max_turn_rad[g]) - kRounding ||
        (dimension == Dimension::space &&
         gap.tail<2>().norm() >= double(bounds.max_bend_rad[g]) - kRounding)) {
      return true;
    }
  }
  return false;
}

int frames_from_tracked(const Episode& episode) {
  return episode.frame_count() - episode.next_tracked(0, episode.frame_count());
}

/// The longest episodes that a rollout can start in, at most kMaxWalks.
std::vector<const Episode*> episodes_to_walk(const std::vector<Episode>& episodes) {
  constexpr std::size_t kMaxWalks = 4;
  std::vector<const Episode*> longest;
  for (const Episode& episode : episodes) {
    if (frames_from_tracked(episode) >= 2) {
      longest.push_back(&episode);
    }
  }
  std::ranges::stable_sort(longest, std::greater{},
                           [](const Episode* episode) { return frames_from_tracked(*episode); });
  longest.resize(std::min(longest.size(), kMaxWalks));
  return longest;
}

/// One episode there and back for so many frames, added to `result`; `held` counts frames.
/// @return whether all of it is finite
bool walk(const ForwardModel& model, const Episode& episode, int frames, LongRollout& result,
          int& held) {
  const Dimension dimension = model.dimension();
  const int count = frames_from_tracked(episode);
  const int begin = episode.frame_count() - count;
  ForwardModel::Workspace workspace;
  const Eigen::MatrixXf told = model.told_commands(episode.pressure_kpa.transpose());
  const auto commands = [&](int step) -> Eigen::MatrixXf {
    return told.col(begin + there_and_back(step, count));
  };
  Eigen::MatrixXf state = episode.backbone.row(begin).transpose();
  Eigen::MatrixXf before = state;
  const bool is_bounded = model.has_network() && model.compensation().bounds.has_value();
  for (int frame = 0; frame < frames; ++frame) {
    throw_if_interrupted();
    model.step_batch(commands(frame), commands(frame + 1), before, state, before, workspace);
    before.swap(state);
    ++result.frames;
    if (!state.allFinite()) {
      return false;
    }
    const Eigen::MatrixXd shape = state.cast<double>();
    for (Eigen::Index at = 0; at < shape.rows(); at += pose_size(dimension)) {
      const double distance_m = shape.col(0).segment(at, position_size(dimension)).norm();
      result.max_distance_m = std::max(result.max_distance_m, distance_m);
      if (dimension == Dimension::plane) {
        result.max_heading_rad = std::max(result.max_heading_rad, std::abs(shape(at + 2, 0)));
      }
    }
    held += is_bounded && is_held(*model.compensation().bounds,
                                  gap_poses_of(shape, dimension).col(0), dimension)
                ? 1
                : 0;
  }
  return true;
}

}  // namespace

LongRollout roll_out_long(const ForwardModel& model, const std::vector<Episode>& episodes,
                          int frames) {
  require_episodes_of(episodes, model.no_load());
  LongRollout result;
  const std::vector<const Episode*> walks = episodes_to_walk(episodes);
  int held = 0;
  bool finite = true;
  for (std::size_t i = 0; i < walks.size() && finite; ++i) {
    const int left = frames - result.frames;
    finite = walk(model, *walks[i], left / int(walks.size() - i), result, held);
  }
  result.held_share = result.frames > 0 ? double(held) / result.frames : 0.0;
  result.bounded = finite && result.max_distance_m <= kFarthest * arm_length_m(model) &&
                   result.held_share <= LongRollout::kMaxHeldShare;
  return result;
}

}  // namespace limber
