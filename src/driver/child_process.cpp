#include "child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <cerrno>
#include <optional>
#include <system_error>
#include <thread>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/standard_streams.hpp"

namespace limber {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

constexpr auto kUntilLeft = std::chrono::milliseconds(1000);  // what was killed ends at once

std::atomic<bool> any_survivor{false};

/// Both ends of a pipe; closed unless taken.
struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw SystemFault(
          fmt::format("no pipe to the driver: {}", std::generic_category().message(errno)));
    }
    read_end = ends[0];
    write_end = ends[1];
  }
  ~Pipe() {
    ::close(read_end);
    ::close(write_end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int read_end = -1;
  int write_end = -1;
};

int own_copy(int descriptor) {
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 3);
  if (copy < 0 || ::fcntl(copy, F_SETFL, O_NONBLOCK) != 0) {  // writing may not block limber
    throw SystemFault(
        fmt::format("no pipe to the driver: {}", std::generic_category().message(errno)));
  }
  return copy;
}

/// What a program inherits from limber, but for its standard streams, is nothing.
struct SpawnRules {
  SpawnRules(int child_input, int child_output) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, child_input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, child_output, STDOUT_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&attributes, &all);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
  }
  ~SpawnRules() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnRules(const SpawnRules&) = delete;
  SpawnRules& operator=(const SpawnRules&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

}  // namespace

std::vector<std::string> command_words(const std::string& command) {
  std::vector<std::string> words;
  std::optional<std::string> word;
  char quote = 0;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (quote == 0 && is_blank(c)) {
      if (word) {
        words.push_back(std::move(*word));
        word.reset();
      }
      continue;
    }
    if (!word) {
      word.emplace();
    }
    const char next = i + 1 < command.size() ? command[i + 1] : '\0';
    if (c == '\\' && next != '\0' &&
        (quote == 0 || (quote == '"' && (next == '"' || next == '\\')))) {
      *word += next;
      ++i;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    } else {
      *word += c;
    }
  }
  refuse_if(quote != 0, "--driver exec:{}: a quote ({}) has no end", command, quote);
  if (word) {
    words.push_back(std::move(*word));
  }
  refuse_if(
      words.empty(),
      "--driver exec: no command found; expected exec:COMMAND, as in \"exec:python3 driver.py\"");
  return words;
}

ChildProcess::ChildProcess(const std::vector<std::string>& words, std::size_t max_line) {
  const Pipe to_child;
  const Pipe from_child;
  start(words, to_child.read_end, from_child.write_end);
  try {
    input_ = own_copy(to_child.write_end);
    output_.emplace(own_copy(from_child.read_end), max_line);
  } catch (...) {
    kill_group();
    close_input();
    throw;
  }
}

void ChildProcess::start(const std::vector<std::string>& words, int child_input, int child_output) {
  const SpawnRules rules(child_input, child_output);
  std::vector<char*> arguments;
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));  // posix_spawnp leaves them as they are
  }
  arguments.push_back(nullptr);
  const int error = ::posix_spawnp(&process_, arguments.front(), &rules.actions, &rules.attributes,
                                   arguments.data(), environ);
  if (error != 0) {
    process_ = -1;
    throw InputError(fmt::format("--driver exec: '{}' can't be started: {}", words.front(),
                                 std::generic_category().message(error)));
  }
}

ChildProcess::~ChildProcess() {
  close_input();
  kill_group();
}

bool ChildProcess::write_line(std::string_view line, Clock::time_point deadline) {
  std::string text(line);
  text += '\n';
  std::string_view left = text;
  WithoutBrokenPipe guard;
  while (input_ >= 0 && !left.empty()) {
    const ssize_t written = ::write(input_, left.data(), left.size());
    if (written >= 0) {
      left.remove_prefix(std::size_t(written));
    } else if (errno == EAGAIN) {
      if (!wait_for_descriptor(input_, POLLOUT, deadline)) {
        return false;
      }
    } else if (errno != EINTR) {
      guard.note(errno);
      return false;
    }
  }
  return left.empty();
}

void ChildProcess::close_input() {
  if (input_ >= 0) {
    ::close(input_);
    input_ = -1;
  }
}

bool ChildProcess::wait_for_end(Clock::time_point deadline) {
  constexpr auto kLook = std::chrono::milliseconds(2);
  while (ended_.empty() && process_ > 0) {
    siginfo_t info{};
    // WNOWAIT: until kill_group, the group's number stays its own.
    const int found =
        ::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
    if (found != 0 && errno == ECHILD) {  // who started limber ignores SIGCHLD
      ended_ = "ended";
      break;
    }
    if (found == 0 && info.si_pid == process_) {
      ended_ = info.si_code == CLD_EXITED ? fmt::format("ended with exit code {}", info.si_status)
                                          : fmt::format("was killed by signal {}", info.si_status);
      break;
    }
    if (Clock::now() >= deadline) {
      return false;
    }
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

void ChildProcess::kill_group() {
  if (process_ <= 0) {
    return;
  }
  ::kill(-process_, SIGKILL);
  const bool is_protected =  // it may have left its group
      ::kill(process_, SIGKILL) != 0 && errno == EPERM;
  if (ended_.empty() && wait_for_end(Clock::now() + kUntilLeft)) {
    ended_ = "was killed by limber";
  }
  if (ended_.empty()) {
    survivor_ = {process_, is_protected};
    any_survivor = true;
  } else {
    ::waitpid(process_, nullptr, WNOHANG);
  }
  process_ = -1;
}

bool ChildProcess::was_any_left() {
  return any_survivor;
}

}  // namespace limber
