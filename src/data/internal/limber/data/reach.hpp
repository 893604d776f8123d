#pragma once

namespace limber {

/// A configuration counts as reached if every measured pressure is within this fraction of its
/// segment's limit of the set point: 2 kPa of 100. This is several times a pressure controller's
/// dead band, and far below what moves the arm by a centimetre.
inline constexpr double kReachTolerance = 0.02;

}  // namespace limber
