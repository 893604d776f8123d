// Measures the figures of docs/virtual-arm.md on any arm file and sets them beside their goals.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "arm_measurements.hpp"

namespace limber {
namespace {

constexpr double kNone = 1e30;

/// The figures, each printed as soon as it is known, or all as one JSON object at the end.
class Report {
 public:
  /// @param is_papers_arm  only that arm has to resemble the paper's.
  Report(bool json, bool is_papers_arm) : json_(json), is_papers_arm_(is_papers_arm) {}

  /// A figure whose goal holds for the paper's arm alone.
  void add_likeness(const std::string& key, double value, double low, double high) {
    add(key, value, is_papers_arm_ ? low : 0.0, is_papers_arm_ ? high : kNone);
  }

  /// `high` kNone and `low` 0 are no goal.
  void add(const std::string& key, double value, double low = 0.0, double high = kNone) {
    object_[key] = value;
    if (json_) {
      return;
    }
    std::string goal;
    if (high < kNone) {
      goal = fmt::format("goal {:g} to {:g}", low, high);
    } else if (low > 0.0) {
      goal = fmt::format("goal at least {:g}", low);
    }
    const bool met = value >= low && value <= high;
    fmt::print("{:<48} {:>10.4g}  {}{}\n", key, value, goal, met ? "" : "  MISSED");
    std::fflush(stdout);
  }

  void finish() const {
    if (json_) {
      fmt::print("{}\n", object_.dump(1));
    }
  }

 private:
  bool json_;
  bool is_papers_arm_;
  nlohmann::ordered_json object_;
};

void measure_errors(const ArmDescription& arm, int seeds, Report& report) {
  std::vector<NoLoadError> errors(static_cast<std::size_t>(seeds));
  tbb::parallel_for(0, seeds, [&](int seed) {
    errors[static_cast<std::size_t>(seed)] =
        no_load_error(arm, static_cast<std::uint64_t>(seed) + 1, 100, 3.0);
  });
  // Mean over the seeds; reports it with the extremes.
  const auto extremes = [&](const char* key, double NoLoadError::*member, double scale, double low,
                            double high) {
    double mean = 0.0;
    double least = kNone;
    double most = -kNone;
    for (const NoLoadError& error : errors) {
      const double value = scale * error.*member;
      mean += value / seeds;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    report.add_likeness(fmt::format("no_load_{}", key), mean, low, high);
    report.add_likeness(fmt::format("no_load_{}_least_of_{}_seeds", key, seeds), least, low, high);
    report.add_likeness(fmt::format("no_load_{}_most_of_{}_seeds", key, seeds), most, low, high);
    return mean;
  };
  const double mean_position_cm =
      extremes("position_cm", &NoLoadError::position_mean_m, 100.0, 14.5, 18.0);
  extremes("position_std_cm", &NoLoadError::position_std_m, 100.0, 5.3, 12.3);
  extremes("orientation_rad", &NoLoadError::orientation_mean_rad, 1.0, 0.45, 0.70);
  extremes("orientation_std_rad", &NoLoadError::orientation_std_rad, 1.0, 0.29, 0.67);
  const double settled =
      no_load_error(without_friction(arm), 1, 30, 20.0, true).position_mean_m * 100.0;
  report.add("settled_without_friction_cm", settled);
  report.add("settled_without_friction_part", settled / mean_position_cm, 0.0, 0.35);
}

void measure_motion(const ArmDescription& arm, double long_run_s, Report& report) {
  report.add_likeness("settled_scatter_cm", 100.0 * settled_scatter_m(arm, 8, 10), 7.0, kNone);
  const RestDistance rest = rest_distance(arm);
  report.add("rest_after_bends_mean_cm", 100.0 * rest.mean_m);
  report.add("rest_after_all_right_cm", 100.0 * rest.all_right_m);
  report.add("ring_down_s", ring_down_s(arm), 0.0, 3.0);
  report.add("drift_in_10_s_m", drift_m(arm, 10), 0.0, 1e-5);
  double half_step = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    half_step = std::max(half_step, half_step_distance_m(arm, seed));
  }
  report.add("half_time_step_mm", 1e3 * half_step, 0.0, 1.0);
  const std::vector<double> arc = arc_deviation_m(arm);
  for (std::size_t s = 0; s < arc.size(); ++s) {
    report.add(fmt::format("arc_deviation_segment_{}_mm", s), 1e3 * arc[s]);
  }
  constexpr int kRuns = 10;  // a blow-up in any of them is an exception
  tbb::parallel_for(0, kRuns, [&](int seed) {
    random_run_s(arm, 100 + static_cast<std::uint64_t>(seed), long_run_s / kRuns);
  });
  report.add("random_commands_without_blow_up_s", long_run_s);
  report.add("real_time_factor", real_time_factor(arm, 200.0), 50.0, kNone);
}

int run(int argc, char** argv) {
  CLI::App app(
      "Measures the virtual arm of an arm file: likeness to the paper's arm, rest, "
      "stability, speed. Goals of likeness are for arms/three_segment.yaml alone.");
  std::string path = "arms/three_segment.yaml";
  int seeds = 8;
  double long_run_s = 10000.0;
  bool json = false;
  app.add_option("arm", path, "Arm file")->capture_default_str();
  app.add_option("--seeds", seeds, "Random tests to average over")->capture_default_str();
  app.add_option("--long-run-s", long_run_s, "Random commands in all")->capture_default_str();
  app.add_flag("--json", json, "One JSON object instead of the table");
  CLI11_PARSE(app, argc, argv);
  const ArmDescription arm = load_arm(path);
  Report report(json, arm.name == "three_segment");
  measure_errors(arm, seeds, report);
  measure_motion(arm, long_run_s, report);
  report.finish();
  return 0;
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  try {
    return limber::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 3;
  }
}
