#include "limber/lab/environment_findings.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/lab/environment_measures.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kMonotoneStream = 1;
constexpr int kMaxMonotoneWaypoints = 3;  // of a monotone motion, its end included
constexpr double kAboutGoals = 0.5;  // share of monotone motions that end near a known plan's end
constexpr double kSpread = 0.15;     // of those ends, as a share of the pressure limit

bool proven(const PlanTrial& trial) {
  return trial.execution && has_arrived(*trial.execution);
}

bool failed(const PlanTrial& trial) {
  return trial.execution &&
         (trial.execution->collided || trial.execution->goal_error.position_m > kMissedByM);
}

/// Ways through an environment that need no planner.
class SimplePaths {
 public:
  explicit SimplePaths(const PlanningProblem& problem)
      : arm_(problem.arm),
        environment_(problem.environment),
        start_(start_state(problem.environment, problem.arm)),
        checker_(problem.arm, problem.environment.obstacles),
        simulator_(problem.arm, problem.model, checker_) {}

  /// True if the motion along the waypoints stays free and ends, after the hold, in the goal.
  bool solves(const std::vector<Pressures>& waypoints_kpa) {
    MotionState at = simulator_.start(start_);
    MotionState end;
    for (const Pressures& next : waypoints_kpa) {
      if (!simulator_.move(at, next, end)) {
        return false;
      }
      std::swap(at, end);
    }
    return simulator_.hold(at, end) &&
           is_within(environment_.goal, pose_error(environment_.goal, tip_pose(end.backbone)));
  }

  /// Waypoints between which every pressure only rises or only falls, ending at `end_kpa`.
  std::vector<Pressures> monotone_path(const Pressures& end_kpa, RandomStream& random) const {
    const std::size_t count = 1 + random.index(kMaxMonotoneWaypoints);
    std::vector<Pressures> waypoints(count, end_kpa);
    for (Eigen::Index i = 0; i < end_kpa.size(); ++i) {
      std::vector<double> shares(count - 1);
      std::generate(shares.begin(), shares.end(), [&] { return random.uniform(); });
      std::sort(shares.begin(), shares.end());
      for (std::size_t k = 0; k + 1 < count; ++k) {
        const float from = start_.pressures_kpa[i];
        waypoints[k][i] = from + static_cast<float>(shares[k]) * (end_kpa[i] - from);
      }
    }
    return waypoints;
  }

  /// A configuration within the limits: anywhere, or near one of `ends_kpa`.
  Pressures draw_end(const std::vector<Pressures>& ends_kpa, RandomStream& random) const {
    Pressures end(arm_.channel_count());
    const bool near = !ends_kpa.empty() && random.uniform() < kAboutGoals;
    const Pressures* about =
        near ? &ends_kpa[random.index(static_cast<std::uint32_t>(ends_kpa.size()))] : nullptr;
    for (int i = 0; i < arm_.channel_count(); ++i) {
      const PressureLimits& limits = arm_.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
      const double value = about != nullptr
                               ? (*about)[i] + kSpread * limits.half_width_kpa() * random.normal()
                               : random.uniform(limits.lower_kpa, limits.upper_kpa);
      end[i] = static_cast<float>(limits.clamped(value));
    }
    return end;
  }

 private:
  const ArmDescription& arm_;
  const Environment& environment_;
  ArmStart start_;
  CollisionChecker checker_;
  MotionSimulator simulator_;
};

std::vector<Pressures> plan_ends(const std::vector<PlanTrial>& trials, const char* model) {
  std::vector<Pressures> ends;
  for (const PlanTrial& trial : trials) {
    if (trial.model == model && trial.planning.plan) {
      ends.push_back(trial.planning.plan->frames.back().setpoint_kpa);
    }
  }
  return ends;
}

void look_for_simple_paths(EnvironmentFindings& findings, const PlanningProblem& problem,
                           int monotone_motions, std::uint64_t seed) {
  const std::vector<Pressures> ends = plan_ends(findings.trials, "network");
  findings.straight_line_collides =
      std::all_of(ends.begin(), ends.end(),
                  [&](const Pressures& end) { return straight_line_collides(problem, end); });
  SimplePaths paths(problem);
  RandomStream random(seed, kMonotoneStream);
  findings.needs_reversal = true;
  for (int k = 0; k < monotone_motions && findings.needs_reversal; ++k) {
    findings.needs_reversal =
        !paths.solves(paths.monotone_path(paths.draw_end(ends, random), random));
  }
}

void measure_passage(EnvironmentFindings& findings, const ArmDescription& arm,
                     const Environment& environment) {
  const PlanTrial* best = cheapest_plan(findings.trials, "", "network");
  if (best != nullptr) {
    findings.passage = narrowest_passage(arm, environment, best->planning.plan->frames);
  }
}

}  // namespace

bool is_narrow(const Passage& passage) {
  return passage.width_m <= kNarrowWidths * passage.arm_width_m + kNarrowExtraM;
}

bool EnvironmentFindings::keeps_rules() const {
  return network.solved == network.trials && straight_line_collides;
}

EnvironmentFindings find_out(const ArmDescription& arm, const MotionModel& no_load,
                             const MotionModel& network, const EnvironmentCase& item,
                             const FindingsSettings& settings, std::uint64_t seed) {
  EnvironmentFindings findings;
  findings.trials.resize(2 * static_cast<std::size_t>(settings.trials));
  tbb::parallel_for(std::size_t{0}, findings.trials.size(), [&](std::size_t i) {
    const auto trials = static_cast<std::size_t>(settings.trials);
    PlanTrial& trial = findings.trials[i];
    trial =
        plan_trial(arm, i < trials ? no_load : network, item, settings.planning, seed + i % trials);
    execute_trial(arm, item.environment, trial);
  });
  findings.no_load = summarise(findings.trials, "", "no_load");
  findings.network = summarise(findings.trials, "", "network");
  for (const PlanTrial& trial : findings.trials) {
    findings.network_reached += trial.model == "network" && proven(trial) ? 1 : 0;
    findings.no_load_failed += trial.model == "no_load" && failed(trial) ? 1 : 0;
  }
  look_for_simple_paths(findings, PlanningProblem{arm, network, item.environment, 0.0},
                        settings.monotone_motions, seed);
  measure_passage(findings, arm, item.environment);
  return findings;
}

}  // namespace limber
