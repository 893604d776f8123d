#pragma once

#include <memory>
#include <optional>

#include <pybind11/pybind11.h>

namespace limber::python {

/// Lets Python's other threads run while this one works in limber, and takes Python's lock back at
/// the end.
///
/// When Python ends, a thread that asks for the lock is ended by force, through limber's frames,
/// and that aborts the process. So at exit `stop_at_exit` asks all work to stop and waits until
/// every such thread has the lock back. Afterwards the lock is kept.
class OthersMayRun {
 public:
  OthersMayRun();

 private:
  /// Counts threads without the lock; changes with the lock alone.
  class Counted {
   public:
    Counted();
    ~Counted();
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
  };

  Counted counted_;
  std::optional<pybind11::gil_scoped_release> released_;
};

/// Ctrl-C, for who has let Python's lock go. @throws what Python's handler raises.
void answer_signals();

/// A Python object whose last owner may be a thread without Python's lock.
std::shared_ptr<pybind11::object> shared(pybind11::object object);

/// Whether Python is ending: no work begins any more.
bool python_is_ending();

/// Whether Python is ending and another thread ends it: this one may be cut off at any moment.
bool python_leaves_this_thread();

/// Registers what stops all work and waits for it, with Python's atexit.
void stop_at_exit();

}  // namespace limber::python
