#pragma once

#include "limber/certificate/certificate.hpp"

namespace limber {

/// Checks a plan's frames as far as no model is needed: sizes, pressure limits, rate, frame rule
/// between the waypoints, cost and hold. Appends the first failing frame of each kind to
/// `certificate.failures`, and sets cost and largest step.
void check_frames(const Plan& plan, const ArmDescription& arm, Certificate& certificate);

}  // namespace limber
