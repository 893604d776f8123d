#include "limber/common/interrupt.hpp"

#include <csignal>

#include "limber/common/arm_signals.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

volatile std::sig_atomic_t requested = 0;

void handle_signal(int /*number*/) {
  requested = 1;
}

/// Without SA_RESTART, a call that blocks comes back; and the second signal has its usual effect.
void request_stop_at(int number) {
  struct sigaction action {};
  action.sa_handler = handle_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(number, &action, nullptr);
}

}  // namespace

void install_interrupt_handler() {
  request_stop_at(SIGINT);
  request_stop_at(SIGTERM);
}

void install_arm_signals() {
  install_interrupt_handler();
  request_stop_at(SIGTSTP);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) {  // as nohup has it
    request_stop_at(SIGHUP);
  }
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
