#pragma once

#include <deque>

#include "limber/run/arm_driver.hpp"

namespace limber {

/// By how many frames the states of a driver are behind its set points. A driver that plays a whole
/// frame before it answers is not. One that answers at once, as hardware does, is behind by one:
/// its state is the end of the frame before, and the set point in force (ArmState::setpoint_kpa)
/// says so. A state that does not say is taken for the end of its frame.
class StateLag {
 public:
  static constexpr int kMaxFrames = 3;

  /// Takes in the set points of a frame and the state that answered them.
  /// @return by how many frames states are behind, as far as is known: while set points stand
  /// still, all of them look the same
  int note(const Pressures& setpoint_kpa, const ArmState& state);

 private:
  std::deque<Pressures> commanded_kpa_;  // the latest first
  int frames_ = 0;
};

}  // namespace limber
