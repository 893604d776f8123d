// Random motions and obstacles, judged by the planner's collision checks, by the certificate's and
// by brute force: what was missed, and which alarms were false.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <CLI/CLI.hpp>

#include "brute_force.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/progress.hpp"
#include "limber/world/collision.hpp"
#include "random_pair.hpp"
#include "src/certificate/swept_clearance.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;

constexpr double kSpacingM = 0.25e-3;  // of the samples
constexpr double kCertificateToleranceM = 2e-5;
constexpr double kFloatM = 1e-9;

/// Of the pairs with one kind of obstacle.
struct Count {
  long pairs = 0;
  long touching = 0;          // a sample touches
  long missed = 0;            // … and the planner's check says free
  long missed_clearance = 0;  // … or its clearance is above the sampled one
  long false_alarms = 0;      // no sample touches, the check does not say free
  long far_alarms = 0;        // … though the arm is certainly more than 1 mm away
  double farthest_alarm_m = 0.0;
  long certificate_missed = 0;  // the certificate's clearance is above the sampled one
  long certificate_low = 0;     // … or below it by more than its tolerance and the sampling's

  void add(const Count& other) {
    pairs += other.pairs;
    touching += other.touching;
    missed += other.missed;
    missed_clearance += other.missed_clearance;
    false_alarms += other.false_alarms;
    far_alarms += other.far_alarms;
    farthest_alarm_m = std::max(farthest_alarm_m, other.farthest_alarm_m);
    certificate_missed += other.certificate_missed;
    certificate_low += other.certificate_low;
  }
};

using Counts = std::map<std::string, Count>;

ExactArm::Shape shape_of(const Backbone& b) {
  ExactArm::Shape shape;
  for (Eigen::Index i = 0; i < b.rows(); ++i) {
    shape.push_back({double(b(i, 0)), double(b(i, 1)), double(b(i, 2))});
  }
  return shape;
}

Count judge(const ArmDescription& arm, const RandomPair& pair) {
  const SampledClearance sampled =
      brute_force_clearance(arm, pair.from, pair.to, pair.obstacle, kSpacingM);
  const std::vector<Obstacle> obstacles{pair.obstacle};
  const CollisionChecker checker(arm, obstacles);
  const bool free = checker.is_motion_free(pair.from, pair.to);
  const double clearance = checker.motion_clearance(pair.from, pair.to).value_m;
  const double certified = SweptClearance(arm, obstacles, kCertificateToleranceM)
                               .over({shape_of(pair.from), shape_of(pair.to)})
                               .value_m;
  Count count;
  count.pairs = 1;
  count.touching = sampled.value_m <= 0.0;
  count.missed = sampled.value_m <= 0.0 && free;
  count.missed_clearance = clearance > sampled.value_m + kFloatM;
  count.false_alarms = sampled.value_m > 0.0 && !free;
  if (count.false_alarms > 0) {
    count.farthest_alarm_m = sampled.value_m;
    count.far_alarms = sampled.value_m - sampled.error_m > CollisionChecker::kToleranceM;
  }
  count.certificate_missed = certified > sampled.value_m + kFloatM;
  count.certificate_low =
      certified < sampled.value_m - sampled.error_m - kCertificateToleranceM - kFloatM;
  return count;
}

Counts judge_all(const ArmDescription& arm, long pairs, std::uint64_t seed) {
  const NoLoadModel model(arm);
  Progress progress("collision oracle", "pairs", static_cast<std::uint64_t>(pairs));
  return tbb::parallel_reduce(
      tbb::blocked_range<long>(0, pairs, 256), Counts(),
      [&](const tbb::blocked_range<long>& range, Counts counts) {
        for (long i = range.begin(); i < range.end(); ++i) {
          RandomStream random(seed, static_cast<std::uint64_t>(i));
          const RandomPair pair = random_pair(arm, model, random);
          const Count count = judge(arm, pair);
          counts[obstacle_kind(pair.obstacle)].add(count);
          counts["all"].add(count);
        }
        progress.advance(static_cast<std::uint64_t>(range.size()));
        return counts;
      },
      [](Counts a, const Counts& b) {
        for (const auto& [kind, count] : b) {
          a[kind].add(count);
        }
        return a;
      });
}

int run(const std::string& arm_file, long pairs, std::uint64_t seed) {
  const ArmDescription arm =
      load_arm(arm_file.empty() ? data_folder() / "arms/three_segment.yaml" : fs::path(arm_file));
  const Counts counts = judge_all(arm, pairs, seed);
  fmt::print("arm {}, seed {}, samples {} mm apart\n", arm.name, seed, kSpacingM * 1e3);
  fmt::print("{:10}{:>10}{:>10}{:>8}{:>10}{:>13}{:>10}{:>14}{:>12}{:>10}\n", "obstacle", "pairs",
             "touching", "missed", "too clear", "false alarms", "> 1 mm", "farthest [mm]",
             "cert. miss", "cert. low");
  for (const auto& [kind, c] : counts) {
    fmt::print("{:10}{:>10}{:>10}{:>8}{:>10}{:>13}{:>10}{:>14.3f}{:>12}{:>10}\n", kind, c.pairs,
               c.touching, c.missed, c.missed_clearance, c.false_alarms, c.far_alarms,
               c.farthest_alarm_m * 1e3, c.certificate_missed, c.certificate_low);
  }
  const Count& all = counts.at("all");
  const bool good = all.missed + all.missed_clearance + all.far_alarms + all.certificate_missed +
                        all.certificate_low ==
                    0;
  return good ? 0 : 1;
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  CLI::App app("Holds swept collision checks against brute force");
  std::string arm;
  long pairs = 1'000'000;
  std::uint64_t seed = 1;
  app.add_option("--arm", arm, "Arm file; the paper's arm where not given");
  app.add_option("--pairs", pairs, "Motions, each with one obstacle")->capture_default_str();
  app.add_option("--seed", seed, "Of the pairs")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    return limber::run(arm, pairs, seed);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
