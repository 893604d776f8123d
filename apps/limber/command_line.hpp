#pragma once

namespace CLI {
class App;
}

namespace limber {

struct CommonFlags;

/// The whole program: parses the command line, runs one verb, prints errors. Returns the exit code
/// (0 done, 1 no solution or a failed check, 2 bad input or usage, 3 a driver or system fault).
int run_command_line(int argc, char** argv);

/// The flags that every verb has.
void add_common_flags(CLI::App& app, CommonFlags& flags);

}  // namespace limber
