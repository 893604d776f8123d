#pragma once

#include <charconv>
#include <optional>
#include <string_view>

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

}  // namespace limber
