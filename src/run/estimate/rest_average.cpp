#include "rest_average.hpp"

namespace limber {

namespace {

Backbone mean_of(const std::deque<Backbone>& all, std::size_t from, std::size_t until) {
  Backbone sum = all[from];
  for (std::size_t k = from + 1; k < until; ++k) {
    sum += all[k];
  }
  return sum / static_cast<float>(until - from);
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

std::optional<Backbone> RestAverage::backbone() const {
  if (last_.size() < frames_) {
    return std::nullopt;
  }
  const std::size_t middle = frames_ / 2;
  const Backbone moved = mean_of(last_, middle, frames_) - mean_of(last_, 0, middle);
  if (double(moved.leftCols<2>().rowwise().norm().maxCoeff()) > kStillM) {
    return std::nullopt;
  }
  return mean_of(last_, 0, frames_);
}

}  // namespace limber
