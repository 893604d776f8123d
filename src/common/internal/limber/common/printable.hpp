#pragma once

#include <string>
#include <string_view>

namespace limber {

/// `text` made safe for a terminal: everything that would command the terminal instead of being
/// shown is escaped. Control characters but line end and tab, and bytes that are not UTF-8, become
/// \x1b; characters that turn the direction of writing become \u202e.
std::string printable(std::string_view text);

/// The same for JSON, with JSON's own escapes: control characters that JSON lets through (DEL and
/// U+0080 to U+009F) and those that turn the direction of writing become \u009b.
std::string printable_json(std::string_view json);

/// What somebody else says, within a sentence: line feeds, tabs and their like are blanks, and what
/// is longer than `max_bytes` is cut.
std::string in_one_line(std::string_view text, std::size_t max_bytes = 200);

}  // namespace limber
