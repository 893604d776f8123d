#pragma once

#include <string>
#include <string_view>

namespace limber {

/// `text` as it may go to a terminal: whatever would command the terminal instead of being shown is
/// spelled out. Control characters but line end and tab, and bytes that are no UTF-8, become \x1b;
/// characters that turn the direction of writing become \u202e.
std::string printable(std::string_view text);

/// The same of JSON, in JSON's own spelling: control characters that JSON lets through (DEL and
/// U+0080 to U+009F) and those that turn the direction of writing become \u009b.
std::string printable_json(std::string_view json);

}  // namespace limber
