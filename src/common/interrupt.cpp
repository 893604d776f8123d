#include "limber/common/interrupt.hpp"

#include <csignal>

#include "limber/common/error.hpp"

namespace limber {

namespace {

volatile std::sig_atomic_t requested = 0;
thread_local const std::atomic<bool>* stop = nullptr;

void handle_signal(int /*number*/) {
  request_interrupt();
}

/// Without SA_RESTART, a call that blocks comes back; and the second signal has its usual effect.
void request_stop_at(int number) {
  struct sigaction action {};
  action.sa_handler = handle_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = int(SA_RESETHAND);
  sigaction(number, &action, nullptr);
}

}  // namespace

void install_interrupt_handler() {
  request_stop_at(SIGINT);
  request_stop_at(SIGTERM);
}

void request_interrupt() noexcept {
  requested = 1;
}

bool interrupt_requested() {
  return requested != 0 || (stop != nullptr && stop->load(std::memory_order_relaxed));
}

void throw_if_interrupted() {
  if (interrupt_requested()) {
    throw Interrupted("stopped on request");
  }
}

void throw_if_interrupted(const std::function<bool()>& should_stop) {
  throw_if_interrupted();
  if (should_stop && should_stop()) {
    throw Interrupted("stopped on request");
  }
}

StopScope::StopScope(const std::atomic<bool>* own) : before_(stop) {
  stop = own;
}

StopScope::~StopScope() {
  stop = before_;
}

const std::atomic<bool>* stop_of_thread() {
  return stop;
}

}  // namespace limber
