#include "advice_job.hpp"

#include <chrono>
#include <utility>

namespace limber {

AdviceJob::~AdviceJob() {
  if (advice_.valid()) {
    ++times_.late;
    try {
      (void)take();
    } catch (...) {  // nobody listens any more
    }
  }
}

void AdviceJob::begin(std::function<MotionAdvice()> question) {
  if (advice_.valid()) {
    is_late_ = true;
    if (!is_ready()) {
      return;
    }
    ++times_.late;
    (void)take();
  }
  is_late_ = false;
  if (!question) {
    return;
  }
  if (in_real_time_) {
    advice_ = std::async(std::launch::async, [question = std::move(question)] {
      using Clock = std::chrono::steady_clock;
      const Clock::time_point begun = Clock::now();
      MotionAdvice advice = question();
      return Timed{std::move(advice), std::chrono::duration<double>(Clock::now() - begun).count()};
    });
    return;
  }
  std::promise<Timed> promise;
  promise.set_value({question(), 0.0});
  advice_ = promise.get_future();
}

std::optional<MotionAdvice> AdviceJob::end() {
  return !is_late_ && is_ready() ? std::optional(take()) : std::nullopt;
}

bool AdviceJob::is_busy() const {
  return advice_.valid() && !is_ready();
}

bool AdviceJob::is_ready() const {
  return advice_.valid() && advice_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

MotionAdvice AdviceJob::take() {
  Timed timed = advice_.get();
  if (in_real_time_) {
    times_.all_s.push_back(timed.took_s);
    if (timed.advice.has_searched) {
      times_.searches_s.push_back(timed.took_s);
    }
  }
  return std::move(timed.advice);
}

}  // namespace limber
