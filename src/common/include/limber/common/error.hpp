#pragma once
// For everyone.

#include <stdexcept>
#include <string>

namespace limber {

/// A mistake of the caller or in a file. The message says what was found, where, and what is
/// allowed. The program exits with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine or a driver failed: disk full, simulator blown up, arm silent. The program exits
/// with 3.
class SystemFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Work stopped because the user asked for it (Ctrl-C); what was written is valid. The program
/// exits with 1.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace limber
