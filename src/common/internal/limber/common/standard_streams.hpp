#pragma once

#include <string_view>

namespace limber {

/// Writes `text` to standard error as it is. Messages never affect the work: if standard error is
/// closed, full or a pipe that nobody reads, only the messages are lost.
/// Threads: any.
void print_to_stderr(std::string_view text) noexcept;

/// Opens /dev/null in place of standard streams that are closed. Otherwise a file that is opened
/// later would get their number and the messages. Call this before anything else.
void open_missing_standard_streams() noexcept;

}  // namespace limber
