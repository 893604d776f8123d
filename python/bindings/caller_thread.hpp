#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include "limber/common/interrupt.hpp"
#include "others_may_run.hpp"

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

/// Long work on a thread of its own, without Python's lock. The thread that called waits: every
/// 20 ms it looks for signals, and it runs the Python functions that the work calls, so that these
/// see the thread that they expect.
///
/// A KeyboardInterrupt, or an exception in such a function, makes `should_stop` true; the work ends
/// where it asks next, and the exception then leaves `run`. So it does when Python ends.
class CallerThread {
 public:
  /// @param work  called once; its result is that of `run`. Asks `should_stop` often.
  template <class Work>
  auto run(const Work& work) {
    using Result = std::invoke_result_t<const Work&>;
    std::optional<Result> result;
    run_to_end([&] { result.emplace(work()); });
    return std::move(*result);
  }

  /// The same for work that asks `interrupt_requested()` instead.
  template <class Work>
  auto run_interruptible(const Work& work) {
    return run([&] {
      const StopScope scope(&stop_);
      return work();
    });
  }

  /// Any thread.
  bool should_stop() const { return stop_.load(std::memory_order_relaxed) || python_is_ending(); }
  void ask_to_stop() { stop_.store(true, std::memory_order_relaxed); }

  /// From the work's threads: runs `call` on the waiting thread, with Python's lock, and returns
  /// when it has ended. False where it threw: what it threw is kept, the first of several.
  bool call(const std::function<void()>& call);

 private:
  /// Runs `work`, and throws what it threw, or what `call` and signals left.
  void run_to_end(const std::function<void()>& work);
  void wait_for_work();
  void run_request();

  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool finished_ = false;
  const std::function<void()>* request_ = nullptr;  // what the work wants called
  bool request_threw_ = false;
  std::mutex one_request_;  // of several threads of the work
  std::exception_ptr python_failure_;
};

/// What a callback said: False stops, None goes on. @throws TypeError naming the callback.
bool asks_to_go_on(const py::object& said, const char* callback);

/// Runs `work` on a thread that Ctrl-C interrupts, and waits for it.
template <class Work>
auto interruptibly(const Work& work) {
  CallerThread caller;
  return caller.run_interruptible(work);
}

}  // namespace limber::python
