#pragma once

#include <optional>
#include <string>

namespace limber {

// What logs and recordings are both judged by.
inline constexpr double kBaseStandsStill_m = 0.005;  // motion capture is better than that
inline constexpr double kFarBeyond = 1.2;       // of the limit; pressures overshoot by less, …
inline constexpr double kMaxFarBeyond = 0.001;  // … but in this share of rows: spikes happen

/// How many `to` make one `from`: 1 for equal units of any kind; otherwise both must be known
/// lengths (m, cm, mm, in), angles (rad, deg), times (s, ms, us, min) or pressures (kPa, Pa, hPa,
/// mbar, bar, MPa, psi). None if they are not of one kind, or unknown.
std::optional<double> unit_factor(const std::string& from, const std::string& to);

/// A question for a value that is `ratio` times what it should be: "is it in mm?" if a wrong
/// unit of the kind of `unit` explains the ratio within 40 %; empty otherwise.
std::string unit_suspicion(double ratio, const std::string& unit);

}  // namespace limber
