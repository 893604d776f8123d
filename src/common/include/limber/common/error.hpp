#pragma once
// For everyone.

#include <stdexcept>
#include <string>

namespace limber {

/// What the three below have in common.
class Failure : public std::runtime_error {
 public:
  /// A zero byte, which came from a file and would end what(), is written out in hexadecimal.
  explicit Failure(std::string message) : std::runtime_error(with_zeros_shown(message)) {}

 private:
  static const std::string& with_zeros_shown(std::string& message) {
    for (auto at = message.find('\0'); at != message.npos; at = message.find('\0', at)) {
      message.replace(at, 1, "\\x00");
    }
    return message;
  }
};

/// A mistake of the caller or in a file. The message says what was found, where, and what is
/// allowed. The program exits with 2.
class InputError : public Failure {
 public:
  using Failure::Failure;
};

/// The machine or a driver failed: disk full, simulator blown up, arm silent. The program exits
/// with 3.
class SystemFault : public Failure {
 public:
  using Failure::Failure;
};

/// Work stopped because the user asked for it (Ctrl-C); what was written is valid. The program
/// exits with 1.
class Interrupted : public Failure {
 public:
  using Failure::Failure;
};

}  // namespace limber
