#pragma once

#include <functional>
#include <vector>

#include "limber/common/random_stream.hpp"
#include "path_simulator.hpp"

namespace limber {

/// Makes a plan cheaper: leaves out, straightens, splits and shifts waypoints at random, many ways
/// at once. A change counts only after everything behind it has been simulated anew, found free,
/// and ends in the goal after the hold: elsewhere friction would make the plan another one.
/// Everything given is borrowed. What it does depends on the seed, the stream and the number of
/// rounds alone.
class PlanImprover {
 public:
  /// @param stream  tells several improvers of one seed apart
  PlanImprover(const PlanningProblem& problem, PathSimulator& simulator, std::uint64_t seed,
               std::uint64_t stream);

  /// Takes over a plan. @param waypoints_kpa  start first. False where it was given up, or is no
  /// solution; there is then no plan.
  [[nodiscard]] bool adopt(const std::vector<Pressures>& waypoints_kpa,
                           const std::function<bool()>& give_up);

  bool has_plan() const { return !waypoints_kpa_.empty(); }
  void drop_plan() { waypoints_kpa_.clear(); }
  const std::vector<Pressures>& waypoints_kpa() const { return waypoints_kpa_; }
  double cost_kpa() const { return cost_kpa_; }
  /// Rounds since the cost last fell by more than a thousandth.
  int fruitless_rounds() const { return fruitless_rounds_; }
  /// Plans change places, with what is known of them.
  void swap_plans(PlanImprover& other);

  /// A batch of random changes; the cheapest that holds is accepted. @pre has_plan
  void round(const std::function<bool()>& give_up);

 private:
  /// Changes candidate_kpa_; false where this plan cannot be changed so.
  bool leave_out(RandomStream& random);
  bool straighten(RandomStream& random);
  void shift_one(RandomStream& random);
  void shift_end(RandomStream& random);
  bool split(RandomStream& random);
  void change(RandomStream& random);
  Pressures random_shift(RandomStream& random) const;
  Pressures limited(const Pressures& pressures_kpa) const;
  void add_candidate(double cost_kpa);
  void accept(std::size_t candidate);

  struct Candidate {
    std::vector<Pressures> waypoints_kpa;
    std::size_t same;  // waypoints, from the start, that are as before
    double cost_kpa;
  };

  const PlanningProblem& problem_;
  PathSimulator& simulator_;
  std::uint64_t seed_;
  std::uint64_t stream_;
  Pressures limit_kpa_;
  std::vector<Pressures> waypoints_kpa_;
  std::vector<Backbone> backbones_;  // at the waypoints
  double cost_kpa_ = 0.0;
  double milestone_kpa_ = 0.0;  // cost when it last fell by enough
  int fruitless_rounds_ = 0;

  std::uint64_t changes_ = 0;
  std::size_t batch_size_;
  std::vector<Pressures> candidate_kpa_;
  std::vector<Candidate> candidates_;
  std::vector<Path> paths_;
  std::vector<PathOutcome> outcomes_;
};

}  // namespace limber
