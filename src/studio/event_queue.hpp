#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace limber {

/// Events on their way to one browser tab. Of each kind only the newest waits: a slow browser gets
/// fewer, never older ones, and memory is bounded. Threads: any.
class EventQueue {
 public:
  /// @param kind  a name as in docs/studio_api.md
  /// @param json  one line
  void push(const std::string& kind, std::string json);
  /// The next event as text of an event stream, or empty after `wait`.
  std::string pop(std::chrono::milliseconds wait);

 private:
  std::mutex mutex_;
  std::condition_variable has_event_;
  std::vector<std::pair<std::string, std::string>> waiting_;  // kind, JSON; the oldest first
};

}  // namespace limber
