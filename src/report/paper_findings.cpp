// The sentences of the paper's Section V that compare its two models, asked of our own rows.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "limber/common/statistics.hpp"
#include "limber/report/planning_table.hpp"

namespace limber {

namespace {

constexpr const char* kReproduced = "reproduced";
constexpr const char* kNot = "not reproduced";
constexpr const char* kNotComparable = "not comparable";

/// Both models in one environment.
struct Pair {
  const PlanningRow& no_load;
  const PlanningRow& network;
};

std::vector<Pair> pairs_of(const std::vector<PlanningRow>& rows) {
  std::vector<Pair> pairs;
  for (const PlanningRow& a : rows) {
    for (const PlanningRow& b : rows) {
      if (a.model == "no_load" && b.model == "network" && a.environment == b.environment &&
          is_run_as(a, rows.front()) && is_run_as(b, a)) {
        pairs.push_back({a, b});
      }
    }
  }
  return pairs;
}

/// A figure of both models, in each of the environments in which both have it.
struct SideBySide {
  std::vector<double> no_load, network;
  int network_higher = 0;  // environments
};

SideBySide side_by_side(const std::vector<PlanningRow>& rows, SampleFigures PlanningRow::*figure) {
  SideBySide both;
  for (const auto& [no_load, network] : pairs_of(rows)) {
    const std::optional<double>& a = (no_load.*figure).mean;
    const std::optional<double>& b = (network.*figure).mean;
    if (a && b) {
      both.no_load.push_back(*a);
      both.network.push_back(*b);
      both.network_higher += *b > *a ? 1 : 0;
    }
  }
  return both;
}

const char* verdict(bool is_reproduced) {
  return is_reproduced ? kReproduced : kNot;
}

std::string range(const std::vector<double>& values, int digits) {
  const auto [low, high] = std::ranges::minmax(values);
  return fmt::format("{:.{}f}–{:.{}f}", low, digits, high, digits);
}

std::string ranges(const SideBySide& both, const char* unit, int digits) {
  return fmt::format("{} {} against {}", range(both.network, digits), unit,
                     range(both.no_load, digits));
}

PaperFinding distance_finding(const std::vector<PlanningRow>& rows) {
  PaperFinding finding{"end nearer to the goal, collision-free runs of both", "5.7 cm nearer",
                       "no environment where both models have a run without collision",
                       kNotComparable};
  const SideBySide both = side_by_side(rows, &PlanningRow::distance_free_cm);
  if (!both.network.empty()) {
    const double nearer_cm = mean(both.no_load) - mean(both.network);
    finding.here =
        fmt::format("{:.1f} cm nearer, in {} of the environments", nearer_cm, both.network.size());
    finding.verdict = verdict(nearer_cm > 0.0);
  }
  return finding;
}

PaperFinding all_distance_finding(const std::vector<PlanningRow>& rows) {
  PaperFinding finding{"end nearer to the goal, every run", "1.0–6.4 cm against 3.3–14.9", "",
                       kNotComparable};
  const SideBySide both = side_by_side(rows, &PlanningRow::distance_cm);
  if (!both.network.empty()) {
    finding.here = ranges(both, "cm", 1);
    finding.verdict = verdict(mean(both.network) < mean(both.no_load));
  }
  return finding;
}

PaperFinding orientation_finding(const std::vector<PlanningRow>& rows) {
  constexpr double kSimilarRad = 0.2;  // the paper's means are 0.48 and 0.58
  PaperFinding finding{"similar orientation to the goal", "0.02–0.86 rad against 0.28–1.08",
                       "no goal asks for a heading", kNotComparable};
  const SideBySide both = side_by_side(rows, &PlanningRow::orientation_rad);
  if (!both.network.empty()) {
    finding.here = fmt::format("{}; goals that ask for a heading: {}", ranges(both, "rad", 2),
                               both.network.size());
    finding.verdict = verdict(std::abs(mean(both.network) - mean(both.no_load)) <= kSimilarRad);
  }
  return finding;
}

PaperFinding collision_finding(const std::vector<PlanningRow>& rows) {
  int no_load = 0, no_load_runs = 0, network = 0, network_runs = 0;
  for (const Pair& pair : pairs_of(rows)) {
    no_load += pair.no_load.collided;
    no_load_runs += pair.no_load.executed;
    network += pair.network.collided;
    network_runs += pair.network.executed;
  }
  PaperFinding finding{
      "collide less often", "0 of 8 against 1 of 8",
      fmt::format("{} of {} against {} of {}", network, network_runs, no_load, no_load_runs),
      kNotComparable};
  if (no_load_runs > 0 && network_runs > 0) {
    finding.verdict = verdict(double(network) / network_runs < double(no_load) / no_load_runs);
  }
  return finding;
}

/// @param finding  without what is found here: that the network's value is the higher one
PaperFinding higher_finding(const SideBySide& both, PaperFinding finding, const char* unit,
                            int digits) {
  if (const auto environments = std::ssize(both.network); environments > 0) {
    finding.here = fmt::format("{}, in {} of {}", ranges(both, unit, digits), both.network_higher,
                               environments);
    finding.verdict = verdict(2 * both.network_higher > environments);
  }
  return finding;
}

PaperFinding cost_finding(const std::vector<PlanningRow>& rows) {
  return higher_finding(
      side_by_side(rows, &PlanningRow::cost_psi),
      {"cost more", "26.8–57.4 psi against 19.4–43.7, in 8 of 8", "", kNotComparable}, "psi", 1);
}

PaperFinding time_finding(const std::vector<PlanningRow>& rows) {
  return higher_finding(
      side_by_side(rows, &PlanningRow::first_solution_s),
      {"take longer to plan", "115–250 s against 51–216, in 6 of 8", "", kNotComparable}, "s", 4);
}

PaperFinding success_finding(const std::vector<PlanningRow>& rows) {
  int no_load = 0, network = 0, trials = 0;
  for (const Pair& pair : pairs_of(rows)) {
    no_load += pair.no_load.solved;
    network += pair.network.solved;
    trials += pair.network.trials;
  }
  constexpr double kSimilarShare = 0.1;  // the paper's are 0.92 and 0.85
  const bool similar = trials > 0 && std::abs(network - no_load) <= kSimilarShare * trials;
  return {"are found as often", "136 of 160 against 147 of 160",
          fmt::format("{} of {} against {} of {}", network, trials, no_load, trials),
          trials == 0 ? kNotComparable
          : similar   ? kReproduced
                      : kNot};
}

}  // namespace

bool is_run_as(const PlanningRow& a, const PlanningRow& b) {
  return a.planner == b.planner && a.controller == b.controller && a.disturbance == b.disturbance;
}

std::vector<PaperFinding> compare_with_paper(const std::vector<PlanningRow>& rows) {
  return {distance_finding(rows),  all_distance_finding(rows), orientation_finding(rows),
          collision_finding(rows), cost_finding(rows),         time_finding(rows),
          success_finding(rows)};
}

}  // namespace limber
