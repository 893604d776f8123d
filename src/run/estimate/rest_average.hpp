#pragma once

#include <deque>
#include <optional>

#include "limber/arm/backbone.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// The backbone of an arm that rests: the mean of what was measured in the last half second, so
/// that a tracker's noise counts a third as much. Of an arm that moves there is none.
class RestAverage {
 public:
  /// @param frames  that a mean is taken over, ≥ 2
  explicit RestAverage(int frames) : frames_(static_cast<std::size_t>(frames)) {}

  void observe(const std::optional<Backbone>& measured);

  /// None unless so many frames were tracked one after another, with the same mean in their first
  /// half as in their second but for kStillM.
  std::optional<Backbone> backbone() const;

 private:
  static constexpr double kStillM = 0.001;

  std::size_t frames_;
  std::deque<Backbone> last_;
};

}  // namespace limber
