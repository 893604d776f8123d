#pragma once

#include <cstdint>
#include <vector>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// End-effector error of the no-load model, over the frames of one run.
struct NoLoadError {
  double position_mean_m = 0.0;
  double position_std_m = 0.0;
  double orientation_mean_rad = 0.0;
  double orientation_std_rad = 0.0;
};

/// `motions` random configurations of `hold_s` each, one unbroken episode from rest, frames at the
/// arm's rate, the model fed with measured pressures. @param settled_only  the last frame of each
/// motion counts, not all of them.
NoLoadError no_load_error(const ArmDescription& arm, std::uint64_t seed, int motions, double hold_s,
                          bool settled_only = false);

/// The same arm on a frictionless table.
ArmDescription without_friction(ArmDescription arm);

/// Mean distance of the settled tip from its mean over `histories` random histories (4 motions
/// each) that end at equal pressures; averaged over `targets` random ends.
double settled_scatter_m(const ArmDescription& arm, int targets, int histories);

/// Distance of the tip from straight after full bends of every combination, held 4 s and vented 5
/// s.
struct RestDistance {
  double mean_m = 0.0;
  double all_right_m = 0.0;  ///< the paper's Fig. 1
};
RestDistance rest_distance(const ArmDescription& arm);

/// From full bend, vented: time from the command until the tip stays within 1 cm of where it ends.
double ring_down_s(const ArmDescription& arm);

/// Largest motion of any plate within 10 s, after random motions that ended 5 s before.
double drift_m(const ArmDescription& arm, int trials);

/// Largest tip distance between runs of whole and of half time steps, 60 s of random motions.
double half_step_distance_m(const ArmDescription& arm, std::uint64_t seed);

/// Runs random commands; returns simulated seconds. @throws SystemFault if it blows up.
double random_run_s(const ArmDescription& arm, std::uint64_t seed, double seconds);

/// Simulated over processor time of one thread.
double real_time_factor(const ArmDescription& arm, double seconds);

/// Largest distance of a plate from the constant-curvature arc of the same angle and length; every
/// segment alone at its pressure limit, settled, without friction.
std::vector<double> arc_deviation_m(const ArmDescription& arm);

}  // namespace limber
