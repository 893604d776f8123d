#include "limber/driver/driver_protocol.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/printable.hpp"

namespace limber {

namespace {

constexpr double kMaxKpa = 1e5;     // 1000 bar: no soft arm comes near
constexpr double kMaxNumber = 1e5;  // of a pose; before calibration in mm, too
constexpr double kMaxTimeS = 1e12;
constexpr int kMaxChambers = 16 * kMaxSegments;
constexpr std::uint64_t kMaxSeq = std::uint64_t{1} << 53U;  // what a double holds exactly
constexpr double kMaxQuaternionOff = 0.01;                  // of its length from 1
constexpr double kRateTolerance = 0.01;                     // of the arm's frame rate

Json list(const Eigen::Ref<const Pressures>& values) {
  return std::vector<double>(values.begin(), values.end());
}

template <class Poses>
Json rows(const Poses& poses) {
  return mapped<Json>(poses.rowwise(), [&](const auto& pose) {
    return std::vector<double>(pose.begin(), pose.end());
  });
}

Pressures pressures(const JsonReader& reader, int count) {
  const std::vector<double> values =
      reader.numbers(std::size_t(count), "pressures in kPa", -kMaxKpa, kMaxKpa);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), count).cast<float>();
}

/// @tparam Poses  BackboneD, or BodyPoses in space
/// @param what  they are poses of
template <class Poses>
Poses read_poses(const JsonReader& reader, int points, const char* what) {
  constexpr int kSize = Poses::ColsAtCompileTime;
  constexpr bool kInSpace = kSize == kSpacePoseSize;
  const std::vector<JsonReader> rows =
      reader.elements(kInSpace ? "a list of [x, y, z, qx, qy, qz, qw], or null"
                               : "a list of [x, y, theta], or null");
  reader.refuse_if(rows.size() != std::size_t(points), "{} {} found; the arm has {} plates",
                   rows.size(), what, points);
  Poses result(points, kSize);
  for (int i = 0; i < points; ++i) {
    const JsonReader& row = rows[i];
    const std::vector<double> pose = row.numbers(
        kSize, kInSpace ? "numbers: x, y, z, qx, qy, qz and qw" : "numbers: x, y and theta",
        -kMaxNumber, kMaxNumber);
    result.row(i) = Eigen::Map<const Eigen::RowVectorXd>(pose.data(), kSize);
    if constexpr (kInSpace) {
      const double length = result.row(i).template tail<4>().norm();
      row.refuse_if(!(std::abs(length - 1.0) <= kMaxQuaternionOff),
                    "a quaternion of length {:.4g}; expected [qx, qy, qz, qw] of length 1", length);
      result.row(i).template tail<4>() /= length;
    }
  }
  return result;
}

/// The shape of a state: a backbone in the arm's frame, or bodies in a tracker's.
void read_shape(const JsonReader& root, const HostHello& arm, DriverReply& reply) {
  if (root.has("bodies")) {
    const JsonReader reader = root.at("bodies");
    reader.refuse_if(arm.is_spatial(), "an arm in space is told in its own frame, as backbone");
    reader.refuse_if(root.has("backbone"), "stands beside backbone; a state has one of the two");
    if (!reader.is_null()) {
      reply.bodies = read_poses<BodyPoses>(reader, arm.points, "bodies");
    }
  } else if (root.has("backbone") && !root.at("backbone").is_null()) {
    const JsonReader reader = root.at("backbone");
    if (arm.is_spatial()) {
      reply.state.space_backbone = read_poses<BodyPoses>(reader, arm.points, "poses").cast<float>();
    } else {
      reply.state.backbone = read_poses<BackboneD>(reader, arm.points, "poses").cast<float>();
    }
  }
}

double rate(const JsonReader& root) {
  constexpr double kMaxRateHz = 1e4;
  return root.at("rate_hz").number(1e-3, kMaxRateHz);
}

/// `limit_kpa` alone is that of both sides; beside it, `limits_kpa` has [lower, upper] of each
/// segment. Programs that do not know the latter read the largest of either side.
std::vector<PressureLimits> limits(const JsonReader& root, int count) {
  const auto n = std::size_t(count);
  std::vector<PressureLimits> result;
  if (root.has("limits_kpa")) {
    const std::vector<JsonReader> pairs =
        root.at("limits_kpa").elements("a list of [lower, upper]");
    if (pairs.size() != n) {
      root.at("limits_kpa")
          .refuse(
              fmt::format("{} pairs found; expected one of each of {} pressures", pairs.size(), n));
    }
    for (const JsonReader& pair : pairs) {
      const std::vector<double> ends =
          pair.numbers(2, "limits in kPa, [lower, upper]", -kMaxKpa, kMaxKpa);
      if (!(ends[0] <= 0.0 && ends[1] >= 0.0)) {
        pair.refuse_found("expected lower <= 0 <= upper: a vented segment is at 0");
      }
      result.emplace_back(ends[0], ends[1]);
    }
  } else if (root.has("limit_kpa")) {
    for (const double limit : root.at("limit_kpa").numbers(n, "limits in kPa", 0.0, kMaxKpa)) {
      result.emplace_back(limit);
    }
  }
  return result;
}

/// @param json  with what is of one side alone
std::string hello_line(Json json, int chambers, const std::vector<PressureLimits>& limits) {
  if (chambers > 0) {
    json["dimension"] = 3;
    json["chambers"] = chambers;
  }
  Json pairs = Json::array();
  bool symmetric = true;
  for (const PressureLimits& one : limits) {
    json["limit_kpa"].push_back(one.largest_kpa());
    pairs.push_back({one.lower_kpa, one.upper_kpa});
    symmetric &= one.is_symmetric();
  }
  if (!symmetric) {
    json["limits_kpa"] = std::move(pairs);
  }
  return json.dump();
}

std::string optional_text(const JsonReader& root, const char* key) {
  return root.has(key) ? root.at(key).text() : "";
}

bool optional_flag(const JsonReader& root, const char* key, bool otherwise) {
  return root.has(key) ? root.at(key).boolean() : otherwise;
}

void require_type(const JsonReader& root, const char* expected) {
  if (root.at("type").text() != expected) {
    root.at("type").refuse_found(fmt::format("expected '{}'", expected));
  }
}

void require_protocol(const JsonReader& root) {
  if (root.at("protocol").integer(0, 1 << 20) != kDriverProtocol) {
    root.at("protocol").refuse_found(fmt::format("this limber speaks version {}", kDriverProtocol));
  }
}

void require_no_fault(const JsonReader& root) {
  if (root.at("type").text() == "fault") {
    throw SystemFault(
        fmt::format("reports a fault: {}", in_one_line(optional_text(root, "message"))));
  }
}

/// What every state has: its number, its time and its pressures.
DriverReply without_shape(const JsonReader& root, const HostHello& arm) {
  require_no_fault(root);
  require_type(root, "state");
  DriverReply reply;
  reply.seq = std::int64_t(root.at("seq").count(kMaxSeq));
  reply.state.time_s = root.at("t").number(-kMaxTimeS, kMaxTimeS);
  reply.state.pressure_kpa = pressures(root.at("pressure_kpa"), arm.pressures());
  return reply;
}

}  // namespace

HostHello host_hello(const ArmDescription& arm) {
  return {arm.name,          arm.segment_count(), arm.is_spatial() ? arm.channel_count() : 0,
          arm.point_count(), arm.frame_rate_hz,   limits_of(arm)};
}

std::string to_line(const HostHello& hello) {
  Json json = {{"type", "hello"},        {"protocol", kDriverProtocol},
               {"arm", hello.arm},       {"segments", hello.segments},
               {"points", hello.points}, {"rate_hz", hello.rate_hz}};
  return hello_line(std::move(json), hello.chambers, hello.limit_kpa);
}

std::string to_line(const DriverHello& hello) {
  Json json = {{"type", "hello"},          {"protocol", kDriverProtocol},
               {"driver", hello.driver},   {"device", hello.device},
               {"rate_hz", hello.rate_hz}, {"segments", hello.segments},
               {"tracked", hello.tracked}, {"real_time", hello.real_time}};
  return hello_line(std::move(json), hello.chambers, hello.limit_kpa);
}

std::string set_line(std::int64_t seq, double time_s, const Pressures& setpoint_kpa) {
  return Json{{"type", "set"}, {"seq", seq}, {"t", time_s}, {"pressure_kpa", list(setpoint_kpa)}}
      .dump();
}

std::string vent_line(std::int64_t seq, double time_s) {
  return Json{{"type", "vent"}, {"seq", seq}, {"t", time_s}}.dump();
}

std::string bye_line() {
  return Json{{"type", "bye"}}.dump();
}

std::string state_line(std::int64_t seq, const ArmState& state,
                       const std::optional<BodyPoses>& bodies) {
  Json json = {{"type", "state"},
               {"seq", seq},
               {"t", state.time_s},
               {"pressure_kpa", list(state.pressure_kpa)}};
  if (state.setpoint_kpa) {
    json["setpoint_kpa"] = list(*state.setpoint_kpa);
  }
  if (bodies) {
    json["bodies"] = rows(*bodies);
  } else if (state.space_backbone) {
    json["backbone"] = rows(*state.space_backbone);
  } else {
    json["backbone"] = state.backbone ? rows(*state.backbone) : Json(nullptr);
  }
  if (state.tracker_s) {
    json["tracker_t"] = *state.tracker_s;
  }
  return json.dump();
}

std::string fault_line(const std::string& message) {
  return Json{{"type", "fault"}, {"message", message}}.dump(-1, ' ', false,
                                                            Json::error_handler_t::replace);
}

DriverHello parse_driver_hello(std::string_view line, const HostHello& expected) {
  const nlohmann::json json = parse_json_object(line, "hello");
  const JsonReader root(json, "hello");
  require_no_fault(root);
  require_type(root, "hello");
  require_protocol(root);
  DriverHello hello;
  hello.driver = in_one_line(optional_text(root, "driver"));
  hello.device = in_one_line(optional_text(root, "device"));
  hello.rate_hz = rate(root);
  if (!(std::abs(hello.rate_hz - expected.rate_hz) <= kRateTolerance * expected.rate_hz)) {
    root.at("rate_hz").refuse_found(
        fmt::format("arm '{}' runs at {} Hz", expected.arm, expected.rate_hz));
  }
  const auto require_count = [&](const char* parts, int count) {
    if (root.at(parts).integer(0, 1 << 20) != count) {
      root.at(parts).refuse_found(fmt::format("arm '{}' has {} {}", expected.arm, count, parts));
    }
  };
  require_count("segments", expected.segments);
  if (expected.is_spatial()) {
    require_count("chambers", expected.chambers);
  }
  hello.segments = expected.segments;
  hello.chambers = expected.chambers;
  hello.tracked = optional_flag(root, "tracked", true);
  hello.real_time = optional_flag(root, "real_time", true);
  hello.limit_kpa = limits(root, expected.pressures());
  return hello;
}

DriverReply parse_state(std::string_view line, const HostHello& arm) {
  const nlohmann::json json = parse_json_object(line, "state");
  const JsonReader root(json, "state");
  DriverReply reply = without_shape(root, arm);
  if (root.has("setpoint_kpa") && !root.at("setpoint_kpa").is_null()) {
    reply.state.setpoint_kpa = pressures(root.at("setpoint_kpa"), arm.pressures());
  }
  read_shape(root, arm, reply);
  if (root.has("tracker_t") && !root.at("tracker_t").is_null()) {
    reply.state.tracker_s = root.at("tracker_t").number(-kMaxTimeS, kMaxTimeS);
  }
  return reply;
}

DriverReply parse_vent_answer(std::string_view line, const HostHello& arm) {
  const nlohmann::json json = parse_json_object(line, "state");
  return without_shape(JsonReader(json, "state"), arm);
}

DriverRequest parse_request(std::string_view line, const HostHello& arm) {
  const nlohmann::json json = parse_json_object(line, "request");
  const JsonReader root(json, "request");
  const std::string type = root.at("type").text();
  DriverRequest request;
  if (type == "bye") {
    return request;
  }
  if (type == "hello") {
    require_protocol(root);
    request.kind = RequestKind::hello;
    request.hello.arm = optional_text(root, "arm");
    request.hello.segments = root.at("segments").integer(1, kMaxSegments);
    request.hello.points = root.at("points").integer(2, 1 << 20);
    request.hello.rate_hz = rate(root);
    if (root.has("chambers")) {
      request.hello.chambers = root.at("chambers").integer(1, kMaxChambers);
    }
    request.hello.limit_kpa = limits(root, request.hello.pressures());
    return request;
  }
  if (type != "set" && type != "vent") {
    root.at("type").refuse_found("expected hello, set, vent or bye");
  }
  request.kind = type == "set" ? RequestKind::set : RequestKind::vent;
  request.seq = std::int64_t(root.at("seq").count(kMaxSeq));
  (void)root.at("t").number(-kMaxTimeS, kMaxTimeS);
  if (request.kind == RequestKind::set) {
    request.setpoint_kpa = pressures(root.at("pressure_kpa"), arm.pressures());
  }
  return request;
}

}  // namespace limber
