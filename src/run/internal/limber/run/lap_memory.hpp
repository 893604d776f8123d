#pragma once

#include <vector>

#include <Eigen/Core>

namespace limber {

/// What earlier laps of a path have missed, by the time since the lap's start: iterative learning.
/// A lap's errors are mostly the same again, friction and what the model misses alike; what is
/// asked for is shifted by a share of them, lap by lap.
class LapMemory {
 public:
  /// @param frames  of one lap, ≥ 1  @param share  of an error, that the next lap is shifted by
  LapMemory(int frames, double share);

  /// Where the path had the tip in a frame, minus where it was.
  /// @param frame  since lap 0 began, ≥ 0
  void learn(int frame, const Eigen::Vector2d& error_m);

  /// What to ask for beside the path: zero in the first lap, and smooth, since a single frame's
  /// error may be noise. Frames before lap 0 are as its first one.
  Eigen::Vector2d shift_m(int frame) const;

 private:
  double share_;
  std::vector<Eigen::Vector2d> learnt_m_;  // by the laps that have ended
  std::vector<Eigen::Vector2d> coming_m_;  // for the next lap
  int lap_ = 0;                            // that the last error was of
};

}  // namespace limber
