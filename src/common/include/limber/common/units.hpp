#pragma once
// For everyone.

namespace limber {

/// limber computes in kPa, m, rad and s; the other units appear only in tables set beside the
/// paper's.
inline constexpr double kKpaPerPsi = 6.894757;
inline constexpr double kCmPerM = 100.0;

}  // namespace limber
