#pragma once

#include <vector>

#include "exact_arm.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/certificate/certificate.hpp"
#include "limber/world/environment.hpp"

namespace limber {

ExactArm::Shape shape_of(const Backbone& backbone);
std::vector<double> numbers(const Pressures& kpa);

/// Whether collision is defined: finite poses, and no gap that turns by more than half a turn.
bool is_drawable(const ExactArm::Shape& shape);

/// How far two shapes are apart, and the plate with the largest deviation.
struct Deviation {
  double apart_m = 0.0;
  double turned_rad = 0.0;
  int plate = 0;
};

/// Puts `found` in the place of `largest` if it is larger, or either is not a number. @return
/// whether it did
bool raise_to(double& largest, double found);

/// A coordinate that is not a number counts as any distance: comparisons with it are false.
Deviation deviation(const ExactArm::Shape& own, const ExactArm::Shape& stored);

/// Checks what a plan says of its tube: numbers that a tube can have, and no narrower than the
/// network promises at that level. Appends a failure to `certificate.failures`.
/// @param network  null: the no-load model, which promises none
void check_tube(const Plan& plan, const CompensationModel* network, const ArmDescription& arm,
                Certificate& certificate);

/// Where an arm is at a plan's frame 0, and what was commanded until then.
struct ExactStart {
  std::vector<double> pressure_kpa;
  std::vector<double> setpoint_kpa;        ///< of an arm at rest the pressures
  ExactValves::Configurations before_kpa;  ///< set points before that, the newest first
  ExactArm::Shape shape;
  ExactArm::Shape before;  ///< a frame earlier
};

/// The environment's start, at rest or in motion; without one, the straight arm without pressure.
ExactStart exact_start(const Environment& environment, const ArmDescription& arm,
                       const ExactArm& model);

/// Checks a plan's frames as far as no model is needed: sizes, pressure limits, rate, frame rule
/// between the waypoints, cost and hold. Appends the first failing frame of each kind to
/// `certificate.failures`, and sets cost and largest step.
void check_frames(const Plan& plan, const ArmDescription& arm, Certificate& certificate);

}  // namespace limber
