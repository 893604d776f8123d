#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "limber/arm/valve_model.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// One segment over a stretch of an episode: frames [first, first + count).
struct ValveRun {
  const Episode* episode = nullptr;
  int segment = 0;
  int first = 0;
  int count = 0;

  double setpoint(int frame) const { return episode->setpoint_kpa(std::max(frame, 0), segment); }
  double measured(int frame) const { return episode->pressure_kpa(frame, segment); }
};

/// Pressures of a run from its first measured one, by its set points alone: count numbers. Set
/// points of before the episode are its first.
inline void simulate(const ValveMotion& motion, const ValveRun& run, Eigen::VectorXd& pressure) {
  pressure.resize(run.count);
  double p = run.measured(run.first);
  pressure[0] = p;
  for (int k = 1; k < run.count; ++k) {
    const int frame = run.first + k - motion.frames_late();
    p = motion.after_frame(p, run.setpoint(frame - 1), run.setpoint(frame));
    pressure[k] = p;
  }
}

}  // namespace limber
