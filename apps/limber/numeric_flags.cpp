#include "numeric_flags.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "limber/common/csv_reader.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

constexpr double kMax = 1e15;  // in kPa, m, s, Hz, rad: nothing real comes near

/// @return what is wrong with `text`; empty where nothing is
std::string check_finite(std::string& text) {
  double value = 0.0;
  return parse_number(text, value) && std::abs(value) <= kMax
             ? ""
             : fmt::format("'{}' found; expected a finite number of at most {}", shortened(text),
                           kMax);
}

/// Rewrites `text` in its plainest spelling, which CLI11 can't take for an octal number.
template <class Whole>
std::string check_whole(std::string& text) {
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* last = text.data() + text.size();
  Whole value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last) {
    return fmt::format("'{}' found; expected a whole number from {} to {}", shortened(text),
                       std::numeric_limits<Whole>::min(), std::numeric_limits<Whole>::max());
  }
  text = fmt::format("{}", value);
  return "";
}

/// What follows each `=` is left to the planner, but for numbers that are none.
std::string check_planner(const std::string& text) {
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const std::string value = text.substr(at + 1, text.find(',', at) - at - 1);
    const std::optional<double> number = number_in(value);
    if (number && !std::isfinite(*number)) {
      return fmt::format("setting '{}' found; expected a finite number", shortened(value));
    }
  }
  return "";
}

}  // namespace

void require_plain_numbers(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    const std::string type = option->get_type_name().substr(0, option->get_type_name().find(':'));
    if (type == "FLOAT") {
      option->transform(CLI::Validator(check_finite, ""));
    } else if (type == "INT") {
      option->transform(CLI::Validator(check_whole<std::int64_t>, ""));
    } else if (type == "UINT") {
      option->transform(CLI::Validator(check_whole<std::uint64_t>, ""));
    } else if (option->check_name("--planner")) {
      option->check(check_planner);
    }
  }
}

}  // namespace limber
