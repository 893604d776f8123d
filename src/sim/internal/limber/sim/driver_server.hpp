#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/sim/misassembly.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

/// What a driver can do wrong, for tests of whoever talks to it.
enum class ServerFaultKind {
  late,     ///< answers four frames late
  repeat,   ///< answers twice
  old,      ///< answers with the last frame's number
  half,     ///< answers half a line
  huge,     ///< answers with a gigabyte without an end of line
  nan,      ///< a pressure that is no number
  size,     ///< the pressures of an arm with one segment more
  clock,    ///< a sample older than the one before
  die,      ///< ends at once
  hang,     ///< does not answer any more
  flood,    ///< answers without end
  hello,    ///< says hello for another arm; the frame does not matter
  over,     ///< segment 0 reads 20 % over its limit
  stuck,    ///< segment 0 always reads the same
  jump,     ///< the last plate is seen 50 cm off
  sealed,   ///< pressures stay where they are, vented or not
  rise,     ///< pressures rise while venting
  release,  ///< vents by itself, and says so
};

/// A fault, from frame `frame` on (the `set`s, counted from 0).
struct ServerFault {
  ServerFaultKind kind = ServerFaultKind::die;
  int frame = 0;
};

/// "die@12". @throws InputError that lists the kinds.
ServerFault parse_server_fault(const std::string& text);

const char* to_string(ServerFaultKind kind);

struct ServerSettings {
  bool fast = false;  ///< answer as fast as possible, without frames of wall time
  /// Answer with the sample of the moment, which is the end of the frame before, as hardware does;
  /// else with the end of the frame that the request begins.
  bool at_once = false;
  /// At once, with the sample of a tracker that sees the arm every so many seconds of wall time: a
  /// request that comes before the next one gets the same again. 0: each request has its own.
  double sampled_s = 0.0;
  std::optional<ServerFault> fault;
  fs::path device_log;  ///< what the simulated device was told, and when; empty: none
  VirtualArmOptions arm;
  std::optional<Misassembly> misassembly;
};

/// The virtual arm behind the driver protocol: requests on standard input, states on standard
/// output (docs/driver.md). It vents at the end of its input, and when no request came for three
/// frames of wall time.
///
/// The device, a process of its own where it has a log, stands for the board behind a real driver:
/// it vents when the driver is silent for 0.2 s. Every line of its log has the monotonic clock's
/// time.
/// @throws InputError where a setting is out of its range; SystemFault where the log can't be
/// written.
void serve_virtual_arm(const ArmDescription& arm, const ServerSettings& settings);

}  // namespace limber
