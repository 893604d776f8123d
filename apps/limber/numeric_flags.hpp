#pragma once

#include <CLI/CLI.hpp>

namespace limber {

/// Gives every option of `command` that takes numbers a check that runs before all others: the
/// value has to be one plain decimal number within its type, or of at most 1e15 if it may have
/// fractions. (CLI11 accepts nan, inf, hexadecimal and octal numbers, and clamps numbers that are
/// too large.) Settings of planners, `NAME,key=value`, have to be finite too.
void require_plain_numbers(CLI::App& command);

}  // namespace limber
