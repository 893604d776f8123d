#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// The protocol between limber and a driver (docs/driver.md): one JSON object per line. Pressures
/// are kPa gauge, signed, one per segment, or per chamber of an arm in space; lengths m, angles
/// rad. Unknown keys are ignored. Every parser takes one line and throws InputError that names the
/// field.
inline constexpr int kDriverProtocol = 1;

/// Bytes of a line; a longer one is a fault. A backbone of a thousand plates takes 60 kB.
inline constexpr std::size_t kMaxDriverLine = std::size_t{1} << 20U;

/// What limber says first: the arm that it is about to move.
struct HostHello {
  std::string arm;
  int segments = 0;
  int chambers = 0;  ///< of an arm in space, all of them; 0 in a plane
  int points = 0;
  double rate_hz = 0.0;
  std::vector<PressureLimits> limit_kpa;  ///< of each pressure

  bool is_spatial() const { return chambers > 0; }
  int pressures() const { return is_spatial() ? chambers : segments; }
};

/// What the driver answers.
struct DriverHello {
  std::string driver;     ///< its name and version
  std::string device;     ///< what the device speaks, in words
  double rate_hz = 0.0;   ///< of the frames that it serves
  int segments = 0;       ///< n
  int chambers = 0;       ///< as in HostHello
  bool tracked = true;    ///< whether states carry backbones, or bodies
  bool real_time = true;  ///< false: a simulation that runs as fast as it is asked
  /// The driver's own limits; empty: none but the arm's.
  std::vector<PressureLimits> limit_kpa;
};

enum class RequestKind { hello, set, vent, bye };

/// What limber asks for. Every `set` and `vent` is answered by one state with the same `seq`.
struct DriverRequest {
  RequestKind kind = RequestKind::bye;
  std::int64_t seq = 0;
  Pressures setpoint_kpa;  ///< of `set`
  HostHello hello;         ///< of `hello`
};

struct DriverReply {
  std::int64_t seq = 0;
  ArmState state;
  std::optional<BodyPoses> bodies;  ///< in place of a backbone, of a tracker that sees in 3D
};

HostHello host_hello(const ArmDescription& arm);

/// Lines without their end. Numbers have to be finite.
std::string to_line(const HostHello& hello);
std::string to_line(const DriverHello& hello);
std::string set_line(std::int64_t seq, double time_s, const Pressures& setpoint_kpa);
std::string vent_line(std::int64_t seq, double time_s);
std::string bye_line();
/// @param bodies  stand in place of the state's backbone
std::string state_line(std::int64_t seq, const ArmState& state,
                       const std::optional<BodyPoses>& bodies = std::nullopt);

/// A driver that has failed says so in place of a state; it has vented.
std::string fault_line(const std::string& message);

/// @throws InputError, also where the hello is another arm's, rate's or protocol's.
DriverHello parse_driver_hello(std::string_view line, const HostHello& expected);

/// @throws InputError where it is no state of `arm`, SystemFault where it is the driver's fault.
DriverReply parse_state(std::string_view line, const HostHello& arm);

/// Number, time and pressures of a state, whatever else is wrong with it: a vent is confirmed by
/// pressures alone. @throws as parse_state
DriverReply parse_vent_answer(std::string_view line, const HostHello& arm);

/// The driver's side. `arm`: sizes that a request has to have.
DriverRequest parse_request(std::string_view line, const HostHello& arm);

}  // namespace limber
