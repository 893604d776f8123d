#pragma once

#include "limber/certificate/certificate.hpp"

namespace limber {

/// Checks what a plan says of its tube: numbers that a tube can have, and no narrower than the
/// network promises at that level. Appends a failure to `certificate.failures`.
/// @param network  null: the no-load model, which promises none
void check_tube(const Plan& plan, const CompensationModel* network, const ArmDescription& arm,
                Certificate& certificate);

}  // namespace limber
