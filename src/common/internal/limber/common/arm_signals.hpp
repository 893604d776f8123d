#pragma once

namespace limber {

/// Whoever moves an arm stops at more than Ctrl-C and SIGTERM: a terminal that goes away (SIGHUP,
/// unless it is ignored) and Ctrl-Z (SIGTSTP) request a stop too, so that the arm is vented. A
/// program that was stopped in mid-motion could not vent it.
void install_arm_signals();

}  // namespace limber
