#include "limber/run/state_lag.hpp"

#include <limits>

namespace limber {

namespace {

constexpr float kSameKpa = 0.01F;  // a device may round what it is told

}  // namespace

int StateLag::note(const Pressures& setpoint_kpa, const ArmState& state) {
  commanded_kpa_.push_front(setpoint_kpa);
  if (commanded_kpa_.size() > kMaxFrames + 1) {
    commanded_kpa_.pop_back();
  }
  if (!state.setpoint_kpa) {
    return frames_;
  }
  const auto distance = [&](int frames) {
    const auto k = std::size_t(frames);
    return k < commanded_kpa_.size()
               ? (commanded_kpa_[k] - *state.setpoint_kpa).cwiseAbs().maxCoeff()
               : std::numeric_limits<float>::infinity();
  };
  int nearest = frames_;
  for (int frames = 0; frames <= kMaxFrames; ++frames) {
    if (distance(frames) + kSameKpa < distance(nearest)) {
      nearest = frames;
    }
  }
  return frames_ = nearest;
}

}  // namespace limber
