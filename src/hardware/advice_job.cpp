#include "advice_job.hpp"

#include <chrono>
#include <utility>

namespace limber {

void AdviceJob::begin(std::function<MotionAdvice()> question) {
  if (advice_.valid()) {
    is_late_ = true;
    if (advice_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return;
    }
    (void)advice_.get();
  }
  is_late_ = false;
  if (!question) {
    return;
  }
  if (in_real_time_) {
    advice_ = std::async(std::launch::async, std::move(question));
    return;
  }
  std::promise<MotionAdvice> promise;
  promise.set_value(question());
  advice_ = promise.get_future();
}

std::optional<MotionAdvice> AdviceJob::end() {
  const bool is_ready = advice_.valid() && !is_late_ &&
                        advice_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  return is_ready ? std::optional(advice_.get()) : std::nullopt;
}

bool AdviceJob::is_busy() const {
  return advice_.valid() && advice_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

}  // namespace limber
