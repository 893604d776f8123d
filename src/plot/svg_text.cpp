#include "limber/plot/svg_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "limber/common/utf8.hpp"

namespace limber {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

constexpr std::array<std::pair<char, std::string_view>, 5> kEscapes = {
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

/// Bytes of the character that starts `text`, or 0 if XML has no such one: it is no UTF-8, or
/// U+FFFE or U+FFFF.
std::size_t character_length(std::string_view text) {
  constexpr std::size_t kLongest = 4;
  const bool is_none = find_invalid_utf8(text.substr(0, kLongest)) == 0 ||
                       text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
  const int leading_ones = std::countl_one(std::uint8_t(text.front()));
  return is_none ? 0 : std::size_t(std::max(1, leading_ones));
}

std::string_view escaped(std::string_view character) {
  const char first = character.front();
  for (const auto& [special, escape] : kEscapes) {
    if (first == special) {
      return escape;
    }
  }
  const bool is_control = std::uint8_t(first) < 0x20 && first != '\n' && first != '\t';
  return is_control ? kReplacement : character;
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    out += length == 0 ? kReplacement : escaped(text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return out;
}

std::string svg_number(double value) {
  if (!std::isfinite(value)) {
    throw std::logic_error("svg_number: the value is not finite");
  }
  // The longest double has 309 digits before the point.
  std::array<char, 320> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, 2);
  std::string text(buffer.data(), end.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace limber
