#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace limber {

/// The number that the whole of `text` is, with a decimal point whatever the locale; "inf" and
/// "nan" are numbers here. None if it is not a number, or holds anything else.
template <class Number = double>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

/// The whole of `text` as a number ("1e-3", "+2.5", ".5"); false if it is none or not finite.
inline bool parse_number(std::string_view text, double& value) {
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  const std::optional<double> number = number_in(text);
  if (!number || !std::isfinite(*number)) {
    return false;
  }
  value = *number;
  return true;
}

/// The same on every machine: fits differ in their last digits.
inline double seven_digits(double value) {
  return number_in(fmt::format("{:.7g}", value)).value_or(value);
}

}  // namespace limber
