#include "limber/common/utf8.hpp"

#include <fmt/format.h>
#include <utf8cpp/utf8/checked.h>

namespace limber {

std::size_t find_invalid_utf8(std::string_view text) {
  const auto found = utf8::find_invalid(text.begin(), text.end());
  return found == text.end() ? std::string_view::npos : std::size_t(found - text.begin());
}

std::string with_other_bytes_escaped(std::string text) {
  std::size_t end = find_invalid_utf8(text);
  if (end == std::string_view::npos) {
    return text;
  }
  std::string escaped;
  std::string_view rest = text;
  while (end != std::string_view::npos) {
    escaped += rest.substr(0, end);
    escaped += fmt::format("\\x{:02x}", static_cast<unsigned char>(rest[end]));
    rest.remove_prefix(end + 1);
    end = find_invalid_utf8(rest);
  }
  return escaped += rest;
}

std::string shortened(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) {
    return std::string(text);
  }
  const std::string_view cut = text.substr(0, max_bytes);
  return std::string(cut.substr(0, find_invalid_utf8(cut))) + "…";
}

}  // namespace limber
