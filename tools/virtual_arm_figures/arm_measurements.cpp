#include "arm_measurements.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <tbb/parallel_for.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

// Streams of a seed, one for each kind of draw.
constexpr std::uint64_t kMotions = 0;
constexpr std::uint64_t kTargets = 1;
constexpr std::uint64_t kHistories = 1000;

Pressures random_configuration(const ArmDescription& arm, RandomStream& random) {
  Pressures result(arm.segment_count());
  for (int s = 0; s < arm.segment_count(); ++s) {
    const PressureLimits& limits = arm.segments[static_cast<std::size_t>(s)].pressure_limit_kpa;
    result[s] = static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
  }
  return result;
}

Pressures uniform(const ArmDescription& arm, double fraction) {
  Pressures result(arm.segment_count());
  for (int s = 0; s < arm.segment_count(); ++s) {
    result[s] = static_cast<float>(
        fraction * arm.segments[static_cast<std::size_t>(s)].pressure_limit_kpa.upper_kpa);
  }
  return result;
}

Eigen::Vector2d tip(const BackboneD& backbone) {
  return backbone.bottomRows(1).leftCols(2).transpose();
}

/// Mean and standard deviation of what it is given.
class Moments {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  double mean() const { return sum_ / count_; }
  double deviation() const { return std::sqrt(squares_ / count_ - mean() * mean()); }

 private:
  double count_ = 0.0;
  double sum_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace

ArmDescription without_friction(ArmDescription arm) {
  change_virtual_arm(arm, [&](VirtualArmParameters& p) { p.friction_coefficient = 0.0; });
  return arm;
}

NoLoadError no_load_error(const ArmDescription& arm, std::uint64_t seed, int motions, double hold_s,
                          bool settled_only) {
  const NoLoadModel model(arm);
  VirtualArm virtual_arm(arm);
  RandomStream random(seed, kMotions);
  Backbone predicted(arm.point_count(), 3);
  Moments position;
  Moments orientation;
  const int frames = static_cast<int>(std::lround(hold_s * arm.frame_rate_hz));
  for (int motion = 0; motion < motions; ++motion) {
    const Pressures setpoint = random_configuration(arm, random);
    for (int frame = 1; frame <= frames; ++frame) {
      const ArmState& state = virtual_arm.command(setpoint);
      if (settled_only && frame < frames) {
        continue;
      }
      model.backbone(state.pressure_kpa, predicted);
      const Pose expected = tip_pose(predicted);
      const Pose measured = tip_pose(*state.backbone);
      position.add(std::hypot(measured.x_m - expected.x_m, measured.y_m - expected.y_m));
      orientation.add(std::abs(measured.theta_rad - expected.theta_rad));
    }
  }
  return {position.mean(), position.deviation(), orientation.mean(), orientation.deviation()};
}

double settled_scatter_m(const ArmDescription& arm, int targets, int histories) {
  Eigen::MatrixXd x(targets, histories);
  Eigen::MatrixXd y(targets, histories);
  tbb::parallel_for(0, targets * histories, [&](int i) {
    const int target = i / histories;
    const int history = i % histories;
    RandomStream end(static_cast<std::uint64_t>(target), kTargets);
    RandomStream random(static_cast<std::uint64_t>(i), kHistories);
    VirtualArm virtual_arm(arm);
    for (int motion = 0; motion < 4; ++motion) {
      virtual_arm.settle(random_configuration(arm, random), 3.0);
    }
    virtual_arm.settle(random_configuration(arm, end), 6.0);
    const Eigen::Vector2d at = tip(virtual_arm.true_backbone());
    x(target, history) = at.x();
    y(target, history) = at.y();
  });
  const Eigen::ArrayXXd dx = (x.colwise() - x.rowwise().mean()).array();
  const Eigen::ArrayXXd dy = (y.colwise() - y.rowwise().mean()).array();
  return (dx.square() + dy.square()).sqrt().mean();
}

RestDistance rest_distance(const ArmDescription& arm) {
  int combinations = 1;
  for (int s = 0; s < arm.segment_count(); ++s) {
    combinations *= 3;
  }
  std::vector<double> distance(static_cast<std::size_t>(combinations));
  tbb::parallel_for(0, combinations, [&](int combination) {
    Pressures bent = uniform(arm, 1.0);
    int digits = combination;
    for (float& value : bent) {
      value *= static_cast<float>(digits % 3 - 1);
      digits /= 3;
    }
    VirtualArm virtual_arm(arm);
    const Eigen::Vector2d straight = tip(virtual_arm.true_backbone());
    virtual_arm.settle(bent, 4.0);
    virtual_arm.settle(uniform(arm, 0.0), 5.0);
    distance[static_cast<std::size_t>(combination)] =
        (tip(virtual_arm.true_backbone()) - straight).norm();
  });
  RestDistance result;
  for (const double value : distance) {
    result.mean_m += value / (combinations - 1);  // one of them was never bent
  }
  result.all_right_m = distance.back();
  return result;
}

double ring_down_s(const ArmDescription& arm) {
  constexpr double kNear = 0.01;
  VirtualArm virtual_arm(arm);
  virtual_arm.settle(uniform(arm, 1.0), 4.0);
  std::vector<Eigen::Vector2d> tips;  // one per frame
  for (int frame = 0; frame < 400; ++frame) {
    virtual_arm.command(uniform(arm, 0.0));
    tips.push_back(tip(virtual_arm.true_backbone()));
  }
  std::size_t last_away = tips.size() - 1;
  while (last_away > 0 && (tips[last_away] - tips.back()).norm() < kNear) {
    --last_away;
  }
  return static_cast<double>(last_away + 2) * arm.frame_period_s();
}

double drift_m(const ArmDescription& arm, int trials) {
  std::vector<double> farthest(static_cast<std::size_t>(trials));
  tbb::parallel_for(0, trials, [&](int trial) {
    RandomStream random(static_cast<std::uint64_t>(trial), kMotions);
    VirtualArm virtual_arm(arm);
    virtual_arm.settle(random_configuration(arm, random), 3.0);
    const Pressures last = random_configuration(arm, random);
    virtual_arm.settle(last, 8.0);  // at most 3 s of them until the pressure is reached
    const BackboneD settled = virtual_arm.true_backbone();
    double& worst = farthest[static_cast<std::size_t>(trial)];
    virtual_arm.set_observer([&](double, const BackboneD& now) {
      worst = std::max(worst, (now - settled).leftCols(2).rowwise().norm().maxCoeff());
    });
    virtual_arm.settle(last, 10.0);
  });
  return *std::max_element(farthest.begin(), farthest.end());
}

double half_step_distance_m(const ArmDescription& arm, std::uint64_t seed) {
  ArmDescription half = arm;
  change_virtual_arm(half, [&](VirtualArmParameters& p) { p.time_step_s *= 0.5; });
  VirtualArm coarse(arm);
  VirtualArm fine(half);
  RandomStream random(seed, kMotions);
  double farthest = 0.0;
  for (int motion = 0; motion < 20; ++motion) {
    const Pressures setpoint = random_configuration(arm, random);
    for (int frame = 0; frame < std::lround(3.0 * arm.frame_rate_hz); ++frame) {
      coarse.command(setpoint);
      fine.command(setpoint);
      farthest =
          std::max(farthest, (tip(coarse.true_backbone()) - tip(fine.true_backbone())).norm());
    }
  }
  return farthest;
}

double random_run_s(const ArmDescription& arm, std::uint64_t seed, double seconds) {
  VirtualArm virtual_arm(arm);
  RandomStream random(seed, kMotions);
  while (virtual_arm.state().time_s < seconds) {
    virtual_arm.settle(random_configuration(arm, random), random.uniform(0.05, 3.0));
  }
  return virtual_arm.state().time_s;
}

double real_time_factor(const ArmDescription& arm, double seconds) {
  const std::clock_t start = std::clock();
  const double simulated = random_run_s(arm, 1, seconds);
  return simulated * CLOCKS_PER_SEC / static_cast<double>(std::clock() - start);
}

std::vector<double> arc_deviation_m(const ArmDescription& arm) {
  std::vector<double> result;
  for (const Segment& segment : arm.segments) {
    ArmDescription alone = without_friction(arm);
    alone.segments = {segment};
    change_virtual_arm(alone, [&](VirtualArmParameters& p) {
      p.hysteresis_fraction = 0.0;
      p.hysteresis_floor_n = 0.0;
    });
    VirtualArm virtual_arm(alone);
    virtual_arm.settle(uniform(alone, 1.0), 30.0);
    const BackboneD plates = virtual_arm.true_backbone();
    const double length =
        segment.length_m * (1.0 + 0.5 * (virtual_arm.left_strain(0) + virtual_arm.right_strain(0)));
    double farthest = 0.0;
    for (int plate = 1; plate <= segment.gaps; ++plate) {
      const double part = static_cast<double>(plate) / segment.gaps;
      const Eigen::Vector2d arc = arc_end(part * length, part * plates(segment.gaps, 2));
      farthest = std::max(farthest, (plates.row(plate).head<2>().transpose() - arc).norm());
    }
    result.push_back(farthest);
  }
  return result;
}

}  // namespace limber
