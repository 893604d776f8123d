#pragma once

#include <string>
#include <string_view>

namespace limber {

/// `text` fit for XML content and attributes: &, <, >, " and ' are escaped; bytes that are no
/// UTF-8, and control characters that XML 1.0 forbids, become U+FFFD.
std::string escape_xml(std::string_view text);

/// A pixel coordinate with at most two decimals and no trailing zeros: 12.3400001 → "12.34", never
/// in the exponent form. @param value finite; else std::logic_error, as it is our own bug.
std::string svg_number(double value);

}  // namespace limber
