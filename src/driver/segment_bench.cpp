#include "limber/driver/segment_bench.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/run/episode_recorder.hpp"
#include "limber/run/gated_driver.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr double kBenchHoldS = 1.0;
constexpr double kBenchMeanS = 0.4;  // at the end of a hold
constexpr int kMinBenchSteps = 4;

/// Along arcs from plate to plate.
double arc_length_m(const Backbone& backbone) {
  double length_m = 0.0;
  for (Eigen::Index i = 0; i + 1 < backbone.rows(); ++i) {
    const double chord_m = (backbone.row(i + 1) - backbone.row(i)).head<2>().cast<double>().norm();
    length_m += chord_m / chord_share(double(backbone(i + 1, 2)) - double(backbone(i, 2)));
  }
  return length_m;
}

class SegmentBenchRun {
 public:
  SegmentBenchRun(const ArmDescription& arm, ArmDriver& driver)
      : arm_(arm), driver_(arm, driver, true), recorder_(arm) {}

  std::vector<BenchPoint> run(const PressureLimits& limits, int steps) {
    held(0.0);
    rest_ = mean_;
    std::vector<BenchPoint> points = {{0.0, 0.0}};
    for (const double side : {1.0, -1.0}) {
      const double limit_kpa = limits.side_kpa(side);
      if (limit_kpa == 0.0) {
        continue;
      }
      for (int step = 1; step < 2 * steps; ++step) {
        held(limit_kpa * (step <= steps ? step : 2 * steps - step) / steps);
        points.push_back({std::max(0.0, side * pressure_kpa_),
                          side_strain(rest_, mean_, arm_.segments.front().width_m, side)});
      }
      held(0.0);
    }
    return points;
  }

  /// What was recorded so far; empty where nothing was tracked.
  Episode episode() { return recorder_.tracked_count() > 0 ? recorder_.finish() : Episode{}; }

 private:
  void frame(const Pressures& setpoint_kpa) {
    throw_if_interrupted();
    const ArmState& state = driver_.command(setpoint_kpa);
    recorder_.add(state, state.setpoint_kpa.value_or(setpoint_kpa), motion_);
  }

  /// Goes to `kpa`, waits, and takes the means of the hold's end.
  void held(double kpa) {
    const Pressures goal = Pressures::Constant(1, float(kpa));
    for (const Pressures& setpoint_kpa :
         straight_setpoints(setpoint_kpa_, goal, arm_.pressure_step_limit_kpa())) {
      frame(setpoint_kpa);
    }
    setpoint_kpa_ = goal;
    const int frames = arm_.frames_in(kBenchHoldS);
    const int used = arm_.frames_in(kBenchMeanS);
    BackboneD sum = BackboneD::Zero(arm_.point_count(), kPoseSize);
    double sum_kpa = 0.0;
    int tracked = 0;
    for (int k = 0; k < frames; ++k) {
      frame(goal);
      if (k >= frames - used && driver_.state().backbone) {
        sum += driver_.state().backbone->cast<double>();
        sum_kpa += driver_.state().pressure_kpa[0];
        ++tracked;
      }
    }
    if (tracked == 0) {
      throw SystemFault(fmt::format(
          "the tracker did not see the segment at {:.1f} kPa, so its strain is not known", kpa));
    }
    mean_ = (sum / tracked).cast<float>();
    pressure_kpa_ = sum_kpa / tracked;
    ++motion_;
  }

  const ArmDescription& arm_;
  GatedDriver driver_;
  EpisodeRecorder recorder_;
  Pressures setpoint_kpa_ = Pressures::Zero(1);
  Backbone rest_;
  Backbone mean_;
  double pressure_kpa_ = 0.0;
  int motion_ = 0;
};

}  // namespace

double side_strain(const Backbone& rest, const Backbone& bent, double width_m, double side) {
  const double rest_m = arc_length_m(rest);
  const auto turn_rad = [](const Backbone& b) { return double(b(b.rows() - 1, 2)) - b(0, 2); };
  // A right side that contracts turns the segment to the right, clockwise.
  const double turned_rad = turn_rad(bent) - turn_rad(rest);
  const double side_m = arc_length_m(bent) + 0.5 * side * width_m * turned_rad;
  return (side_m - rest_m) / rest_m;
}

void require_one_segment(const ArmDescription& arm) {
  refuse_if(arm.segment_count() != 1,
            "arm '{}' has {} segments; on a driver, one mounted free segment "
            "is characterised: give it an arm file of its own. A whole arm is "
            "characterised from recordings: limber characterize --recording",
            arm.name, arm.segment_count());
}

std::vector<BenchPoint> measure_segment(const ArmDescription& arm, const PressureLimits& limits,
                                        int steps, ArmDriver& driver, Episode& episode) {
  require_one_segment(arm);
  refuse_if(steps < kMinBenchSteps, "bench test: {} steps; expected at least {}", steps,
            kMinBenchSteps);
  SegmentBenchRun run(arm, driver);
  try {
    std::vector<BenchPoint> points = run.run(limits, steps);
    episode = run.episode();
    return points;
  } catch (...) {
    episode = run.episode();
    throw;
  }
}

}  // namespace limber
