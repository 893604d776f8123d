#include <algorithm>
#include <chrono>
#include <limits>

#include "limber/common/seconds_since.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/world/environment.hpp"

namespace limber {

namespace {

constexpr int kTimedMotions = 32;  // side by side, as searches have them
constexpr int kTimedFrames = 20;
constexpr int kTimings = 7;  // the fastest counts: other work on the machine only delays
constexpr std::uint64_t kQueryStep = 100;

double seconds_per_query(const ArmDescription& arm, const MotionModel& model) {
  const ArmStart rest = start_state(Environment{}, arm);
  const MotionState from = model.settled_state(rest.pressures_kpa, rest.backbone);
  RolloutBatch batch(model);
  double fastest_s = std::numeric_limits<double>::infinity();
  for (int timing = 0; timing < kTimings; ++timing) {
    batch.clear();
    for (int motion = 0; motion < kTimedMotions; ++motion) {
      Pressures to_kpa = rest.pressures_kpa;
      for (Eigen::Index i = 0; i < to_kpa.size(); ++i) {
        const double share = 0.5 * (motion + 1.0) / kTimedMotions;
        const PressureLimits& limits = arm.segments[i].pressure_limit_kpa;
        to_kpa[i] = float(limits.clamped(share * limits.upper_kpa));
      }
      batch.add(motion, from, to_kpa, kTimedFrames);
    }
    const auto begin = std::chrono::steady_clock::now();
    for (int frame = 0; frame < kTimedFrames; ++frame) {
      batch.step();
    }
    const double took_s = seconds_since(begin);
    fastest_s = std::min(fastest_s, took_s / (kTimedMotions * kTimedFrames));
  }
  return fastest_s;
}

}  // namespace

std::uint64_t queries_within(double seconds, const ArmDescription& arm, const MotionModel& model) {
  // A search checks for collisions too, its plan is certified, and the way ahead is forecast. Half
  // of the time stays free: the arm, its driver and whatever else runs here take some of it.
  constexpr double kShareOfModel = 0.2;
  const double queries = kShareOfModel * seconds / seconds_per_query(arm, model);
  constexpr double kMaxQueries = 1e6;
  const auto steps = std::uint64_t(std::min(queries, kMaxQueries)) / kQueryStep;
  return std::max(std::uint64_t{1}, steps) * kQueryStep;
}

}  // namespace limber
