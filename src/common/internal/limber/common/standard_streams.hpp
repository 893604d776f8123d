#pragma once

#include <string_view>

namespace limber {

/// Writes `text` to standard error as it is. Messages never affect the work: if standard error is
/// closed or full, or nobody reads it, they are lost, and nothing waits for longer than 20 ms.
/// Threads: any; safe in signal handlers.
void print_to_stderr(std::string_view text) noexcept;

/// Opens /dev/null in place of standard streams that are closed. Otherwise a file that is opened
/// later would get their number and the messages. Call this before anything else.
void open_missing_standard_streams() noexcept;

}  // namespace limber
