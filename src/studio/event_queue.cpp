#include "event_queue.hpp"

#include <fmt/format.h>

namespace limber {

void EventQueue::push(const std::string& kind, std::string json) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(waiting_, [&](const auto& one) { return one.first == kind; });
    waiting_.emplace_back(kind, std::move(json));
  }
  has_event_.notify_one();
}

std::string EventQueue::pop(std::chrono::milliseconds wait) {
  std::unique_lock lock(mutex_);
  if (!has_event_.wait_for(lock, wait, [this] { return !waiting_.empty(); })) {
    return "";
  }
  const auto [kind, json] = std::move(waiting_.front());
  waiting_.erase(waiting_.begin());
  return fmt::format("event: {}\ndata: {}\n\n", kind, json);
}

}  // namespace limber
