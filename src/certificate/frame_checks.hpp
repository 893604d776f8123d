#pragma once

#include "limber/certificate/certificate.hpp"

namespace limber {

/// What can be said of a plan's frames without a model: sizes, pressure limits, rate, frame rule
/// between the waypoints, cost and hold. Appends to `certificate.failures`, the first frame of each
/// kind, and sets cost and largest step.
void check_frames(const Plan& plan, const ArmDescription& arm, Certificate& certificate);

}  // namespace limber
