// Measures the virtual arm of an arm in space: docs/virtual-arm.md, "In space".
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>

#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/mjcf.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {
namespace {

Pressures random_setpoints(const ArmDescription& arm, RandomStream& random) {
  Pressures result(arm.channel_count());
  for (int i = 0; i < arm.channel_count(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(i);
    result[i] = static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
  }
  return result;
}

Eigen::Vector3d tip_m(const VirtualArm& arm) {
  return arm.true_plates().bottomRows<1>().leftCols<3>().transpose();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

/// How far apart the same set points end, each time reached from others, share of the length.
double history_share(const ArmDescription& arm, int targets, int histories) {
  constexpr double kHoldS = 4.0;
  RandomStream random(1, 0);
  VirtualArm virtual_arm(arm);
  std::vector<double> apart;
  for (int target = 0; target < targets; ++target) {
    const Pressures setpoint = random_setpoints(arm, random);
    std::vector<Eigen::Vector3d> ends;
    for (int history = 0; history < histories; ++history) {
      virtual_arm.settle(random_setpoints(arm, random), kHoldS);
      virtual_arm.settle(setpoint, kHoldS);
      for (const Eigen::Vector3d& other : ends) {
        apart.push_back((tip_m(virtual_arm) - other).norm() / arm.length_m());
      }
      ends.push_back(tip_m(virtual_arm));
    }
  }
  return median(apart);
}

/// Tips of the same random motion with the file's step and with half of it.
void print_step_halving(const ArmDescription& arm) {
  ArmDescription fine = arm;
  change_virtual_arm(fine, [](VirtualArmParameters& p) { p.time_step_s *= 0.5; });
  VirtualArm coarse(arm);
  VirtualArm halved(fine);
  RandomStream random(2, 0);
  double sum = 0.0;
  double largest = 0.0;
  constexpr int kMotions = 40;
  constexpr int kFrames = 20;
  for (int motion = 0; motion < kMotions; ++motion) {
    const Pressures setpoint = random_setpoints(arm, random);
    for (int frame = 0; frame < kFrames; ++frame) {
      coarse.command(setpoint);
      halved.command(setpoint);
      const double apart = (tip_m(coarse) - tip_m(halved)).norm();
      sum += apart;
      largest = std::max(largest, apart);
    }
  }
  fmt::print("half the step moves the tip by {:.3f} mm on average, {:.3f} mm at most\n",
             1e3 * sum / (kMotions * kFrames), 1e3 * largest);
}

/// Errors of the no-load model at the end of holds, and how fast it runs.
void print_no_load_and_speed(const ArmDescription& arm) {
  const NoLoadModel model(arm);
  VirtualArm virtual_arm(arm);
  RandomStream random(3, 0);
  Eigen::VectorXf poses(kSpacePoseSize * arm.point_count());
  double tip_error = 0.0;
  double twist_rad = 0.0;
  double turn_rad = 0.0;
  constexpr int kMotions = 100;
  constexpr double kHoldS = 2.0;
  const std::clock_t start = std::clock();
  for (int motion = 0; motion < kMotions; ++motion) {
    virtual_arm.settle(random_setpoints(arm, random), kHoldS);
    model.poses(virtual_arm.true_pressure_kpa().cast<float>(), poses);
    tip_error += (poses.tail<7>().head<3>().cast<double>() - tip_m(virtual_arm)).norm();
    const Eigen::VectorXd tip = virtual_arm.true_plates().bottomRows<1>().transpose();
    const Eigen::Quaterniond rotation(tip[6], tip[3], tip[4], tip[5]);
    turn_rad = std::max(turn_rad, std::acos((rotation * Eigen::Vector3d::UnitX()).x()));
    twist_rad = std::max(twist_rad, std::abs(2.0 * std::atan2(tip[3], tip[6])));
  }
  const double processor_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  fmt::print("no-load model: tip off by {:.1f} mm on average, {:.1f} % of the length\n",
             1e3 * tip_error / kMotions, 100.0 * tip_error / kMotions / arm.length_m());
  fmt::print("tip turned by up to {:.0f} deg, twisted about the base's x by {:.1f} deg\n",
             turn_rad * 57.2958, twist_rad * 57.2958);
  fmt::print("{:.0f} times real time of one core\n", kMotions * kHoldS / processor_s);
}

int measure(const std::string& file, bool bench_only) {
  ArmDescription arm = load_arm(file, PolynomialsOf::characterisation);
  int channel = 0;
  for (Segment& segment : arm.segments) {
    for (Chamber& chamber : segment.chambers) {
      const StrainFit fit = fit_strain_polynomial(bench_test_of_chamber(arm, channel),
                                                  chamber.limit_kpa.largest_kpa());
      fmt::print("{}: strain_polynomial: [{}]  # full {:.4f}, residual {:.4f} of it\n",
                 channel_name(arm, channel), fmt::join(fit.polynomial, ", "), fit.full_strain,
                 fit.rms_residual);
      chamber.strain_polynomial = fit.polynomial;
      ++channel;
    }
  }
  if (!bench_only) {
    double mass_kg = 0.0;
    for (const ChainLink& link : chain_links(arm, virtual_arm_parameters(arm))) {
      mass_kg += link.mass_kg;
    }
    fmt::print("{:.3f} m, {:.3f} kg\n", arm.length_m(), mass_kg);
    fmt::print("the same command from other sides: {:.2f} % of the length apart (median)\n",
               100.0 * history_share(arm, 16, 4));
    print_step_halving(arm);
    print_no_load_and_speed(arm);
  }
  return 0;
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  CLI::App app("Measures the virtual arm of an arm in space");
  std::string file;
  bool bench_only = false;
  app.add_option("arm", file, "Arm file")->required();
  app.add_flag("--bench-only", bench_only, "Only the strain polynomials of the bench test");
  CLI11_PARSE(app, argc, argv);
  try {
    return limber::measure(file, bench_only);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
