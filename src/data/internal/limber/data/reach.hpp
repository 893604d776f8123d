#pragma once

namespace limber {

/// A configuration counts as reached where every measured pressure is within this fraction of its
/// segment's limit from the set point: 2 kPa of 100, several times what a pressure controller's
/// dead band leaves and far below what moves the arm by a centimetre.
inline constexpr double kReachTolerance = 0.02;

}  // namespace limber
