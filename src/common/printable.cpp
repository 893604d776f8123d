#include "limber/common/printable.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <utf8cpp/utf8/checked.h>

#include "limber/common/utf8.hpp"

namespace limber {

namespace {

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

/// Unicode's embeddings, overrides, isolates and marks of direction; and what is no character.
bool is_misleading(std::uint32_t code) {
  return (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) ||
         code == 0x200E || code == 0x200F || code == 0xFFFE || code == 0xFFFF;
}

/// @param text       in UTF-8
/// @param format_of  how a character is written out, "\\x{:02x}"; nullptr: it is shown
template <class FormatOf>
std::string with_escapes(std::string_view text, const FormatOf& format_of) {
  std::string shown;
  shown.reserve(text.size());
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = at;
    const std::uint32_t code = utf8::next(at, text.end());
    const char* const format = format_of(code);
    shown += format != nullptr ? fmt::format(fmt::runtime(format), code) : std::string(begin, at);
  }
  return shown;
}

}  // namespace

std::string printable(std::string_view text) {
  return with_escapes(with_other_bytes_escaped(std::string(text)), [](std::uint32_t code) {
    return is_misleading(code)                                ? "\\u{:04x}"
           : is_control(code) && code != '\n' && code != '\t' ? "\\x{:02x}"
                                                              : nullptr;
  });
}

std::string in_one_line(std::string_view text, std::size_t max_bytes) {
  std::string line = shortened(text, max_bytes);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return line;
}

std::string printable_json(std::string_view json) {
  return with_escapes(json, [](std::uint32_t code) {
    return is_misleading(code) || (code >= 0x7F && code < 0xA0) ? "\\u{:04x}" : nullptr;
  });
}

}  // namespace limber
