#include "limber/common/interrupt.hpp"

#include <csignal>

#include "limber/common/error.hpp"

namespace limber {

namespace {

volatile std::sig_atomic_t requested = 0;

void handle_signal(int /*number*/) {
  requested = 1;
}

}  // namespace

void install_interrupt_handler() {
  struct sigaction action {};
  action.sa_handler = handle_signal;
  sigemptyset(&action.sa_mask);
  // Without SA_RESTART, a call that blocks comes back; and the second signal kills.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
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
