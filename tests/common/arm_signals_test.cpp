#include "limber/common/arm_signals.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>

#include "limber/common/interrupt.hpp"

namespace limber {
namespace {

/// In a process of its own, that a signal may end.
class ArmSignals : public ::testing::Test {
 protected:
  void SetUp() override {
    ::testing::FLAGS_gtest_death_test_style = "threadsafe";
    ASSERT_EQ(::pipe2(ends_.data(), O_CLOEXEC), 0);
  }
  void TearDown() override { ::close(ends_[0]); }

  /// Runs `body`. @return the status of waitpid
  template <class Body>
  int child(const Body& body) {
    const pid_t process = ::fork();
    if (process == 0) {
      body();
      ::_exit(0);
    }
    ::close(ends_[1]);
    int status = 0;
    ::waitpid(process, &status, 0);
    return status;
  }

  /// What came through the pipe until its end.
  std::string sent() const {
    std::string text;
    std::array<char, 256> bytes;
    for (ssize_t count = 1; count > 0;) {
      count = ::read(ends_[0], bytes.data(), bytes.size());
      text.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return text;
  }

  std::array<int, 2> ends_{};
};

constexpr std::array kEnding = {SIGINT,  SIGTERM, SIGHUP,  SIGQUIT,   SIGTSTP, SIGUSR1, SIGUSR2,
                                SIGPIPE, SIGALRM, SIGPROF, SIGVTALRM, SIGXCPU, SIGIO,   SIGPWR};

TEST_F(ArmSignals, WhatWouldEndTheProcessRequestsAStop) {
  for (const int number : kEnding) {
    EXPECT_EXIT(
        {
          std::signal(number, SIG_DFL);
          install_arm_signals();
          std::raise(number);
          std::_Exit(interrupt_requested() ? 0 : 1);
        },
        ::testing::ExitedWithCode(0), "")
        << number;
  }
}

TEST_F(ArmSignals, ThoseThatFollowAtOnceChangeNothingAndItIsSaid) {
  EXPECT_EXIT(
      {
        install_arm_signals();
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::raise(SIGTERM);
        std::_Exit(interrupt_requested() ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "stopping already: the arm is being vented");
}

TEST_F(ArmSignals, IgnoredOnesStayIgnored) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        install_arm_signals();
        std::raise(SIGHUP);
        std::_Exit(interrupt_requested() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(ArmSignals, ACrashSendsTheLastWordsAndClosesThePipe) {
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) {
    if (number != SIGSEGV) {
      TearDown();
      SetUp();
    }
    const int status = child([&] {
      std::signal(number, SIG_DFL);  // a sanitizer has its own
      install_arm_signals();
      LastWords words(ends_[1]);
      words.prepare("old");
      words.prepare("vent");
      {
        LastWords gone(ends_[1]);
        gone.prepare("of a driver that was closed");
      }
      std::raise(number);
    });
    EXPECT_TRUE(WIFSIGNALED(status)) << number;
    EXPECT_EQ(WTERMSIG(status), number);
    EXPECT_EQ(sent(), "vent\n");
  }
}

}  // namespace
}  // namespace limber
