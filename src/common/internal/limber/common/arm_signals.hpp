#pragma once

#include <string_view>

namespace limber {

/// Whoever moves an arm has it vented whatever signal comes; docs/hardware.md has the table.
/// Every signal that would end or stop the process requests a stop, as Ctrl-C does. Those that
/// follow within 3 s change nothing, so that they don't cut the vent short; a later one sends the
/// LastWords and ends the process. Crashes (SIGSEGV, SIGABRT ...) send them and end it.
/// But for Ctrl-C and SIGTERM, signals that are ignored or handled already stay so.
void install_arm_signals();

/// What a process that a signal ends still sends: one line into a pipe, which it then closes.
/// Without install_arm_signals nothing is sent. At most eight exist at a time, others do nothing.
/// Threads: one at a time; signals come in any.
class LastWords {
 public:
  /// @param descriptor  of the pipe, which does not block; open as long as this exists
  explicit LastWords(int descriptor);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

  /// Replaces the line. It gets its end; one of more than 250 bytes is none.
  void prepare(std::string_view line);

  struct Sent {
    int pipes = 0;  ///< that were open, and are closed now
    int lines = 0;  ///< that they took
  };
  /// Safe in signal handlers.
  static Sent send_all() noexcept;

 private:
  struct Slot;
  Slot* slot_;
};

}  // namespace limber
