#include "operator_line.hpp"

#include <poll.h>
#include <unistd.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

std::string operator_line() {
  constexpr int kPollMs = 100;
  constexpr std::size_t kMaxLine = 1000;
  std::string line;
  while (line.size() < kMaxLine) {
    throw_if_interrupted();
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, kPollMs) <= 0) {
      continue;
    }
    char letter = 0;
    if (::read(STDIN_FILENO, &letter, 1) != 1) {
      throw Interrupted(
          "stopped: standard input ended, so nobody confirmed the next step; --yes confirms all");
    }
    if (letter == '\n') {
      return line;
    }
    line += letter;
  }
  return line;
}

}  // namespace limber
