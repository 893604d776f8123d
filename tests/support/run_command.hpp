#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace limber {

struct CommandResult {
  int code = -1;       ///< exit code, −1 if a signal ended it
  std::string output;  ///< standard output and error together
};

/// Runs a shell command and waits for it.
inline CommandResult run_command(const std::string& command) {
  CommandResult result;
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::array<char, 256> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    result.output += buffer.data();
  }
  const int status = ::pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

}  // namespace limber
