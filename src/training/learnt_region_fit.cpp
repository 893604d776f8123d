#include "limber/training/learnt_region_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/network/backbone_layout.hpp"
#include "limber/training/episode_slices.hpp"

namespace limber {

namespace {

// A number that spreads by less is treated as if it spread by this; otherwise noise in numbers that
// hardly move would decide. For positions and headings as in the loss (docs/training.md).
constexpr double kMinPositionSpread_m = 1e-4;
constexpr double kMinHeadingSpread_rad = 2e-3;
constexpr double kMinPressureShare = 0.01;  // of the pressure that spreads most

// An axis with less variance than this, of numbers whose variance is 1, says nothing but rounding.
constexpr double kNegligibleVariance = 1e-5;
constexpr double kMinHalfRange = 1e-3;  // of an axis along which nothing varies

// A rate was recorded where it was held for both of these, in one frame of 200: fewer are how a
// sensor jumps, or a valve that opens, and nothing that a plan could ask for.
constexpr std::array kRateSpans_s{0.5, 1.0};
constexpr double kHeldShare = 0.995;

constexpr int kBlockFrames = 200;        // 10 s: two blocks have little to do with each other
constexpr double kAllowedBeyond = 0.03;  // share of frames; what is asked for is 0.05
constexpr double kMaxWidening = 1.0;

/// Joint vectors of some frames, one per column.
Eigen::MatrixXd joint_vectors(const Episode& episode, const std::vector<int>& frames) {
  const Eigen::MatrixXd poses = episode.backbone(frames, Eigen::all).cast<double>().transpose();
  const Eigen::MatrixXd gaps = gap_poses_of(poses);
  Eigen::MatrixXd joint(episode.pressure_kpa.cols() + gaps.rows(), gaps.cols());
  if (!frames.empty()) {
    joint << episode.pressure_kpa(frames, Eigen::all).cast<double>().transpose(), gaps;
  }
  return joint;
}

/// Of the frames in which the arm was tracked.
Eigen::MatrixXd joint_vectors_of(const Episode& episode) {
  return joint_vectors(episode, tracked_frames(episode));
}

/// By how much they change from frame to frame, where both were tracked.
Eigen::MatrixXd joint_changes_of(const Episode& episode) {
  std::vector<int> before;
  std::vector<int> after;
  for (int t = 1; t < episode.frame_count(); ++t) {
    if (episode.was_tracked(t - 1) && episode.was_tracked(t)) {
      before.push_back(t - 1);
      after.push_back(t);
    }
  }
  return (joint_vectors(episode, after) - joint_vectors(episode, before)).cwiseAbs();
}

/// What `columns_of` makes of each episode, side by side.
Eigen::MatrixXd all_of(const std::vector<Episode>& episodes,
                       Eigen::MatrixXd (*columns_of)(const Episode&)) {
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index frames = 0;
  for (const Episode& episode : episodes) {
    parts.push_back(columns_of(episode));
    frames += parts.back().cols();
  }
  Eigen::MatrixXd all(parts.front().rows(), frames);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
}

/// @throws InputError if there is none.
Eigen::MatrixXd joint_vectors(const std::vector<Episode>& episodes) {
  Eigen::MatrixXd joint = all_of(episodes, joint_vectors_of);
  refuse_if(joint.cols() == 0, "the arm was tracked in no frame of the recordings to learn from");
  return joint;
}

/// Ranges of measured pressures and set points, added to those of `region`.
void widen_pressures(LearntRegion& region, const std::vector<Episode>& episodes) {
  for (const Episode& episode : episodes) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      if (!episode.was_tracked(t)) {
        continue;
      }
      for (const FrameMatrix* kpa : {&episode.pressure_kpa, &episode.setpoint_kpa}) {
        region.low_kpa = region.low_kpa.cwiseMin(kpa->row(t).transpose());
        region.high_kpa = region.high_kpa.cwiseMax(kpa->row(t).transpose());
      }
    }
  }
}

/// Without single frames that lie outside of both neighbours: sensors' spikes.
Eigen::VectorXf without_spikes(const FrameMatrix& pressures, Eigen::Index segment) {
  Eigen::VectorXf values = pressures.col(segment);
  for (Eigen::Index t = 1; t + 1 < values.size(); ++t) {
    const float before = pressures(t - 1, segment);
    const float after = pressures(t + 1, segment);
    values[t] = std::clamp(pressures(t, segment), std::min(before, after), std::max(before, after));
  }
  return values;
}

/// Changes of a segment's pressure over so many seconds, per second, in all tracked frames; over
/// whole episodes where they are shorter.
std::vector<double> changes_of(const std::vector<Episode>& episodes, Eigen::Index segment,
                               double span_s) {
  std::vector<double> changes;
  for (const Episode& episode : episodes) {
    const int last = episode.frame_count() - 1;
    if (last < 1) {
      continue;
    }
    const double period_s = (episode.time_s[last] - episode.time_s[0]) / last;
    const int frames = std::clamp(int(std::lround(span_s / period_s)), 1, last);
    const Eigen::VectorXf values = without_spikes(episode.pressure_kpa, segment);
    for (int t = frames; t <= last; ++t) {
      if (episode.was_tracked(t - frames) && episode.was_tracked(t)) {
        changes.push_back(double(values[t] - values[t - frames]) / (frames * period_s));
      }
    }
  }
  return changes;
}

/// Widens the steepest rates to what the episodes held for a while.
void widen_rates(LearntRegion& region, const std::vector<Episode>& episodes) {
  for (Eigen::Index i = 0; i < region.low_kpa.size(); ++i) {
    double rise = std::numeric_limits<double>::infinity();
    double fall = rise;
    for (const double span_s : kRateSpans_s) {
      std::vector<double> changes = changes_of(episodes, i, span_s);
      changes.push_back(0.0);
      rise = std::min(rise, std::max(0.0, quantile(changes, kHeldShare)));
      fall = std::min(fall, std::max(0.0, -quantile(changes, 1.0 - kHeldShare)));
    }
    region.steepest_rise_kpa_per_s[i] = std::max(region.steepest_rise_kpa_per_s[i], float(rise));
    region.steepest_fall_kpa_per_s[i] = std::max(region.steepest_fall_kpa_per_s[i], float(fall));
  }
}

/// Without any frame: the first makes it.
void forget_ranges(LearntRegion& region, Eigen::Index segments) {
  constexpr float kNone = std::numeric_limits<float>::max();
  region.low_kpa = Pressures::Constant(segments, kNone);
  region.high_kpa = Pressures::Constant(segments, -kNone);
  region.steepest_fall_kpa_per_s = region.steepest_rise_kpa_per_s = Pressures::Zero(segments);
  region.axis_low = Eigen::VectorXf::Constant(region.axes.rows(), kNone);
  region.axis_high = Eigen::VectorXf::Constant(region.axes.rows(), -kNone);
}

/// The frames along the axes of `region`, one per column.
Eigen::MatrixXd along_axes(const LearntRegion& region, const Eigen::MatrixXd& joint) {
  return region.axes.cast<double>() * (region.joint_scale.cast<double>().asDiagonal() *
                                       (joint.colwise() - region.joint_offset.cast<double>()));
}

/// Widens the axes' ranges to those of the frames and `widening` half ranges more on each side.
void widen_axes(LearntRegion& region, const Eigen::MatrixXd& along, double widening) {
  const Eigen::VectorXd low = along.rowwise().minCoeff();
  const Eigen::VectorXd high = along.rowwise().maxCoeff();
  const Eigen::VectorXd margin = (widening * 0.5 * (high - low)).cwiseMax(kMinHalfRange);
  region.axis_low = region.axis_low.cwiseMin((low - margin).cast<float>());
  region.axis_high = region.axis_high.cwiseMax((high + margin).cast<float>());
}

/// By how many half ranges the frames of one half of the recordings, alternating blocks of them,
/// lie beyond those of the other half, in all but kAllowedBeyond of them: what the next recording
/// of the same kind will add to the extremes. Little data need much widening, much data little.
double needed_widening(const Eigen::MatrixXd& along) {
  std::array<std::vector<Eigen::Index>, 2> halves;
  for (Eigen::Index t = 0; t < along.cols(); ++t) {
    halves[t / kBlockFrames % 2].push_back(t);
  }
  std::vector<double> beyond;
  for (const std::size_t half : {0U, 1U}) {
    if (halves[1 - half].empty()) {
      return kAxisWidening;
    }
    const Eigen::MatrixXd known = along(Eigen::all, halves[1 - half]);
    const Eigen::VectorXd low = known.rowwise().minCoeff();
    const Eigen::VectorXd high = known.rowwise().maxCoeff();
    const Eigen::VectorXd middle = 0.5 * (low + high);
    const Eigen::VectorXd half_range = (0.5 * (high - low)).cwiseMax(kMinHalfRange);
    for (const Eigen::Index t : halves[half]) {
      beyond.push_back((along.col(t) - middle).cwiseQuotient(half_range).cwiseAbs().maxCoeff() -
                       1.0);
    }
  }
  return std::clamp(quantile(std::move(beyond), 1.0 - kAllowedBeyond), kAxisWidening, kMaxWidening);
}

/// Of a joint vector's numbers, no less than what they are taken to spread by at least.
Eigen::VectorXd at_least_noise(Eigen::VectorXd spread, Eigen::Index segments) {
  const double widest = spread.head(segments).maxCoeff();
  const double min_kpa = widest > 0.0 ? kMinPressureShare * widest : 1.0;
  spread.head(segments) = spread.head(segments).cwiseMax(min_kpa);
  for (Eigen::Index i = segments; i < spread.size(); ++i) {
    const bool heading = (i - segments) % kPoseSize == 2;
    spread[i] = std::max(spread[i], heading ? kMinHeadingSpread_rad : kMinPositionSpread_m);
  }
  return spread;
}

/// Widens the changes over a frame, from number `first` on, to those of the episodes in
/// kHeldShare of the frames: of each number, and then, by one factor, of all numbers at once.
void widen_changes(LearntRegion& region, const std::vector<Episode>& episodes, Eigen::Index first) {
  const Eigen::MatrixXd changes = all_of(episodes, joint_changes_of);
  if (changes.cols() == 0 || region.joint_change.size() == 0) {
    return;
  }
  Eigen::VectorXd usual(changes.rows());
  for (Eigen::Index i = 0; i < usual.size(); ++i) {
    const Eigen::VectorXd one = changes.row(i);
    usual[i] = quantile({one.begin(), one.end()}, kHeldShare);
  }
  usual = at_least_noise(std::move(usual), region.segment_count());
  const Eigen::VectorXd farthest =
      (usual.cwiseInverse().asDiagonal() * changes).colwise().maxCoeff();
  const double factor =
      std::max(1.0 + kAxisWidening, quantile({farthest.begin(), farthest.end()}, kHeldShare));
  for (Eigen::Index i = first; i < usual.size(); ++i) {
    region.joint_change[i] = std::max(region.joint_change[i], float(factor * usual[i]));
  }
}

/// Frames whose pressures lie beyond the region's count as not tracked.
Episode within(const LearntRegion& region, Episode episode) {
  const int frames = episode.frame_count();
  std::vector<std::uint8_t> known(frames);
  for (int t = 0; t < frames; ++t) {
    known[t] = episode.was_tracked(t) && region.holds(episode.pressure_kpa.row(t).transpose());
  }
  episode.tracked = std::move(known);
  return episode;
}

}  // namespace

LearntRegion learnt_region_of(const std::vector<Episode>& episodes) {
  const Eigen::MatrixXd joint = joint_vectors(episodes);
  const Eigen::Index segments = episodes.front().pressure_kpa.cols();
  const Eigen::VectorXd mean = joint.rowwise().mean();
  Eigen::MatrixXd standard = joint.colwise() - mean;
  // Deviation of each number.
  const Eigen::VectorXd spread =
      at_least_noise(standard.rowwise().norm() / std::sqrt(double(standard.cols())), segments);
  standard = spread.cwiseInverse().asDiagonal() * standard;
  const Eigen::MatrixXd covariance = standard * standard.transpose() / double(standard.cols());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  // Ascending variances: the axes that count are the last ones.
  const Eigen::VectorXd& variance = solver.eigenvalues();
  const auto kept = std::max<Eigen::Index>((variance.array() > kNegligibleVariance).count(), 1);
  LearntRegion region;
  region.joint_offset = mean.cast<float>();
  region.joint_scale = spread.cwiseInverse().cast<float>();
  region.axes = solver.eigenvectors().rightCols(kept).rowwise().reverse().transpose().cast<float>();
  forget_ranges(region, segments);
  widen_pressures(region, episodes);
  widen_rates(region, episodes);
  const Eigen::MatrixXd along = along_axes(region, joint);
  widen_axes(region, along, needed_widening(along));
  region.joint_change = Eigen::VectorXf::Zero(joint.rows());
  widen_changes(region, episodes, 0);
  if (!(region.joint_change.minCoeff() > 0.0F)) {
    region.joint_change.resize(0);  // no two frames follow each other: no speed is known
  }
  return region;
}

LearntRegion widened_by(LearntRegion region, const std::vector<Episode>& episodes) {
  widen_pressures(region, episodes);
  widen_rates(region, episodes);
  widen_axes(region, along_axes(region, joint_vectors(episodes)), kAxisWidening);
  widen_changes(region, episodes, 0);
  return region;
}

LearntRegion with_shapes_of(LearntRegion region, std::vector<Episode> episodes) {
  for (Episode& episode : episodes) {
    episode = within(region, std::move(episode));
  }
  if (!episodes.empty()) {
    if (const Eigen::MatrixXd joint = all_of(episodes, joint_vectors_of); joint.cols() > 0) {
      const Eigen::MatrixXd along = along_axes(region, joint);
      widen_axes(region, along, needed_widening(along));
      widen_changes(region, episodes, region.segment_count());
    }
  }
  return region;
}

LearntRegion learnt_region_of(const TrainingData& data, const LearntRegion* start) {
  if (!data.slices.frame_counts.empty()) {
    std::optional<LearntRegion> region = start != nullptr ? std::optional(*start) : std::nullopt;
    for (const std::vector<int>& slice : slices_of(data.slices, 0, 0)) {
      const std::vector<Episode> episodes = data.slices.read(slice);
      region = region ? widened_by(std::move(*region), episodes) : learnt_region_of(episodes);
    }
    return *region;
  }
  require_alike(data.training, start != nullptr ? start->segment_count() : 0,
                start != nullptr ? start->point_count() : 0, "training data");
  LearntRegion region =
      start != nullptr ? widened_by(*start, data.training) : learnt_region_of(data.training);
  if (data.replay.empty()) {
    return region;
  }
  require_alike(data.replay, region.segment_count(), region.point_count(), "replayed data");
  return widened_by(std::move(region), data.replay);
}

}  // namespace limber
