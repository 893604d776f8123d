#include "limber/common/utf8.hpp"

#include <utf8cpp/utf8/checked.h>

namespace limber {

std::size_t find_invalid_utf8(std::string_view text) {
  const auto found = utf8::find_invalid(text.begin(), text.end());
  return found == text.end() ? std::string_view::npos
                             : static_cast<std::size_t>(found - text.begin());
}

std::string shortened(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) {
    return std::string(text);
  }
  const std::string_view cut = text.substr(0, max_bytes);
  return std::string(cut.substr(0, find_invalid_utf8(cut))) + "…";
}

}  // namespace limber
