#pragma once

#include <vector>

#include "limber/common/random_stream.hpp"
#include "limber/planning/motion_simulator.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// Makes a plan cheaper: leaves out, straightens and shifts waypoints at random. A change counts
/// only after everything behind it has been simulated anew, found free, and ends in the goal after
/// the hold: elsewhere friction would make the plan another one. Everything given is borrowed.
class PlanImprover {
 public:
  PlanImprover(const PlanningProblem& problem, MotionSimulator& simulator, std::uint64_t seed);

  /// Takes over a plan that is a solution. @param waypoints_kpa  start first
  void adopt(const std::vector<Pressures>& waypoints_kpa);

  bool has_plan() const { return !waypoints_kpa_.empty(); }
  const std::vector<Pressures>& waypoints_kpa() const { return waypoints_kpa_; }
  double cost_kpa() const { return cost_kpa_; }

  /// One random change. True where it was accepted; the cost has then fallen.
  bool try_once();

 private:
  void leave_out();
  void straighten();
  void shift_one();
  void shift_end();
  Pressures random_shift();
  /// Simulates the candidate from its first changed waypoint on.
  bool candidate_is_solution();

  const PlanningProblem& problem_;
  MotionSimulator& simulator_;
  RandomStream random_;
  Pressures limit_kpa_;
  std::vector<Pressures> waypoints_kpa_;
  std::vector<Backbone> backbones_;  // at the waypoints
  double cost_kpa_ = 0.0;

  std::vector<Pressures> candidate_kpa_;
  std::vector<Backbone> candidate_backbones_;
};

}  // namespace limber
