// Where recordings are read: a child that crashes, hangs or wants everything gets nothing and harms
// nobody, and what it reads is what the file says.
#include "confined_child.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr ChildLimits kLimits{std::uintmax_t{64} << 20U, 1};  // 64 MB, 1 s

/// What the child writes, until it ends.
std::string text_from(int pipe) {
  std::string text;
  char byte = 0;
  while (::read(pipe, &byte, 1) == 1) {
    text += byte;
  }
  return text;
}

/// Expects bytes that never come.
void wait_for_end(int pipe) {
  (void)text_from(pipe);
  throw EndOfPipe{};
}

void write_nowhere(int /*pipe*/) {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}

TEST(ConfinedChild, CrashesWithAMessageThatNamesTheFile) {
  EXPECT_THAT([] { run_confined("a.h5", kLimits, write_nowhere, wait_for_end); },
              ThrowsMessage<InputError>(
                  HasSubstr("a.h5: reading it crashed (Segmentation fault): the file is damaged, "
                            "or made to do harm; expected a whole recording")));
  EXPECT_THAT(
      [] {
        run_confined(
            "a.h5", kLimits, [](int) { std::abort(); }, wait_for_end);
      },
      ThrowsMessage<InputError>(HasSubstr("a.h5: reading it crashed (")));
}

TEST(ConfinedChild, HasItsMemoryAndTimeAndNoMore) {
  EXPECT_THAT(
      [] {
        run_confined(
            "a.h5", kLimits, [](int) { std::vector<char>(std::size_t{128} << 20U, 'x'); },
            wait_for_end);
      },
      ThrowsMessage<InputError>(HasSubstr("a.h5: reading it needs more than 64 MB of memory")));
  EXPECT_THAT(
      [] {
        run_confined(
            "a.h5", kLimits,
            [](int) {
              for (volatile int i = 0;; i = i + 1) {
              }
            },
            wait_for_end);
      },
      ThrowsMessage<InputError>(HasSubstr("a.h5: reading it took more than 1 s of processor")));
}

TEST(ConfinedChild, OpensNothingStartsNothingAndReachesNobody) {
  const TemporaryFolder folder;
  const std::string mine = (folder.path() / "mine").string();
  const int open_here = ::open(mine.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  ASSERT_GE(open_here, 0);
  std::string found;
  run_confined(
      "a.h5", kLimits,
      [&](int pipe) {
        const auto tell = [&](const char* what, long result) {
          const std::string line = std::string(what) + (result < 0 ? " refused, " : " ALLOWED, ");
          (void)!::write(pipe, line.data(), line.size());
        };
        tell("open", ::open("/etc/passwd", O_RDONLY));
        tell("create", ::open((mine + "2").c_str(), O_CREAT | O_WRONLY, 0600));
        tell("unlink", ::unlink(mine.c_str()));
        tell("socket", ::socket(AF_INET, SOCK_STREAM, 0));
        tell("fork", ::fork());
        tell("kill", ::kill(::getppid(), 0));
        char name[] = "/bin/true";
        char* arguments[] = {name, nullptr};
        tell("exec", ::execv(name, arguments));
        tell("write", ::write(open_here, "x", 1));
        tell("stderr", ::write(STDERR_FILENO, "x", 1));
      },
      [&](int pipe) { found = text_from(pipe); });
  ::close(open_here);
  EXPECT_EQ(found,
            "open refused, create refused, unlink refused, socket refused, fork refused, "
            "kill refused, exec refused, write refused, stderr refused, ");
}

TEST(ConfinedChild, EndsWithWhoReads) {
  EXPECT_THAT(
      [] {
        run_confined(
            "a.h5", {0, 1000},
            [](int) {
              for (volatile int i = 0;; i = i + 1) {
              }
            },
            [](int) { throw InputError("enough"); });
      },
      ThrowsMessage<InputError>(HasSubstr("enough")));
}

}  // namespace
}  // namespace limber
