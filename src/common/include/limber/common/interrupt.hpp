#pragma once
// For everyone.

#include <atomic>
#include <functional>

namespace limber {

/// Makes Ctrl-C and SIGTERM set a flag instead of killing the process; a second signal kills it
/// (not while limber moves an arm: docs/hardware.md).
/// System calls that block return early (EINTR).
/// Long loops call `interrupt_requested()` at points where their files are valid.
void install_interrupt_handler();

/// What the first signal does. Safe from any thread, and in signal handlers.
void request_interrupt() noexcept;

/// True after the first Ctrl-C or SIGTERM, or where a StopScope of this thread says so. Safe from
/// any thread.
bool interrupt_requested();

/// @throws Interrupted if a signal has come.
void throw_if_interrupted();
/// @throws Interrupted if a signal has come, or the caller's own request, where there is one.
void throw_if_interrupted(const std::function<bool()>& should_stop);

/// While it lives, `interrupt_requested()` is true on this thread as soon as `stop` is: for those
/// who stop one piece of work among others, such as one call in Python. Work that is handed to
/// other threads takes `stop_of_thread()` along, into a scope there.
class StopScope {
 public:
  explicit StopScope(const std::atomic<bool>* stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  const std::atomic<bool>* before_;
};

/// Of the innermost scope; null without one.
const std::atomic<bool>* stop_of_thread();

}  // namespace limber
