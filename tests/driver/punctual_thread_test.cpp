#include "src/driver/punctual_thread.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace limber {
namespace {

int policy() {
  return sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
}

bool may_raise_priority() {
  bool may = false;
  std::thread([&] {
    sched_param priority = {};
    priority.sched_priority = 1;
    may = sched_setscheduler(0, SCHED_RR, &priority) == 0;
  }).join();
  return may;
}

TEST(PunctualThread, GoesFirstWhileItLivesWhereThatIsAllowed) {
  const bool may = may_raise_priority();
  for (int run = 0; run < 2; ++run) {
    {
      const PunctualThread punctual;
      EXPECT_EQ(policy(), may ? SCHED_RR : SCHED_OTHER) << "run " << run;
    }
    EXPECT_EQ(policy(), SCHED_OTHER) << "run " << run;
  }
}

TEST(PunctualThread, WhatItStartsIsOrdinary) {
  const PunctualThread punctual;
  int started = -1;
  std::thread([&] { started = policy(); }).join();
  EXPECT_EQ(started, SCHED_OTHER);
}

}  // namespace
}  // namespace limber
