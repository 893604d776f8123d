#include "limber/common/standard_streams.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>

#include "limber/common/progress.hpp"

namespace limber {
namespace {

/// In a process of its own, whose streams may be spoilt.
class StandardStreams : public ::testing::Test {
 protected:
  void SetUp() override { ::testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

void say_much() {
  for (int i = 0; i < 1000; ++i) {
    print_to_stderr("a line that is lost\n");
    Progress("task", "units", 1).advance();
  }
  std::exit(0);
}

TEST(PrintToStderr, WritesTheTextAsItIs) {
  ::testing::internal::CaptureStderr();
  print_to_stderr("one {} %s\n");
  print_to_stderr("");
  print_to_stderr("two");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "one {} %s\ntwo");
}

TEST_F(StandardStreams, MessagesAreLostWhereStandardErrorIsClosed) {
  EXPECT_EXIT(
      {
        ::close(STDERR_FILENO);
        say_much();
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(StandardStreams, MessagesAreLostWhereStandardErrorIsFull) {
  EXPECT_EXIT(
      {
        ::dup2(::open("/dev/full", O_WRONLY), STDERR_FILENO);
        say_much();
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(StandardStreams, MessagesAreLostWhereNobodyReadsStandardError) {
  EXPECT_EXIT(
      {
        int ends[2];
        if (::pipe(ends) == 0 && ::dup2(ends[1], STDERR_FILENO) == STDERR_FILENO) {
          ::close(ends[0]);
          say_much();
        }
      },
      ::testing::ExitedWithCode(0), "");
}

// As `2>&1 | less` is, or a terminal at Ctrl-S.
TEST_F(StandardStreams, MessagesAreLostWhereTheReaderOfStandardErrorSleeps) {
  EXPECT_EXIT(
      {
        ::alarm(60);  // ends a test that failed
        int ends[2];
        if (::pipe(ends) == 0 && ::dup2(ends[1], STDERR_FILENO) == STDERR_FILENO) {
          for (int i = 0; i < 10; ++i) {
            print_to_stderr(std::string(20000, 'x') + "\n");
          }
          // Others who hold the pipe wait for it as before.
          std::_Exit(::fcntl(ends[1], F_GETFL) & O_NONBLOCK);
        }
      },
      ::testing::ExitedWithCode(0), "");
}

// A message that was lost must not take the signal of a pipe of the caller's own along.
TEST_F(StandardStreams, OtherBrokenPipesStillEndTheProcess) {
  EXPECT_EXIT(
      {
        int ends[2];
        if (::pipe(ends) == 0) {
          ::close(ends[0]);
          ::close(STDERR_FILENO);
          print_to_stderr("lost");
          (void)!::write(ends[1], "x", 1);
        }
      },
      ::testing::KilledBySignal(SIGPIPE), "");
}

TEST_F(StandardStreams, MissingOnesAreOpenedAndLaterFilesGetOtherNumbers) {
  EXPECT_EXIT(
      {
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
          ::close(stream);
        }
        open_missing_standard_streams();
        const int file = ::open("/dev/zero", O_RDONLY);
        struct stat null {};
        struct stat found {};
        ::stat("/dev/null", &null);
        int right = file > STDERR_FILENO ? 0 : 1;
        for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
          right |= ::fstat(stream, &found) == 0 && found.st_rdev == null.st_rdev ? 0 : 1;
        }
        std::_Exit(right);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(StandardStreams, ThoseThatAreOpenStayAsTheyAre) {
  struct stat before {};
  struct stat after {};
  ASSERT_EQ(::fstat(STDOUT_FILENO, &before), 0);
  open_missing_standard_streams();
  ASSERT_EQ(::fstat(STDOUT_FILENO, &after), 0);
  EXPECT_EQ(before.st_ino, after.st_ino);
}

}  // namespace
}  // namespace limber
