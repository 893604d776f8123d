#pragma once

#include <CLI/CLI.hpp>

namespace limber {

/// Gives every option of `command` that takes numbers a check of its own, before all others: what
/// is given has to be one plain decimal number within its type, or of at most 1e15 with fractions.
/// (CLI11 takes nan, inf, hexadecimal and octal numbers, and makes the largest one of what is too
/// large.) Settings of planners, `NAME,key=value`, have to be finite too.
void require_plain_numbers(CLI::App& command);

}  // namespace limber
