#pragma once

#include <numbers>

namespace limber {

/// limber computes in kPa, m, rad and s; other units appear in what people read, and in what other
/// programs write.
inline constexpr double kKpaPerPsi = 6.894757;
inline constexpr double kCmPerM = 100.0;
inline constexpr double kMmPerM = 1000.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;
inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;

}  // namespace limber
