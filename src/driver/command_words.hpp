#pragma once

#include <string>
#include <vector>

namespace limber {

/// The words of a command line, by the shell's simplest rules and without a shell: words are
/// separated by blanks; '…' keeps everything, "…" all but \" and \\, and outside of quotes a
/// backslash keeps the next character. Nothing else is special: no variables, no pipes, no ~.
/// @throws InputError where there is no word or a quote has no end.
std::vector<std::string> command_words(const std::string& command);

}  // namespace limber
