#pragma once

#include <CLI/CLI.hpp>

namespace limber {

/// Refuses a command line if a file to be written is also read or is written twice, or if a file to
/// be read lies in the folder that `demo` or `experiment` fill: the
/// work or its input would be lost. Files to be written are the values of the
/// options named in the source; any other value that names an existing file is
/// read. Paths are compared as files, so links and detours don't hide them.
/// @throws InputError naming both options and the file.
void require_distinct_files(const CLI::App& command);

}  // namespace limber
