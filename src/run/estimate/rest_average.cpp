#include "limber/run/rest_average.hpp"

#include <algorithm>

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

Backbone mean_of(const std::deque<Backbone>& all, std::size_t from, std::size_t until) {
  Backbone sum = all[from];
  for (std::size_t k = from + 1; k < until; ++k) {
    sum += all[k];
  }
  return sum / float(until - from);
}

}  // namespace

void RestAverage::observe(const std::optional<Backbone>& measured) {
  if (!measured) {
    last_.clear();
    return;
  }
  last_.push_back(*measured);
  if (last_.size() > frames_) {
    last_.pop_front();
  }
}

std::optional<double> RestAverage::moved_m() const {
  if (last_.size() < frames_) {
    return std::nullopt;
  }
  const Backbone mean = mean_of(last_, 0, frames_);
  double farthest_m = 0.0;
  for (const Backbone& one : last_) {
    farthest_m = std::max(farthest_m, largest_plate_distance_m(one, mean));
  }
  return farthest_m;
}

std::optional<Backbone> RestAverage::backbone() const {
  const std::optional<double> moved = moved_m();
  if (!moved || *moved > kStillM) {
    return std::nullopt;
  }
  const std::size_t middle = frames_ / 2;
  const bool drifts = largest_plate_distance_m(mean_of(last_, middle, frames_),
                                               mean_of(last_, 0, middle)) > kDriftM;
  return drifts ? std::nullopt : std::optional(mean_of(last_, 0, frames_));
}

}  // namespace limber
