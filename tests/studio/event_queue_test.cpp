#include "src/studio/event_queue.hpp"

#include <gtest/gtest.h>

namespace limber {
namespace {

constexpr std::chrono::milliseconds kNoWait{0};

TEST(EventQueue, KeepsOrderAndOfEachKindTheNewest) {
  EventQueue queue;
  queue.push("progress", "1");
  queue.push("plan", "2");
  queue.push("progress", "3");
  EXPECT_EQ(queue.pop(kNoWait), "event: plan\ndata: 2\n\n");
  EXPECT_EQ(queue.pop(kNoWait), "event: progress\ndata: 3\n\n");
  EXPECT_EQ(queue.pop(kNoWait), "");
}

}  // namespace
}  // namespace limber
