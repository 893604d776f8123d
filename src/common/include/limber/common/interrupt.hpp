#pragma once
// For everyone.

namespace limber {

/// Makes Ctrl-C and SIGTERM set a flag instead of killing the process; a second signal kills it.
/// System calls that block return early (EINTR).
/// Long loops call `interrupt_requested()` at points where their files are valid.
void install_interrupt_handler();

/// True after the first Ctrl-C or SIGTERM. Safe from any thread.
bool interrupt_requested();

/// @throws Interrupted if a signal has come.
void throw_if_interrupted();

}  // namespace limber
