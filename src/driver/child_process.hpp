#pragma once

#include <sys/types.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limber/driver/line_reader.hpp"

namespace limber {

/// The words of a command line, by the shell's simplest rules and without a shell: words are
/// separated by blanks; '…' keeps everything, "…" all but \" and \\, and outside of quotes a
/// backslash keeps the next character. Nothing else is special: no variables, no pipes, no ~.
/// @throws InputError where there is no word or a quote has no end.
std::vector<std::string> command_words(const std::string& command);

/// A program that is spoken to line by line over its standard input and output; its standard error
/// is limber's. It runs in a process group of its own, so that Ctrl-C reaches limber alone.
/// Threads: one at a time.
class ChildProcess {
 public:
  using Clock = LineReader::Clock;

  /// @throws InputError where the program can't be started, naming it and the system's reason.
  ChildProcess(const std::vector<std::string>& words, std::size_t max_line);
  /// Closes its input and kills its process group at once.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes `line` and its end. @return whether all of it was taken before `deadline`.
  bool write_line(std::string_view line, Clock::time_point deadline);

  /// Its standard output.
  LineReader& output() { return *output_; }

  /// The program reads the end of its input.
  void close_input();

  /// @return whether it has ended by `deadline`; `how_it_ended` then says how.
  bool wait_for_end(Clock::time_point deadline);

  /// Kills it, and every process of its group, those that outlive their leader too. What can't be
  /// killed, as it is another user's, is left after a second.
  void kill_group();

  struct Survivor {
    pid_t process = -1;
    bool is_protected = false;  ///< it may not be killed; else it was, and is slow to end
  };
  /// Itself, where it was left.
  const std::optional<Survivor>& survivor() const { return survivor_; }
  /// Whether any of this process's was.
  static bool was_any_left();

  /// Its standard input, our end; -1 once closed.
  int input() const { return input_; }

  /// "ended with exit code 3", "was killed by signal 9", "runs".
  std::string how_it_ended() const { return ended_.empty() ? "runs" : ended_; }

 private:
  void start(const std::vector<std::string>& words, int child_input, int child_output);

  pid_t process_ = -1;
  int input_ = -1;                    // its standard input, our end
  std::optional<LineReader> output_;  // its standard output, our end
  std::string ended_;                 // how; empty while it runs
  std::optional<Survivor> survivor_;
};

}  // namespace limber
