#pragma once

#include <algorithm>
#include <deque>
#include <optional>

#include "limber/arm/backbone.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// What "at rest" means: so many frames tracked one after another, whose first and second half have
/// the same mean at every plate but for 1 mm, and none of which is 3 mm from the mean of all: a
/// swing passes its turning point with equal halves. Then the backbone is that mean, so that a
/// tracker's noise counts a third as much. Of an arm that moves there is none.
class RestAverage {
 public:
  /// @param frames  that a mean is taken over; one has no halves, so at least two are
  explicit RestAverage(int frames) : frames_(std::size_t(std::max(2, frames))) {}

  void observe(const std::optional<Backbone>& measured);

  /// None unless it rests.
  std::optional<Backbone> backbone() const;
  /// The farthest that a plate was from its mean; none before so many frames were tracked. [m]
  std::optional<double> moved_m() const;

  static constexpr double kDriftM = 0.001;  ///< between the means of the halves
  static constexpr double kStillM = 0.003;  ///< from the mean: six times a tracker's noise
  static constexpr double kRestS = 0.5;     ///< that it is taken over, in all of limber

 private:
  std::size_t frames_;
  std::deque<Backbone> last_;
};

}  // namespace limber
