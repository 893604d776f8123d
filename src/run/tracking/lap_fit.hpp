#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/lap_posture.hpp"
#include "limber/run/tip_path.hpp"

namespace limber {

/// The set points of a lap, moved until the model's own tip keeps the path: least squares by
/// damped Gauss–Newton steps, with slopes from rollouts of the whole lap, one for each number. A
/// posture comes from the no-load model, whose error is several centimetres, and on the rim of what
/// the arm reaches no correction that looks a fraction of a second ahead makes up for that: there
/// the arm has to have another shape.
///
/// A path that closes and is run more than once is fitted as its second lap, which the first one
/// ends in. Set points stay within the arm's limits, a little inside. A posture that is not known,
/// or of a lap with fewer frames than points, stays as it is.
LapPosture fitted_to(const TipPath& path, const ArmDescription& arm, const MotionModel& model,
                     const LapPosture& posture);

}  // namespace limber
