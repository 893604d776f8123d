#include "limber/common/printable.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "limber/common/utf8.hpp"

namespace limber {

namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< in bytes
};

/// The first of valid UTF-8.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  std::uint32_t code = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  return {code, length};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

/// Unicode's embeddings, overrides, isolates and marks of direction; and what is no character.
bool is_misleading(std::uint32_t code) {
  return (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) ||
         code == 0x200E || code == 0x200F || code == 0xFFFE || code == 0xFFFF;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    constexpr std::size_t kLongest = 4;  // bytes of a character
    if (find_invalid_utf8(text.substr(0, kLongest)) == 0) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
      text.remove_prefix(1);
      continue;
    }
    const auto [code, length] = first_character(text);
    if (is_misleading(code)) {
      shown += fmt::format("\\u{:04x}", code);
    } else if (is_control(code) && code != '\n' && code != '\t') {
      shown += fmt::format("\\x{:02x}", code);
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return shown;
}

std::string in_one_line(std::string_view text, std::size_t max_bytes) {
  std::string line = shortened(text, max_bytes);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return line;
}

std::string printable_json(std::string_view json) {
  std::string shown;
  shown.reserve(json.size());
  while (!json.empty()) {
    const auto [code, length] = first_character(json);
    if (is_misleading(code) || (code >= 0x7F && code < 0xA0)) {
      shown += fmt::format("\\u{:04x}", code);
    } else {
      shown += json.substr(0, length);
    }
    json.remove_prefix(length);
  }
  return shown;
}

}  // namespace limber
