#pragma once

namespace limber {

/// Threads that may be asked for: far more than a machine has cores, far fewer than its memory ends
/// with.
inline constexpr int kMaxJobs = 1024;

}  // namespace limber
