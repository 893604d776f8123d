#pragma once

#include <CLI/CLI.hpp>

namespace limber {

/// Refuses a command line on which a file to be written is also read, or written twice, or one that
/// is read lies in the folder that `demo` or `experiment` fill: the work would be lost, or its
/// input. Files to be written are the values of the options named in the
/// source; whatever else names an existing file is read. Paths are compared as files, so links and
/// detours don't hide them. @throws InputError naming both options and the file.
void require_distinct_files(const CLI::App& command);

}  // namespace limber
