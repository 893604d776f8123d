#pragma once

// A planning problem drawn by a number: arm, model, valves, environment and everything asked for.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limber/planning/planner_factory.hpp"
#include "planning/play_model.hpp"
#include "support/drawn_environment.hpp"

namespace limber {

namespace drawn {

inline ValveParameters valves(const ArmDescription& arm, RandomStream& random) {
  ValveParameters valves;
  valves.has_sides = arm.command.is_pressure_kpa();
  for (int i = 0; i < arm.segment_count(); ++i) {
    const double rate = arm.pressure_rate_limit_kpa_per_s * random.uniform(0.8, 3.0);
    valves.segments.push_back({{random.uniform(0.01, 0.2), rate},
                               {random.uniform(0.01, 0.2), rate},
                               chance(random, 0.5) ? random.uniform(0.0, 0.1) : 0.0,
                               chance(random, 0.3) ? random.uniform(0.0, 0.2) : 0.0});
  }
  return valves;
}

/// Each is as likely as it stands here.
inline const char* planner(RandomStream& random) {
  constexpr std::array kNames = {"default",
                                 "default",
                                 "default,improved_plans=0",
                                 "default,goal_steering_share=0,step_size=1",
                                 "paper",
                                 "paper,valves=1"};
  return kNames[random.index(kNames.size())];
}

/// Of the arm's own; mostly none.
inline std::vector<PressureLimits> limits(const ArmDescription& arm, RandomStream& random) {
  std::vector<PressureLimits> limits;
  if (chance(random, 0.2)) {
    for (const Segment& segment : arm.segments) {
      limits.push_back(segment.pressure_limit_kpa);
      limits.back() *= random.uniform(0.6, 1.0);
    }
  }
  return limits;
}

}  // namespace drawn

struct DrawnProblem {
  std::uint64_t number;
  RandomStream random{number, 0};  // in the order of what follows
  ArmDescription arm = drawn::arm(number, random);
  /// Half width of the model's play (play_model.hpp); 0: the no-load model.
  double play_m = drawn::chance(random, 0.5) ? random.uniform(0.0, 0.02) * arm.length_m() : 0.0;
  double momentum = play_m > 0.0 && drawn::chance(random, 0.3) ? random.uniform(0.05, 0.4) : 0.0;
  ForwardModel forward = play_m > 0.0
                             ? ForwardModel(arm, play_network(arm, float(play_m), float(momentum)))
                             : ForwardModel(arm);
  ValveParameters valves =
      drawn::chance(random, 0.3) ? drawn::valves(arm, random) : ValveParameters{};
  Environment environment = drawn::environment(number, arm, random);
  double margin_m = drawn::chance(random, 0.5) ? random.uniform(0.0, 0.02) * arm.length_m() : 0.0;
  double goal_margin_m = drawn::chance(random, 0.2)
                             ? random.uniform(0.0, 0.3) * environment.goal.position_tolerance_m
                             : 0.0;
  std::vector<PressureLimits> limits = drawn::limits(arm, random);
  std::string planner = drawn::planner(random);
  int jobs = 1 + int(random.index(2));
  std::uint64_t queries = 500 + random.index(8000);

  explicit DrawnProblem(std::uint64_t drawn_number) : number(drawn_number) {}

  PlanResult plan(int with_jobs) const {
    const MotionModel model(forward, ValveModel(arm, valves));
    PlanningProblem problem{arm, model, environment, margin_m, {goal_margin_m, 0.0}};
    problem.limits = limits;
    PlannerLimits budget;
    budget.queries = queries;
    budget.iterations = 4000;  // ends those whose arm can hardly move
    return make_planner(planner, with_jobs)->plan(problem, budget, number);
  }

  /// Everything that makes the problem again.
  std::string reproduction() const {
    std::string text = fmt::format(
        "problem {}: planner {}, {} jobs, {} queries, margin {} m, goal margin {} m, play {} m, "
        "momentum {}\n",
        number, planner, jobs, queries, margin_m, goal_margin_m, play_m, momentum);
    for (const PressureLimits& limit : limits) {
      text += fmt::format("within {}\n", to_string(limit));
    }
    text += arm_to_yaml(arm) + environment_to_yaml(environment);
    text += valves.is_ideal() ? "" : valves_to_yaml({valves, {}});
    return text + fmt::format(
                      "again: LIMBER_FUZZ_FIRST={} LIMBER_FUZZ_DRAWS=1 planning_test "
                      "--gtest_filter='PlannerFuzz.*'\n",
                      number);
  }
};

}  // namespace limber
