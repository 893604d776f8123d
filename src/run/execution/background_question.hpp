#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <utility>

#include "limber/common/interrupt.hpp"

namespace limber {

/// One of a controller's questions at a time. In real time it is worked out on a thread of its own,
/// so that no set point waits for it; in simulated time at once, so that runs can be repeated.
///
/// Threads: used by one. The destructor stops the other, if there is one, and waits for it.
class BackgroundQuestion {
 public:
  explicit BackgroundQuestion(bool in_real_time) : in_real_time_(in_real_time) {}
  ~BackgroundQuestion() { stop_ = true; }
  BackgroundQuestion(const BackgroundQuestion&) = delete;
  BackgroundQuestion& operator=(const BackgroundQuestion&) = delete;

  /// @pre the one before was answered
  void begin(std::function<void()> question) {
    if (in_real_time_) {
      answered_ = std::async(std::launch::async, [this, asked = std::move(question)] {
        const StopScope scope(&stop_);
        asked();
      });
    } else {
      question();
    }
  }

  /// Whether it is still being worked out.
  bool is_busy() const {
    return answered_.valid() &&
           answered_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }

  /// Of one that is not busy: throws what it threw, once.
  void end() {
    if (answered_.valid()) {
      answered_.get();
    }
  }

 private:
  bool in_real_time_;
  std::atomic<bool> stop_{false};
  std::future<void> answered_;  // waits when it goes, with `stop_` still there
};

}  // namespace limber
