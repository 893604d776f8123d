#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limber {

/// Index of the first byte that is not UTF-8 (RFC 3629: no overlong forms, no surrogates), or npos.
std::size_t find_invalid_utf8(std::string_view text);

inline bool is_utf8(std::string_view text) {
  return find_invalid_utf8(text) == std::string_view::npos;
}

/// `text` with every byte that is not UTF-8 written out as \x82: it can be quoted then.
std::string with_other_bytes_escaped(std::string text);

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// `text` as messages quote it: at most `max_bytes`, no character cut, and "…" if some are left
/// out.
std::string shortened(std::string_view text, std::size_t max_bytes = 40);

}  // namespace limber
