#pragma once

#include <string_view>

namespace limber {

/// Writes `text` to standard error as it is. Messages never decide what becomes of the work: where
/// standard error is closed, full or a pipe that nobody reads, they are lost and nothing else.
/// Threads: any.
void print_to_stderr(std::string_view text) noexcept;

/// Opens /dev/null in place of standard streams that are closed, lest a file that is opened later
/// gets their number and the messages. To be called first of all.
void open_missing_standard_streams() noexcept;

}  // namespace limber
