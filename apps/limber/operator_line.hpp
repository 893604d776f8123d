#pragma once

#include <string>

namespace limber {

/// A line from standard input, without its end. Ctrl-C is seen while it waits.
/// @throws Interrupted, also at the end of the input: then nobody is there.
std::string operator_line();

}  // namespace limber
