#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/valve_model.hpp"
#include "limber/arm/valve_parameters.hpp"
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
inline void simulate(const ValveMotion& motion, const ValveRun& run,
                     std::vector<double>& pressure) {
  double p = run.measured(run.first);
  pressure.assign(1, p);
  for (int k = 1; k < run.count; ++k) {
    const int frame = run.first + k - motion.frames_late();
    p = motion.after_frame(p, run.setpoint(frame - 1), run.setpoint(frame));
    pressure.push_back(p);
  }
}

/// The valves that explain the measured pressures of `runs` best, by output error: whole runs
/// simulated from their set points, never corrected (docs/valves.md, (P5)). Deterministic.
/// @param limit_kpa  largest command, the scale of what counts as small.
/// @pre runs is not empty, and each has two frames at least.
SegmentValves fit_valves(const std::vector<ValveRun>& runs, bool has_sides, double rate_hz,
                         double limit_kpa);

}  // namespace limber
