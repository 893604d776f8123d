#include "others_may_run.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

#include "limber/common/interrupt.hpp"

namespace limber::python {

namespace py = pybind11;

namespace {

std::atomic<int> without_lock{0};
std::atomic<bool> ending{false};
std::atomic<std::thread::id> ending_thread;

void stop_and_wait() {
  constexpr std::chrono::milliseconds kPeriod(5);
  ending_thread = std::this_thread::get_id();
  ending = true;
  request_interrupt();
  const py::gil_scoped_release others_may_end;
  while (without_lock > 0) {
    std::this_thread::sleep_for(kPeriod);
  }
}

}  // namespace

OthersMayRun::Counted::Counted() {
  ++without_lock;
}

OthersMayRun::Counted::~Counted() {
  --without_lock;
}

OthersMayRun::OthersMayRun() {
  if (!ending) {
    released_.emplace();
  }
}

void answer_signals() {
  const py::gil_scoped_acquire python;
  if (PyErr_CheckSignals() != 0) {
    throw py::error_already_set();
  }
}

std::shared_ptr<py::object> shared(py::object object) {
  return {new py::object(std::move(object)), [](py::object* one) {
            const py::gil_scoped_acquire python;
            delete one;
          }};
}

bool python_is_ending() {
  return ending;
}

bool python_leaves_this_thread() {
  return ending && std::this_thread::get_id() != ending_thread.load();
}

void stop_at_exit() {
  const pid_t process = getpid();
  py::module_::import("atexit").attr("register")(py::cpp_function([process] {
    if (getpid() == process) {  // a forked child has none of those threads
      stop_and_wait();
    }
  }));
}

}  // namespace limber::python
