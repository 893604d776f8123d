// Searches for limber's own environments, environments/01…08_*.yaml, and checks them:
//
//   find_environments find  MODEL FOLDER [FAMILY]
//   find_environments check MODEL FILE…
//
// The rules are in docs/environments.md. Planning is limited by iterations, so a search can be
// repeated.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/environment_findings.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "styled_environment.hpp"

namespace limber {
namespace {

/// One of the eight: what it looks like, and what it has to demand.
struct Family {
  const char* id;
  const char* name;
  StyleSettings style;
  double min_cost_psi;
  double max_cost_psi;
  bool no_load_must_fail;
  bool needs_reversal;
  bool narrow;
  double min_no_load_miss_cm;  ///< mean distance that executed no-load plans end off by
};

constexpr EnvironmentStyle kPillars = EnvironmentStyle::pillars;
constexpr EnvironmentStyle kGap = EnvironmentStyle::gap_in_a_wall;
constexpr EnvironmentStyle kBehind = EnvironmentStyle::reach_behind;
constexpr EnvironmentStyle kClutter = EnvironmentStyle::clutter;

const Family kFamilies[] = {
    {"01_pillar",
     "round a pillar",
     {kPillars, 2, false, false, false, 1, 0.03, 0.08},
     15,
     34,
     true,
     false,
     false,
     12.5},
    {"02_two_pillars",
     "between two pillars",
     {kPillars, 2, false, false, false, 2, 0.025, 0.06},
     16,
     40,
     true,
     false,
     false,
     8},
    {"03_gap_in_a_wall",
     "through a gap in a wall",
     {kGap, 2, false, true, false, 5, 0.012, 0.03},
     15,
     44,
     true,
     false,
     true,
     11},
    {"04_reach_behind",
     "reaching behind",
     {kBehind, 3, false, false, true, 3, 0.02, 0.05},
     20,
     50,
     true,
     false,
     false,
     8},
    {"05_between_pillars",
     "a narrow way between pillars",
     {kPillars, 3, false, true, false, 6, 0.012, 0.03},
     18,
     52,
     true,
     false,
     true,
     11},
    {"06_overshoot",
     "overshoot and return",
     {kPillars, 3, true, false, false, 4, 0.02, 0.05},
     25,
     60,
     false,
     true,
     false,
     0},
    {"07_clutter",
     "clutter",
     {kClutter, 3, false, true, true, 7, 0.012, 0.03},
     22,
     60,
     false,
     false,
     true,
     0},
    {"08_overshoot_in_clutter",
     "overshoot and return in clutter",
     {kClutter, 3, true, false, true, 6, 0.02, 0.035},
     28,
     62,
     false,
     true,
     false,
     0},
};

constexpr std::uint64_t kSeed = 2026;
constexpr std::uint64_t kMaxDraws = 200000;
constexpr std::uint64_t kIterations = 8000;
constexpr double kMarginM = 0.005;
constexpr double kUnknown = 9.99;    // [m], where no plan was executed
constexpr double kMaxMissCm = 19.0;  // beyond it only a rare history leads to the goal
constexpr double kNetworkMissM =
    0.05;  // network plans of a chosen environment end nearer than this on average

struct Models {
  ArmDescription arm;
  ForwardModel no_load;
  ForwardModel network;
  std::string network_hash;
};

Models load_models(const std::filesystem::path& model_file) {
  ArmDescription arm = load_arm(data_folder() / "arms/three_segment.yaml");
  ForwardModel no_load(arm);
  ForwardModel network(arm, read_model(model_file));
  return {std::move(arm), std::move(no_load), std::move(network), ""};
}

FindingsSettings search_settings() {
  FindingsSettings settings;
  settings.trials = 4;
  settings.planning.limits.iterations = kIterations;
  settings.planning.room.margin_m = kMarginM;
  return settings;
}

/// The motion that an environment was drawn around, on the arm: cheap, and most drafts fail here.
bool hidden_plan_works(const Models& models, const StyledEnvironment& drawn) {
  VirtualArm driver(models.arm);
  const ExecutionResult run = execute(models.arm, drawn.environment, drawn.hidden_plan, driver);
  return has_arrived(run);
}

/// How far the no-load model's tip is from the goal at the pressures that lead there: about what
/// its plans miss by.
double no_load_miss_m(const Models& models, const StyledEnvironment& drawn) {
  Backbone backbone(models.arm.point_count(), 3);
  models.no_load.no_load().backbone(drawn.hidden_plan.frames.back().setpoint_kpa, backbone);
  return pose_error(drawn.environment.goal, tip_pose(backbone)).position_m;
}

/// Seen on the motion that the environment was drawn around, before any planning.
bool is_promising(const Models& models, const Family& family, const StyledEnvironment& drawn) {
  const std::optional<Passage> passage =
      narrowest_passage(models.arm, drawn.environment, drawn.hidden_plan.frames);
  const double miss_cm = no_load_miss_m(models, drawn) * kCmPerM;
  return (!family.narrow || (passage && is_narrow(*passage))) &&
         miss_cm >= 0.8 * family.min_no_load_miss_cm && miss_cm <= kMaxMissCm &&
         hidden_plan_works(models, drawn);
}

/// What holds of few trials as well as of many.
bool worth_a_closer_look(const Family& family, const EnvironmentFindings& found) {
  return found.keeps_rules() && found.no_load.solved == found.no_load.trials &&
         found.network.distance_m.value_or(kUnknown) < kNetworkMissM &&
         found.no_load.distance_m.value_or(0.0) * kCmPerM >= family.min_no_load_miss_cm &&
         (!family.no_load_must_fail || 2 * found.no_load_failed > found.no_load.trials) &&
         (!family.needs_reversal || found.needs_reversal) &&
         (!family.narrow || (found.passage && is_narrow(*found.passage)));
}

bool suits(const Family& family, const EnvironmentFindings& found) {
  const double cost_psi = found.network.cost_kpa.value_or(0.0) / kKpaPerPsi;
  return worth_a_closer_look(family, found) && cost_psi >= family.min_cost_psi &&
         cost_psi <= family.max_cost_psi && found.network.collided <= 1;
}

std::string row(const std::string& id, const EnvironmentFindings& found) {
  return fmt::format(
      "{:<26} network {}/{} solved {:5.1f} psi {:4.1f} cm {} collided {} reached | no load {}/{} "
      "{:5.1f} psi "
      "{:4.1f} cm {} collided {} failed | straight {} reversal {} passage {} narrow {}",
      id, found.network.solved, found.network.trials,
      found.network.cost_kpa.value_or(0.0) / kKpaPerPsi,
      found.network.distance_m.value_or(kUnknown) * kCmPerM, found.network.collided,
      found.network_reached, found.no_load.solved, found.no_load.trials,
      found.no_load.cost_kpa.value_or(0.0) / kKpaPerPsi,
      found.no_load.distance_m.value_or(0.0) * kCmPerM, found.no_load.collided,
      found.no_load_failed, found.straight_line_collides ? "collides" : "free",
      found.needs_reversal ? "needed" : "-",
      found.passage ? fmt::format("{:.1f}/{:.1f} cm", found.passage->width_m * kCmPerM,
                                  found.passage->arm_width_m * kCmPerM)
                    : "-",
      (found.passage && is_narrow(*found.passage)) ? "yes" : "no");
}

/// Waypoints of a motion that was executed: the proof, kept beside the environment, that its goal
/// can be reached.
std::string witness_to_yaml(const Plan& plan) {
  std::string text =
      "# Executed on the virtual arm, this motion reaches the goal without collision "
      "(docs/environments.md).\n"
      "schema: limber/witness/1\nwaypoints_kpa:\n";
  for (const Pressures& waypoint : plan.waypoints_kpa) {
    text += fmt::format("  - [{}]\n", fmt::join(waypoint.begin(), waypoint.end(), ", "));
  }
  return text;
}

bool find(const Models& models, const Family& family, const std::filesystem::path& folder) {
  const auto seed = kSeed + std::uint64_t(&family - kFamilies);  // no two draw the same motions
  std::uint64_t drawn_count = 0;
  std::uint64_t examined = 0;
  for (std::uint64_t number = 0; number < kMaxDraws; ++number) {
    auto drawn = draw_styled(models.arm, models.network, family.style, seed, number);
    drawn_count += drawn ? 1 : 0;
    if (!drawn || !is_promising(models, family, *drawn)) {
      continue;
    }
    drawn->environment.name = family.name;
    ++examined;
    FindingsSettings settings = search_settings();
    settings.trials = 1;  // a first look; only what passes is looked at closely
    settings.planning.limits.iterations = kIterations / 4;
    const EnvironmentCase item{family.id, drawn->environment};
    EnvironmentFindings found =
        find_out(models.arm, models.no_load, models.network, item, settings, kSeed);
    const bool promising = worth_a_closer_look(family, found);
    fmt::print(stderr, "{} draw {}: {}\n", promising ? "+" : " ", number, row(family.id, found));
    if (!promising) {
      continue;
    }
    found =
        find_out(models.arm, models.no_load, models.network, item, search_settings(), kSeed + 100);
    if (suits(family, found)) {
      fmt::print("{}\n", row(family.id, found));
      std::fflush(stdout);
      const std::string file = std::string(family.id) + ".yaml";
      write_file_atomically(folder / file, environment_to_yaml(item.environment));
      write_file_atomically(folder / "witnesses" / file, witness_to_yaml(drawn->hidden_plan));
      return true;
    }
    fmt::print(stderr, "- draw {}: {}\n", number, row(family.id, found));
  }
  fmt::print("{}: nothing found among {} drawn, {} examined\n", family.id, drawn_count, examined);
  return false;
}

int run(int argc, char** argv) {
  const bool is_find = argc >= 4 && std::strcmp(argv[1], "find") == 0;
  const bool is_check = argc >= 4 && std::strcmp(argv[1], "check") == 0;
  if (!is_find && !is_check) {
    fmt::print(stderr, "usage: find_environments find MODEL FOLDER [FAMILY] | check MODEL FILE…\n");
    return 2;
  }
  const Models models = load_models(argv[2]);
  bool all_good = true;
  if (is_find) {
    for (const Family& family : kFamilies) {
      if (argc == 4 || std::strcmp(argv[4], family.id) == 0) {
        all_good = find(models, family, argv[3]) && all_good;
      }
    }
    return all_good ? 0 : 1;
  }
  for (int i = 3; i < argc; ++i) {
    const std::filesystem::path path = argv[i];
    const EnvironmentCase item{path.stem().string(), load_environment(path, models.arm)};
    const EnvironmentFindings found =
        find_out(models.arm, models.no_load, models.network, item, search_settings(), kSeed + 200);
    fmt::print("{} {}\n", found.keeps_rules() ? "keeps the rules " : "BREAKS THE RULES",
               row(item.id, found));
    std::fflush(stdout);
    all_good = all_good && found.keeps_rules();
  }
  return all_good ? 0 : 1;
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  try {
    return limber::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
