#include "limber/common/arm_signals.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "limber/common/interrupt.hpp"
#include "limber/common/standard_streams.hpp"

namespace limber {

/// Static, so that a handler never meets one that is gone. The line is written where the handler
/// does not look, which then looks there.
struct LastWords::Slot {
  struct Line {
    std::array<char, 256> text{};
    std::size_t size = 0;
  };
  std::atomic<bool> is_taken{false};
  std::atomic<int> descriptor{-1};
  std::array<Line, 2> lines{};
  std::atomic<unsigned> current{0};

  static std::array<Slot, 8> all;
};
std::array<LastWords::Slot, 8> LastWords::Slot::all{};

namespace {

using Clock = std::chrono::steady_clock;

/// After the first signal: as long as a vent commonly takes, and what it left is written.
constexpr auto kGrace = std::chrono::seconds(3);

/// All that would end the process, or stop it, but for crashes, SIGKILL and SIGSTOP.
constexpr std::array kStops = {SIGINT,  SIGTERM,   SIGHUP,  SIGQUIT,  SIGTSTP, SIGUSR1,
                               SIGUSR2, SIGPIPE,   SIGALRM, SIGXCPU,  SIGXFSZ, SIGIO,
                               SIGPROF, SIGVTALRM, SIGPWR,  SIGSTKFLT};
constexpr std::array kCrashes = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS};

std::atomic<Clock::rep> first_at{0};

/// For handlers, which may not allocate.
class Message {
 public:
  Message& operator<<(const char* text) {
    const std::size_t length = std::min(std::strlen(text), text_.size() - size_);
    std::memcpy(text_.data() + size_, text, length);
    size_ += length;
    return *this;
  }
  void print() const { print_to_stderr({text_.data(), size_}); }

 private:
  std::array<char, 400> text_{};
  std::size_t size_ = 0;
};

/// Vents as well as a process can that ends now, and says what was done.
void vent_and_say(int number, const char* why) {
  std::signal(SIGPIPE, SIG_IGN);  // of a driver that is gone
  const LastWords::Sent sent = LastWords::send_all();
  const char* name = sigabbrev_np(number);
  Message message;
  message << "error: " << why;
  if (name != nullptr) {
    message << " (SIG" << name << ")";
  }
  if (sent.pipes > 0) {
    message << (sent.lines == sent.pipes ? ": the driver was told to vent, and its input was closed"
                                         : ": the driver's input was closed, so that it vents")
            << "; what came of it was not measured. Look at the arm, and shut off the supply if in "
               "doubt";
  }
  (message << "\n").print();
}

void end_by(int number) {
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  sigemptyset(&usual.sa_mask);
  const int deadly = number == SIGTSTP ? SIGTERM : number;
  sigaction(deadly, &usual, nullptr);
  (void)raise(deadly);  // the handler's own comes when it returns
}

void handle_stop(int number) {
  const int error = errno;
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep before = 0;
  if (first_at.compare_exchange_strong(before, now)) {
    request_interrupt();
  } else if (Clock::duration(now - before) < kGrace) {
    (Message() << "stopping already: the arm is being vented. From 3 s after the first signal on, "
                  "another one ends limber at once\n")
        .print();
  } else {
    vent_and_say(number, "ended at once by another signal");
    end_by(number);
  }
  errno = error;
}

void handle_crash(int number) {
  vent_and_say(number, "limber crashed");
  end_by(number);
}

void set_handler(int number, void (*handler)(int), int flags) {
  struct sigaction before {};
  sigaction(number, nullptr, &before);
  const bool is_free = before.sa_handler == SIG_DFL || number == SIGINT || number == SIGTERM;
  if (!is_free) {  // ignored, as nohup has SIGHUP, or somebody's own
    return;
  }
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = flags;
  sigaction(number, &action, nullptr);
}

/// For a crash by a stack that is full. Of this thread: the one that moves the arm.
void give_handlers_a_stack() {
  static std::array<char, 65536> room;
  const stack_t stack{room.data(), 0, room.size()};
  (void)sigaltstack(&stack, nullptr);
}

}  // namespace

void install_arm_signals() {
  give_handlers_a_stack();
  for (const int number : kStops) {
    set_handler(number, handle_stop, 0);  // without SA_RESTART: calls that block come back
  }
  for (int number = SIGRTMIN; number <= SIGRTMAX; ++number) {
    set_handler(number, handle_stop, 0);
  }
  for (const int number : kCrashes) {
    set_handler(number, handle_crash, int(SA_ONSTACK | SA_RESETHAND));
  }
  for (const int number : {SIGTTIN, SIGTTOU}) {  // a job in the background is not stopped
    set_handler(number, SIG_IGN, 0);
  }
}

LastWords::LastWords(int descriptor) : slot_(nullptr) {
  for (Slot& slot : Slot::all) {
    if (!slot.is_taken.exchange(true)) {
      slot_ = &slot;
      slot_->lines[slot_->current].size = 0;
      slot_->descriptor = descriptor;
      return;
    }
  }
}

LastWords::~LastWords() {
  if (slot_ != nullptr) {
    slot_->descriptor = -1;
    slot_->is_taken = false;
  }
}

void LastWords::prepare(std::string_view line) {
  if (slot_ == nullptr) {
    return;
  }
  const unsigned next = 1U - slot_->current;
  Slot::Line& words = slot_->lines[next];
  words.size = line.size() < words.text.size() ? line.size() + 1 : 0;
  if (words.size > 0) {
    std::copy(line.begin(), line.end(), words.text.begin());
    words.text[line.size()] = '\n';
  }
  slot_->current = next;
}

LastWords::Sent LastWords::send_all() noexcept {
  Sent sent;
  for (Slot& slot : Slot::all) {
    const int descriptor = slot.descriptor.exchange(-1);
    if (descriptor >= 0) {
      const Slot::Line& line = slot.lines[slot.current];
      const ssize_t written = ::write(descriptor, line.text.data(), line.size);
      ::close(descriptor);
      ++sent.pipes;
      sent.lines += written > 0 && std::size_t(written) == line.size ? 1 : 0;
    }
  }
  return sent;
}

}  // namespace limber
