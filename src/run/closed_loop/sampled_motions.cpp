#include "sampled_motions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/world/hold.hpp"
#include "limber/world/pressure_box.hpp"
#include "limber/world/straight_motion.hpp"
#include "plan_repair.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kStream = 0x73616d706c65;
/// Of a segment's pressure scale: deviations of ends and of points on the way. Less than the least
/// moves no arm, the most moves the tip by several times the corrections that are needed.
constexpr double kLeast = 0.01;
constexpr double kMostOfEnds = 0.7;
constexpr double kLeastOnTheWay = 0.03;
constexpr double kMostOnTheWay = 0.8;
constexpr double kErrorOfEffort = 0.0014;  // of the arm's length: what effort has to be worth
constexpr std::uint64_t kQueriesOfMotion = 30;
constexpr std::size_t kLeastMotions = 32;
constexpr int kRounds = 3;  // around the best
constexpr std::size_t kBest = 16;
constexpr int kAroundEach = 8;
constexpr double kSpread = 0.4;  // around the best, of how far they go
constexpr int kTries = 300;      // of the best sampled motions, that are checked as plans

class MotionSampler {
 public:
  MotionSampler(const PlanningProblem& problem, std::uint64_t seed)
      : problem_(problem),
        box_(setpoints_of(problem)),
        from_(start_of(problem)),
        held_kpa_(from_.setpoint_kpa()),
        scales_kpa_(pressure_scales_kpa(problem.arm)),
        random_(seed, kStream),
        rollouts_(problem.model) {}

  std::vector<SampledMotion> run(std::size_t count) {
    std::vector<Waypoints> sampled;
    for (std::size_t k = 0; k < count; ++k) {
      Waypoints waypoints_kpa{held_kpa_};
      if (k % 2 == 1) {
        waypoints_kpa.push_back(around(held_kpa_, between(kLeastOnTheWay, kMostOnTheWay)));
      }
      waypoints_kpa.push_back(around(held_kpa_, between(kLeast, kMostOfEnds)));
      sampled.push_back(std::move(waypoints_kpa));
    }
    simulate(std::move(sampled));
    for (int round = 0; round < kRounds; ++round) {
      simulate(around_the_best());
    }
    return std::move(motions_);
  }

 private:
  using Waypoints = std::vector<Pressures>;

  /// Logarithmic: small motions are no rarer than large ones.
  double between(double least, double most) {
    return least * std::pow(most / least, random_.uniform());
  }

  /// @param size  deviation, of the segments' scales
  Pressures around(const Pressures& kpa, double size) {
    Pressures sampled = kpa;
    for (Eigen::Index i = 0; i < sampled.size(); ++i) {
      sampled[i] += float(size * random_.normal()) * scales_kpa_[i];
    }
    return box_.limited(sampled);
  }

  std::vector<Waypoints> around_the_best() {
    std::vector<Waypoints> sampled;
    for (std::size_t k = 0; k < std::min(kBest, motions_.size()); ++k) {
      for (int i = 0; i < kAroundEach; ++i) {
        Waypoints waypoints_kpa = motions_[k].waypoints_kpa;
        for (std::size_t w = 1; w < waypoints_kpa.size(); ++w) {
          const double gone =
              double((waypoints_kpa[w] - held_kpa_).cwiseQuotient(scales_kpa_).norm());
          waypoints_kpa[w] = around(waypoints_kpa[w], kSpread * gone);
        }
        sampled.push_back(std::move(waypoints_kpa));
      }
    }
    return sampled;
  }

  int frames_to(const Waypoints& waypoints_kpa, std::size_t w) const {
    return motion_frame_count(waypoints_kpa[w - 1], waypoints_kpa[w],
                              problem_.arm.pressure_step_limit_kpa());
  }

  void simulate(std::vector<Waypoints> sampled) {
    rollouts_.clear();
    for (std::size_t k = 0; k < sampled.size(); ++k) {
      rollouts_.add(int(k), from_, sampled[k][1], frames_to(sampled[k], 1));
    }
    std::vector<std::size_t> reached(sampled.size(), 0);  // waypoints; one more after the hold
    while (rollouts_.size() > 0) {
      rollouts_.step();
      for (int column = rollouts_.size() - 1; column >= 0; --column) {
        if (rollouts_.has_ended(column)) {
          const auto label = std::size_t(rollouts_.label(column));
          go_on(column, ++reached[label], sampled[label]);
        }
      }
    }
    const double effort_m = kErrorOfEffort * problem_.arm.length_m();
    std::stable_sort(motions_.begin(), motions_.end(), [&](const auto& a, const auto& b) {
      return a.error_m + effort_m * a.effort < b.error_m + effort_m * b.effort;
    });
  }

  void go_on(int column, std::size_t reached, Waypoints& waypoints_kpa) {
    if (reached + 1 < waypoints_kpa.size()) {
      rollouts_.go_on(column, waypoints_kpa[reached + 1], frames_to(waypoints_kpa, reached + 1));
    } else if (reached + 1 == waypoints_kpa.size()) {
      rollouts_.go_on(
          column, waypoints_kpa.back(),
          hold_frame_count(problem_.arm, problem_.model.valves(), rollouts_.valves(column)));
    } else {
      const PoseGoal& goal = problem_.environment.goal;
      const double error_m = as_length_m(goal, pose_error(goal, tip_pose(rollouts_.now(column))));
      const double effort = path_cost_kpa(waypoints_kpa) / double(scales_kpa_.mean());
      if (std::isfinite(error_m)) {
        motions_.push_back({std::move(waypoints_kpa), effort, error_m});
      }
      rollouts_.remove(column);
    }
  }

  const PlanningProblem& problem_;
  PressureBox box_;
  MotionState from_;
  Pressures held_kpa_;
  Pressures scales_kpa_;
  RandomStream random_;
  RolloutBatch rollouts_;
  std::vector<SampledMotion> motions_;
};

}  // namespace

std::vector<SampledMotion> sampled_motions(const PlanningProblem& problem, std::uint64_t queries,
                                           std::uint64_t seed) {
  const auto count = std::size_t(queries / kQueriesOfMotion);
  return MotionSampler(problem, seed).run(std::max(kLeastMotions, count));
}

std::optional<Plan> sampled_plan(const PlanningProblem& problem,
                                 const std::vector<SampledMotion>& motions,
                                 const SampledPlanAsked& asked, std::uint64_t seed,
                                 const PlanCheck& check) {
  CheckedPlans plans(problem, check);
  const double better_effort = std::max(asked.better_effort, asked.least_effort);
  for (const bool is_preferred : {true, false}) {
    int tried = 0;
    for (const SampledMotion& motion : motions) {
      if (!(motion.error_m <= asked.max_error_m && motion.effort >= asked.least_effort) ||
          (motion.effort >= better_effort) != is_preferred) {
        continue;
      }
      if (++tried > kTries || interrupt_requested()) {
        break;
      }
      if (!plans.end_of(motion.waypoints_kpa)) {
        continue;
      }
      if (std::optional<Plan> plan = plans.checked(motion.waypoints_kpa, "sampled", seed)) {
        return plan;
      }
    }
  }
  return std::nullopt;
}

}  // namespace limber
