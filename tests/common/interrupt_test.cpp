#include "limber/common/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {
namespace {

class Interrupt : public ::testing::Test {
 protected:
  void SetUp() override { ::testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_F(Interrupt, TheFirstSignalIsNotedAndTheSecondKills) {
  EXPECT_EXIT(
      {
        install_interrupt_handler();
        std::raise(SIGTERM);
        try {
          throw_if_interrupted();
        } catch (const Interrupted&) {
          std::raise(SIGTERM);
        }
        std::exit(1);
      },
      ::testing::KilledBySignal(SIGTERM), "");
}

/// Whether the kernel says that a thread of this process sleeps.
bool sleeps(pid_t thread) {
  const std::string stat = read_file("/proc/self/task/" + std::to_string(thread) + "/stat");
  return stat.at(stat.rfind(')') + 2) == 'S';
}

// A pipe that nobody writes to: without a signal, read() would never return.
TEST_F(Interrupt, CallsThatBlockComeBack) {
  EXPECT_EXIT(
      {
        install_interrupt_handler();
        ::alarm(60);  // ends a test that failed
        int ends[2];
        if (::pipe(ends) != 0) {
          std::exit(2);
        }
        std::atomic<bool> reads{false};
        const pthread_t reader = ::pthread_self();
        std::thread([&reads, reader, thread = ::gettid()] {
          while (!reads || !sleeps(thread)) {
            ::usleep(1000);
          }
          ::pthread_kill(reader, SIGINT);
        }).detach();
        char byte = 0;
        reads = true;
        const ssize_t count = ::read(ends[0], &byte, 1);
        std::_Exit(count < 0 && errno == EINTR && interrupt_requested() ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(Interrupt, AScopeStopsTheThreadsThatItIsHandedTo) {
  std::atomic<bool> stop{false};
  bool other_stops = true;
  bool handed_stops = false;
  {
    const StopScope scope(&stop);
    EXPECT_FALSE(interrupt_requested());
    stop = true;
    EXPECT_TRUE(interrupt_requested());
    EXPECT_THROW(throw_if_interrupted(), Interrupted);
    {
      const std::atomic<bool> never{false};
      const StopScope inner(&never);
      EXPECT_FALSE(interrupt_requested());
    }
    std::thread([&] { other_stops = interrupt_requested(); }).join();
    std::thread([&, handed = stop_of_thread()] {
      const StopScope there(handed);
      handed_stops = interrupt_requested();
    }).join();
  }
  EXPECT_FALSE(interrupt_requested());
  EXPECT_FALSE(other_stops);
  EXPECT_TRUE(handed_stops);
}

}  // namespace
}  // namespace limber
