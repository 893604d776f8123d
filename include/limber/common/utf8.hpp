#pragma once

#include <cstddef>
#include <string_view>

namespace limber {

/// Place of the first byte that is no UTF-8 (RFC 3629: no overlong forms, no surrogates), or npos.
std::size_t find_invalid_utf8(std::string_view text);

inline bool is_utf8(std::string_view text) {
  return find_invalid_utf8(text) == std::string_view::npos;
}

}  // namespace limber
