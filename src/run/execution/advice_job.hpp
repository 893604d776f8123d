#pragma once

#include <future>
#include <optional>

#include "limber/run/executor.hpp"

namespace limber {

/// One piece of advice at a time, worked out while a frame passes. In real time on a thread of its
/// own, so that no set point waits for it; in simulated time at once, so that runs can be repeated.
///
/// Threads: used by one. The destructor waits for the other, if there is one.
class AdviceJob {
 public:
  /// @param times  noted there in real time; borrowed
  AdviceJob(bool in_real_time, AdviceTimes& times) : in_real_time_(in_real_time), times_(times) {}
  ~AdviceJob();
  AdviceJob(const AdviceJob&) = delete;
  AdviceJob& operator=(const AdviceJob&) = delete;

  /// Begins, unless the one before is still being worked out: that one is late,
  /// and will be dropped.
  /// @param question  of whoever advises; empty: nothing to ask
  void begin(std::function<MotionAdvice()> question);

  /// The advice for the frame that has just passed; none if it was not asked for, or is late.
  std::optional<MotionAdvice> end();

  /// Whether somebody still thinks, in real time.
  bool is_busy() const;

 private:
  struct Timed {
    MotionAdvice advice;
    double took_s;
  };

  bool is_ready() const;
  MotionAdvice take();

  bool in_real_time_;
  AdviceTimes& times_;
  bool is_late_ = false;
  std::future<Timed> advice_;
};

}  // namespace limber
