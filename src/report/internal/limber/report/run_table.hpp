#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/json.hpp"
#include "limber/report/planning_table.hpp"
#include "limber/run/plan_trial.hpp"

namespace limber {

/// What became of all executed plans of one model, planner, controller and disturbance, over all
/// environments.
struct RunRow {
  std::string model;
  std::string planner;
  std::string controller;
  std::string disturbance;
  int executed = 0;
  int reached = 0;
  int collided = 0;
  int stopped = 0;                ///< by their controller, wherever that was
  int stopped_ahead = 0;          ///< clean stops for an obstacle that had appeared
  int appeared = 0;               ///< runs in which one did
  int faults = 0;                 ///< runs that count nowhere else
  SampleFigures distance_cm;      ///< of all executed but clean stops
  SampleFigures goal_time_ratio;  ///< of runs that arrive: when they were there for good, over the
                                  ///< plan's time
  SampleFigures time_ratio;       ///< frames of the run over the plan's
  SampleFigures replans;
};

/// Counts trials one by one, and keeps four numbers of each.
class RunCount {
 public:
  void add(const PlanTrial& trial);
  /// In the order of the first trials.
  std::vector<RunRow> rows() const;

 private:
  struct Counted {
    RunRow row;
    std::vector<double> distance_cm, goal_time_ratio, time_ratio, replans;
  };
  static void add_run(const PlanTrial& trial, Counted& counted);

  std::vector<Counted> all_;
};

/// runs.json: a list with one object per row.
Json to_json(const std::vector<RunRow>& rows);

ReportTable run_table(const std::vector<RunRow>& rows);

/// The trials in one environment as a log of OMPL's benchmarks, which Planner Arena and OMPL's own
/// script (ompl_benchmark_statistics.py) read: one planner for each of limber's planners and
/// models. Each plan counts once, however many controllers and disturbances it was executed with.
/// @param environment  EnvironmentCase::id
std::string planner_arena_log(const std::string& environment, const std::vector<PlanTrial>& trials,
                              const PlannerLimits& limits, std::uint64_t seed);

}  // namespace limber
