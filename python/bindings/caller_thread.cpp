#include "caller_thread.hpp"

#include <chrono>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

constexpr std::chrono::milliseconds kSignalPeriod(20);

}  // namespace

bool CallerThread::call(const std::function<void()>& call) {
  const std::lock_guard<std::mutex> alone(one_request_);
  std::unique_lock<std::mutex> lock(mutex_);
  request_ = &call;
  changed_.notify_all();
  changed_.wait(lock, [&] { return request_ == nullptr; });
  return !request_threw_;
}

void CallerThread::run_request() {
  request_threw_ = false;
  try {
    (*request_)();
  } catch (...) {
    request_threw_ = true;
    if (!python_failure_) {
      python_failure_ = std::current_exception();
    }
    ask_to_stop();
  }
}

void CallerThread::wait_for_work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    const bool woken =
        changed_.wait_for(lock, kSignalPeriod, [&] { return finished_ || request_ != nullptr; });
    if (finished_) {
      return;
    }
    // Python's lock is never waited for while ours is held.
    lock.unlock();
    {
      const py::gil_scoped_acquire python;
      if (woken) {
        run_request();
      }
      if (!python_failure_ && PyErr_CheckSignals() != 0) {
        python_failure_ = std::make_exception_ptr(py::error_already_set());
        ask_to_stop();
      }
    }
    lock.lock();
    if (woken) {
      request_ = nullptr;
      changed_.notify_all();
    }
  }
}

void CallerThread::run_to_end(const std::function<void()>& work) {
  std::exception_ptr failure;
  {
    if (python_is_ending()) {
      throw Interrupted("Python is ending: no work begins any more");
    }
    const OthersMayRun others_may_run;
    std::thread worker([&] {
      try {
        work();
      } catch (...) {
        failure = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      finished_ = true;
      changed_.notify_all();
    });
    wait_for_work();
    worker.join();
  }
  if (python_failure_) {
    std::rethrow_exception(python_failure_);
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

bool asks_to_go_on(const py::object& said, const char* callback) {
  py::detail::make_caster<bool> answer;
  if (!said.is_none() && !answer.load(said, true)) {
    throw py::type_error(
        fmt::format("{} returned {}; expected True, False or None", callback, type_name(said)));
  }
  return said.is_none() || py::detail::cast_op<bool>(answer);
}

}  // namespace limber::python
