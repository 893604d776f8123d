#include "limber/report/planner_arena.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "limber/common/version.hpp"

namespace limber {

namespace {

// The order is the enumeration's: a run has the index.
constexpr std::array kStatuses = {PlanStatus::solved,
                                  PlanStatus::limit,
                                  PlanStatus::invalid_start,
                                  PlanStatus::goal_unreachable,
                                  PlanStatus::goal_in_collision,
                                  PlanStatus::not_certified};

constexpr const char* kProperties =
    "time REAL\n"
    "solved BOOLEAN\n"
    "correct solution BOOLEAN\n"
    "solution length REAL\n"
    "first solution time REAL\n"
    "first solution length REAL\n"
    "graph states INTEGER\n"
    "model queries INTEGER\n"
    "status ENUM\n";
constexpr int kPropertyCount = 9;

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string run_line(const PlanTrial& trial) {
  const PlanResult& planning = trial.planning;
  std::optional<double> cost, first_s, first_cost;
  if (trial.solved()) {
    cost = planning.plan->cost_kpa;
  }
  if (planning.first_solution) {
    first_s = planning.first_solution->time_s;
    first_cost = planning.first_solution->cost_kpa;
  }
  const auto status =
      std::find(kStatuses.begin(), kStatuses.end(), planning.status) - kStatuses.begin();
  return fmt::format("{}; {}; {}; {}; {}; {}; {}; {}; {}; \n", planning.statistics.time_s,
                     trial.solved() ? 1 : 0, trial.solved() ? 1 : 0, number(cost), number(first_s),
                     number(first_cost), planning.statistics.nodes, planning.statistics.queries,
                     status);
}

/// How the best cost fell: "time,cost,;time,cost,;…".
std::string progress_line(const PlanTrial& trial) {
  std::string line;
  for (const PlannerProgress& event : trial.planning.events) {
    line += fmt::format("{},{},;", event.time_s, *event.best_cost_kpa);
  }
  return line + "\n";
}

std::string planner_name(const PlanTrial& trial) {
  return fmt::format("control_{}_{}", trial.planner, trial.model);
}

}  // namespace

std::string planner_arena_log(const std::string& environment, const std::vector<PlanTrial>& trials,
                              const PlannerLimits& limits, std::uint64_t seed) {
  std::vector<std::string> planners;
  std::vector<std::vector<const PlanTrial*>> runs;
  double total_s = 0.0;
  for (const PlanTrial& trial : trials) {
    if (trial.environment != environment) {
      continue;
    }
    const std::string name = planner_name(trial);
    const auto found = std::find(planners.begin(), planners.end(), name);
    const auto index = static_cast<std::size_t>(found - planners.begin());
    if (found == planners.end()) {
      planners.push_back(name);
      runs.emplace_back();
    }
    runs[index].push_back(&trial);
    total_s += trial.planning.statistics.time_s;
  }
  std::string statuses = "status";
  for (const PlanStatus status : kStatuses) {
    statuses += std::string("|") + to_string(status);
  }
  const std::time_t now = std::time(nullptr);
  std::string log = fmt::format(
      "limber version {}\nExperiment {}\nRunning on {}\nStarting at {:%Y-%m-%d %H:%M:%S}\n"
      "<<<|\nlengths are costs, in the command's unit; states hold commands and shapes\n|>>>\n"
      "{} is the random seed\n{} seconds per run\n{} MB per run\n{} runs per planner\n"
      "{} seconds spent to collect the data\n1 enum type\n{}\n{} planners\n",
      version(), environment, host_name(), fmt::gmtime(now), seed, limits.time_s.value_or(0.0),
      limits.memory_mb.value_or(0.0), runs.empty() ? 0 : runs.front().size(), total_s, statuses,
      planners.size());
  for (std::size_t i = 0; i < planners.size(); ++i) {
    log += fmt::format("{}\n0 common properties\n{} properties for each run\n{}{} runs\n",
                       planners[i], kPropertyCount, kProperties, runs[i].size());
    for (const PlanTrial* trial : runs[i]) {
      log += run_line(*trial);
    }
    log += fmt::format("2 progress properties for each run\ntime REAL\nbest cost REAL\n{} runs\n",
                       runs[i].size());
    for (const PlanTrial* trial : runs[i]) {
      log += progress_line(*trial);
    }
    log += ".\n";
  }
  return log;
}

}  // namespace limber
