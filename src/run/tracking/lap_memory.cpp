#include "limber/run/lap_memory.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr int kSmoothFrames = 2;  // to either side
constexpr double kMaxShiftM = 0.03;

}  // namespace

LapMemory::LapMemory(int frames, double share)
    : share_(share),
      learnt_m_(std::size_t(frames), Eigen::Vector2d::Zero()),
      coming_m_(learnt_m_) {}

void LapMemory::learn(int frame, const Eigen::Vector2d& error_m) {
  const int frames = int(learnt_m_.size());
  if (frame / frames != lap_) {
    lap_ = frame / frames;
    learnt_m_ = coming_m_;
  }
  Eigen::Vector2d& shift_m = coming_m_[frame % frames];
  shift_m += share_ * error_m;
  shift_m *= std::min(1.0, kMaxShiftM / std::max(shift_m.norm(), 1e-12));
}

Eigen::Vector2d LapMemory::shift_m(int frame) const {
  const int frames = int(learnt_m_.size());
  // A horizon that looks into the next lap sees what this one has learnt so far.
  const bool is_next = frame >= 0 && frame / frames > lap_;
  const std::vector<Eigen::Vector2d>& shifts = is_next ? coming_m_ : learnt_m_;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = -kSmoothFrames; k <= kSmoothFrames; ++k) {
    sum += shifts[((std::max(frame, 0) + k) % frames + frames) % frames];
  }
  return sum / (2 * kSmoothFrames + 1);
}

}  // namespace limber
