#include "limber/run/episode_recorder.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

namespace {

constexpr Eigen::Index kRotation = position_size(Dimension::space);  // of a pose, from there on

/// The numbers of the shape that was seen; none where it was not.
std::span<const float> shape_of(const ArmState& state, Dimension dimension) {
  const auto numbers = [](const auto& shape) -> std::span<const float> {
    return shape ? std::span(shape->data(), std::size_t(shape->size())) : std::span<const float>();
  };
  return dimension == Dimension::space ? numbers(state.space_backbone) : numbers(state.backbone);
}

std::size_t shape_size(const ArmDescription& arm) {
  return std::size_t(pose_size(arm.dimension) * arm.point_count());
}

/// Of q and −q, one rotation, every tracked row has the one nearer to the tracked row before it:
/// the line between the others leads through no rotation at all.
void make_tracked_signs_continuous(const std::vector<std::uint8_t>& tracked, FrameMatrix& poses) {
  std::optional<Eigen::Index> before;
  for (Eigen::Index t = 0; t < poses.rows(); ++t) {
    if (tracked[t] == 0) {
      continue;
    }
    for (Eigen::Index at = kRotation; before && at < poses.cols(); at += kSpacePoseSize) {
      auto rotation = poses.row(t).segment<4>(at);
      if (poses.row(*before).segment<4>(at).dot(rotation) < 0.0F) {
        rotation = -rotation;
      }
    }
    before = t;
  }
}

}  // namespace

void require_state_of(const ArmDescription& arm, const ArmState& state) {
  const std::span<const float> shape = shape_of(state, arm.dimension);
  const bool is_seen =
      arm.is_spatial() ? state.space_backbone.has_value() : state.backbone.has_value();
  const int channels = arm.channel_count();
  if (state.pressure_kpa.size() != channels || (is_seen && shape.size() != shape_size(arm)) ||
      (state.setpoint_kpa && state.setpoint_kpa->size() != channels)) {
    throw SystemFault(fmt::format(
        "the arm returned {} pressures and {} backbone points at {:.3f} s; expected {} and {}",
        state.pressure_kpa.size(),
        is_seen ? std::ssize(shape) / pose_size(arm.dimension) : arm.point_count(), state.time_s,
        channels, arm.point_count()));
  }
  if (!std::isfinite(state.time_s) || !state.pressure_kpa.allFinite() ||
      (state.setpoint_kpa && !state.setpoint_kpa->allFinite()) ||
      !std::all_of(shape.begin(), shape.end(), [](float value) { return std::isfinite(value); })) {
    throw SystemFault(
        fmt::format("the arm returned a number that is not finite at {:.3f} s", state.time_s));
  }
}

bool EpisodeRecorder::add(const ArmState& state, const Pressures& setpoint_kpa, int motion_index) {
  assert(setpoint_kpa.size() == arm_.channel_count());
  require_state_of(arm_, state);
  const std::span<const float> shape = shape_of(state, arm_.dimension);
  const bool is_new = time_s_.empty() || state.time_s != time_s_.back();
  time_s_.push_back(state.time_s);
  pressure_kpa_.insert(pressure_kpa_.end(), state.pressure_kpa.begin(), state.pressure_kpa.end());
  const Pressures& in_force_kpa = state.setpoint_kpa ? *state.setpoint_kpa : setpoint_kpa;
  setpoint_kpa_.insert(setpoint_kpa_.end(), in_force_kpa.begin(), in_force_kpa.end());
  backbone_.insert(backbone_.end(), shape.begin(), shape.end());
  backbone_.resize(time_s_.size() * shape_size(arm_), 0.0F);
  motion_index_.push_back(motion_index);
  const bool is_seen = !shape.empty() && is_new;
  tracked_.push_back(is_seen ? 1 : 0);
  return is_seen;
}

/// Frames that repeat a sample lie evenly between it and the next.
std::vector<double> EpisodeRecorder::sample_times() const {
  std::vector<double> times = time_s_;
  for (std::size_t first = 0; first < times.size();) {
    std::size_t next = first + 1;
    while (next < times.size() && time_s_[next] == time_s_[first]) {
      ++next;
    }
    const auto frames = double(next - first);
    const double until_s =
        next < times.size() ? time_s_[next] : time_s_[first] + frames * arm_.frame_period_s();
    for (std::size_t k = first; k < next; ++k) {
      times[k] += double(k - first) / frames * (until_s - time_s_[first]);
    }
    first = next;
  }
  return times;
}

Episode EpisodeRecorder::finish() {
  if (std::find(tracked_.begin(), tracked_.end(), 1) == tracked_.end()) {
    throw SystemFault(fmt::format(
        "none of {} frames had a backbone: nothing tracked the arm, so there is nothing to record",
        frame_count()));
  }
  const Eigen::Index frames = frame_count();
  const std::vector<double> times_s = sample_times();
  Episode episode;
  episode.time_s = Eigen::Map<const Eigen::VectorXd>(times_s.data(), frames).array() - times_s[0];
  episode.pressure_kpa =
      Eigen::Map<const FrameMatrix>(pressure_kpa_.data(), frames, arm_.channel_count());
  episode.setpoint_kpa =
      Eigen::Map<const FrameMatrix>(setpoint_kpa_.data(), frames, arm_.channel_count());
  episode.dimension = arm_.dimension;
  episode.backbone =
      Eigen::Map<const FrameMatrix>(backbone_.data(), frames, Eigen::Index(shape_size(arm_)));
  if (arm_.is_spatial()) {
    make_tracked_signs_continuous(tracked_, episode.backbone);
  }
  fill_missing_rows(times_s, tracked_, episode.backbone);
  if (arm_.is_spatial()) {
    normalise_filled_rotations(tracked_, episode.backbone);
  }
  episode.motion_index = std::move(motion_index_);
  episode.tracked = std::move(tracked_);
  *this = EpisodeRecorder(arm_);
  return episode;
}

void normalise_filled_rotations(const std::vector<std::uint8_t>& tracked, FrameMatrix& poses) {
  for (Eigen::Index t = 0; t < poses.rows(); ++t) {
    if (tracked[t] != 0) {
      continue;
    }
    for (Eigen::Index at = kRotation; at < poses.cols(); at += kSpacePoseSize) {
      poses.row(t).segment<4>(at).normalize();
    }
  }
}

void fill_missing_rows(const std::vector<double>& time_s, const std::vector<std::uint8_t>& tracked,
                       FrameMatrix& values) {
  const auto frames = Eigen::Index(tracked.size());
  const auto is_tracked = [&](Eigen::Index t) { return tracked[t] != 0; };
  const auto time = [&](Eigen::Index t) { return time_s[t]; };
  Eigen::Index before = -1;
  for (Eigen::Index t = 0; t < frames; ++t) {
    if (is_tracked(t)) {
      before = t;
      continue;
    }
    Eigen::Index after = t + 1;
    while (after < frames && !is_tracked(after)) {
      ++after;
    }
    assert(before >= 0 || after < frames);
    for (Eigen::Index k = t; k < after; ++k) {
      if (before < 0) {
        values.row(k) = values.row(after);
      } else if (after == frames) {
        values.row(k) = values.row(before);
      } else {
        const auto fraction = float((time(k) - time(before)) / (time(after) - time(before)));
        values.row(k) = (1.0F - fraction) * values.row(before) + fraction * values.row(after);
      }
    }
    t = after - 1;
  }
}

}  // namespace limber
