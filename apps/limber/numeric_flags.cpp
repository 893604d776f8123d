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

/// @return what is wrong with `text`; empty if nothing is
std::string check_finite(std::string& text) {
  double value = 0.0;
  return parse_number(text, value) && std::abs(value) <= kMax
             ? ""
             : fmt::format("'{}' found; expected a finite number of at most {}", shortened(text),
                           kMax);
}

std::string check_blanks(std::string& text) {
  return text.find(',') == std::string::npos
             ? ""
             : fmt::format("'{}' found; expected numbers with blanks between them, no commas",
                           shortened(text));
}

/// Rewrites `text` as a plain number, which CLI11 can't take for an octal one.
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

/// Leaves what follows each `=` to the planner, except numbers that are not finite.
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
    const bool is_number = type == "FLOAT" || type == "INT" || type == "UINT";
    if (is_number && option->get_items_expected_max() > 1) {
      option->transform(CLI::Validator(check_blanks, ""));  // comes before those above
    }
  }
}

}  // namespace limber
