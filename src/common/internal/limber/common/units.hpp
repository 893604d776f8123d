#pragma once

namespace limber {

/// limber computes in kPa, m, rad and s; other units appear only in tables that are compared with
/// the paper's.
inline constexpr double kKpaPerPsi = 6.894757;
inline constexpr double kCmPerM = 100.0;

}  // namespace limber
