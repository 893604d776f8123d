// The sentences of the paper's Section V that compare its two models, asked of our own rows.
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

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

using Value = std::function<std::optional<double>(const PlanningRow&)>;

/// A figure of both models over the environments in which both have it.
struct SideBySide {
  int environments = 0;
  int network_higher = 0;
  double no_load = 0.0;  // means over these environments
  double network = 0.0;
  double no_load_low = 0.0, no_load_high = 0.0, network_low = 0.0, network_high = 0.0;
};

SideBySide side_by_side(const std::vector<PlanningRow>& rows, const Value& value) {
  SideBySide sum;
  for (const Pair& pair : pairs_of(rows)) {
    const std::optional<double> a = value(pair.no_load);
    const std::optional<double> b = value(pair.network);
    if (!a || !b) {
      continue;
    }
    const bool first = sum.environments == 0;
    sum.no_load_low = first ? *a : std::min(sum.no_load_low, *a);
    sum.no_load_high = first ? *a : std::max(sum.no_load_high, *a);
    sum.network_low = first ? *b : std::min(sum.network_low, *b);
    sum.network_high = first ? *b : std::max(sum.network_high, *b);
    ++sum.environments;
    sum.network_higher += *b > *a ? 1 : 0;
    sum.no_load += *a;
    sum.network += *b;
  }
  if (sum.environments > 0) {
    sum.no_load /= sum.environments;
    sum.network /= sum.environments;
  }
  return sum;
}

std::string ranges(const SideBySide& sum, const char* unit, int digits) {
  return fmt::format("{:.{}f}–{:.{}f} {} against {:.{}f}–{:.{}f}", sum.network_low, digits,
                     sum.network_high, digits, unit, sum.no_load_low, digits, sum.no_load_high,
                     digits);
}

PaperFinding distance_finding(const std::vector<PlanningRow>& rows) {
  PaperFinding finding{"end nearer to the goal, collision-free runs of both", "5.7 cm nearer", "",
                       kNotComparable};
  const SideBySide sum =
      side_by_side(rows, [](const PlanningRow& row) { return row.distance_free_cm.mean; });
  if (sum.environments == 0) {
    finding.here = "no environment where both models have a run without collision";
    return finding;
  }
  finding.here = fmt::format("{:.1f} cm nearer, in {} of the environments",
                             sum.no_load - sum.network, sum.environments);
  finding.verdict = sum.network < sum.no_load ? kReproduced : kNot;
  return finding;
}

PaperFinding all_distance_finding(const std::vector<PlanningRow>& rows) {
  PaperFinding finding{"end nearer to the goal, every run", "1.0–6.4 cm against 3.3–14.9", "",
                       kNotComparable};
  const SideBySide sum =
      side_by_side(rows, [](const PlanningRow& row) { return row.distance_cm.mean; });
  if (sum.environments > 0) {
    finding.here = ranges(sum, "cm", 1);
    finding.verdict = sum.network < sum.no_load ? kReproduced : kNot;
  }
  return finding;
}

PaperFinding orientation_finding(const std::vector<PlanningRow>& rows) {
  PaperFinding finding{"similar orientation to the goal", "0.02–0.86 rad against 0.28–1.08", "",
                       kNotComparable};
  const SideBySide sum =
      side_by_side(rows, [](const PlanningRow& row) { return row.orientation_rad.mean; });
  if (sum.environments == 0) {
    finding.here = "no goal asks for a heading";
    return finding;
  }
  finding.here =
      fmt::format("{}; goals that ask for a heading: {}", ranges(sum, "rad", 2), sum.environments);
  constexpr double kSimilarRad = 0.2;  // the paper's means are 0.48 and 0.58
  finding.verdict = std::abs(sum.network - sum.no_load) <= kSimilarRad ? kReproduced : kNot;
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
    finding.verdict =
        double(network) / network_runs < double(no_load) / no_load_runs ? kReproduced : kNot;
  }
  return finding;
}

/// @param finding  without what is found here: that the network's value is the higher one
PaperFinding higher_finding(const SideBySide& sum, PaperFinding finding, const char* unit,
                            int digits) {
  if (sum.environments > 0) {
    finding.here = fmt::format("{}, in {} of {}", ranges(sum, unit, digits), sum.network_higher,
                               sum.environments);
    finding.verdict = 2 * sum.network_higher > sum.environments ? kReproduced : kNot;
  }
  return finding;
}

PaperFinding cost_finding(const std::vector<PlanningRow>& rows) {
  return higher_finding(
      side_by_side(rows, [](const PlanningRow& row) { return row.cost_psi.mean; }),
      {"cost more", "26.8–57.4 psi against 19.4–43.7, in 8 of 8", "", kNotComparable}, "psi", 1);
}

PaperFinding time_finding(const std::vector<PlanningRow>& rows) {
  return higher_finding(
      side_by_side(rows, [](const PlanningRow& row) { return row.first_solution_s.mean; }),
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
