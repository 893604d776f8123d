#include "limber/common/interrupt.hpp"

#include <csignal>

#include "limber/common/error.hpp"

namespace limber {

namespace {

volatile std::sig_atomic_t requested = 0;

void handle_signal(int signal_number) {
  requested = 1;
  std::signal(signal_number, SIG_DFL);  // the second one kills
}

}  // namespace

void install_interrupt_handler() {
  std::signal(SIGINT, handle_signal);
  std::signal(SIGTERM, handle_signal);
}

bool interrupt_requested() {
  return requested != 0;
}

void throw_if_interrupted() {
  if (interrupt_requested()) {
    throw Interrupted("stopped on request");
  }
}

}  // namespace limber
