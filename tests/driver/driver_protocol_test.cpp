#include "limber/driver/driver_protocol.hpp"

#include <string>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class DriverProtocol : public ::testing::Test {
 protected:
  ArmState state() const {
    ArmState state;
    state.time_s = 12.375;
    state.pressure_kpa = Pressures::LinSpaced(2, -20.1F, 33.3F);
    state.setpoint_kpa = Pressures::LinSpaced(2, -20.0F, 33.0F);
    state.backbone = Backbone::Random(arm_.point_count(), 3);
    return state;
  }

  void expect_refused(const std::string& line, const std::string& message) const {
    EXPECT_THAT([&] { (void)parse_state(line, host_); },
                ThrowsMessage<InputError>(HasSubstr(message)))
        << line;
  }

  ArmDescription arm_ = small_arm();
  HostHello host_ = host_hello(arm_);
};

TEST_F(DriverProtocol, StatesSurviveTheWireToTheBit) {
  const ArmState sent = state();
  const DriverReply reply = parse_state(state_line(7, sent), host_);
  EXPECT_EQ(reply.seq, 7);
  EXPECT_EQ(reply.state.time_s, sent.time_s);
  EXPECT_EQ(reply.state.pressure_kpa, sent.pressure_kpa);
  EXPECT_EQ(*reply.state.setpoint_kpa, *sent.setpoint_kpa);
  EXPECT_EQ(*reply.state.backbone, *sent.backbone);
  EXPECT_FALSE(reply.state.tracker_s);
  ArmState timed = sent;
  timed.tracker_s = -3.25;
  EXPECT_EQ(parse_state(state_line(7, timed), host_).state.tracker_s, -3.25);
}

TEST_F(DriverProtocol, AVentsAnswerIsReadWithoutItsShape) {
  const std::string line =
      R"({"type":"state","seq":9,"t":0.5,"pressure_kpa":[3,-4],"backbone":[[0,0,0]]})";
  expect_refused(line, "backbone: 1 poses found; the arm has 5 plates");
  const DriverReply reply = parse_vent_answer(line, host_);
  EXPECT_EQ(reply.seq, 9);
  EXPECT_EQ(reply.state.time_s, 0.5);
  EXPECT_EQ(reply.state.pressure_kpa, (Pressures(2) << 3, -4).finished());
  EXPECT_FALSE(reply.state.backbone);
  EXPECT_THAT([&] { (void)parse_vent_answer(R"({"type":"state","seq":9,"t":0.5})", host_); },
              ThrowsMessage<InputError>(HasSubstr("pressure_kpa")));
}

TEST_F(DriverProtocol, RequestsSurviveTheWireToTheBit) {
  const Pressures setpoint_kpa = Pressures::LinSpaced(2, -0.1F, 99.9F);
  const DriverRequest set = parse_request(set_line(41, 2.05, setpoint_kpa), host_);
  EXPECT_EQ(set.kind, RequestKind::set);
  EXPECT_EQ(set.seq, 41);
  EXPECT_EQ(set.setpoint_kpa, setpoint_kpa);
  EXPECT_EQ(parse_request(vent_line(42, 2.1), host_).kind, RequestKind::vent);
  EXPECT_EQ(parse_request(bye_line(), host_).kind, RequestKind::bye);
  const DriverRequest hello = parse_request(to_line(host_), host_);
  EXPECT_EQ(hello.kind, RequestKind::hello);
  EXPECT_EQ(hello.hello.segments, 2);
  EXPECT_EQ(hello.hello.limit_kpa, host_.limit_kpa);
}

TEST_F(DriverProtocol, BackboneMayBeMissingOrNull) {
  const std::string begin = R"({"type":"state","seq":1,"t":0.1,"pressure_kpa":[0,0])";
  EXPECT_FALSE(parse_state(begin + "}", host_).state.backbone);
  EXPECT_FALSE(parse_state(begin + R"(,"backbone":null})", host_).state.backbone);
  EXPECT_FALSE(parse_state(begin + R"(,"backbone":null,"more":[1]})", host_).state.setpoint_kpa);
}

TEST_F(DriverProtocol, BodiesStandInPlaceOfABackbone) {
  BodyPoses bodies = BodyPoses::Random(arm_.point_count(), 7);
  bodies.rightCols<4>().rowwise().normalize();
  const std::string line = state_line(7, state(), bodies);
  const DriverReply reply = parse_state(line, host_);
  EXPECT_FALSE(reply.state.backbone);
  EXPECT_TRUE(reply.bodies->isApprox(bodies, 1e-15));
  EXPECT_FALSE(parse_state(state_line(7, state()), host_).bodies);
  const std::string begin = R"({"type":"state","seq":1,"t":0.1,"pressure_kpa":[0,0])";
  EXPECT_FALSE(parse_state(begin + R"(,"bodies":null})", host_).bodies);
}

TEST_F(DriverProtocol, RefusesBodiesByField) {
  const auto with = [&](const std::string& second) {
    std::string rows = "[0,0,0,0,0,0,1]," + second;
    for (int i = 2; i < host_.points; ++i) {
      rows += ",[0,0,0,0,0,0,1]";
    }
    return R"({"type":"state","seq":1,"t":0.1,"pressure_kpa":[1,2],"bodies":[)" + rows + "]}";
  };
  EXPECT_TRUE(parse_state(with("[1,2,3,0.001,0,0,-1.009]"), host_).bodies);
  expect_refused(with("[1,2,3,0,0,0,1.02]"), "bodies[1]: a quaternion of length 1.02; expected");
  expect_refused(with("[1,2,3,0,0,0,0]"), "bodies[1]: a quaternion of length 0");
  expect_refused(with("[1,2,3,0,0,1]"), "bodies[1]: 6 numbers found; expected 7");
  expect_refused(with("[1,2,null,0,0,0,1]"), "bodies[1]");
  expect_refused(with("[1,2,1e300,0,0,0,1]"), "bodies[1]");
  expect_refused(with("null"), "bodies[1]");
  expect_refused(with("[1,2,NaN,0,0,0,1]"), "state");
  const std::string begin = R"({"type":"state","seq":1,"t":0.1,"pressure_kpa":[1,2],)";
  expect_refused(begin + R"("bodies":[[0,0,0,0,0,0,1]]})", "bodies: 1 bodies found; the arm has");
  expect_refused(begin + R"("bodies":7})", "a list of [x, y, z, qx, qy, qz, qw], or null");
  expect_refused(begin + R"("backbone":null,"bodies":null})", "a state has one of the two");
}

TEST_F(DriverProtocol, RefusesStatesByField) {
  const auto with = [](const std::string& rest) {
    return R"({"type":"state","seq":1,"t":0.1,)" + rest + "}";
  };
  expect_refused("", "state");
  expect_refused(R"({"type":"state","seq":1)", "state");
  expect_refused("[1, 2]", "expected a JSON object");
  expect_refused(R"({"type":"set"})", "expected 'state'");
  expect_refused(with(R"("pressure_kpa":[1,2,3])"), "pressure_kpa: 3 numbers found; expected 2");
  expect_refused(with(R"("pressure_kpa":[1])"), "expected 2 pressures");
  expect_refused(with(R"("pressure_kpa":[1,NaN])"), "state");
  expect_refused(with(R"("pressure_kpa":[1,null])"), "pressure_kpa[1]");
  expect_refused(with(R"("pressure_kpa":[1,"2"])"), "pressure_kpa[1]");
  expect_refused(with(R"("pressure_kpa":[1,1e300])"), "pressure_kpa[1]");
  expect_refused(with(R"("pressure_kpa":[1,2],"setpoint_kpa":[1])"), "setpoint_kpa");
  expect_refused(with(R"("pressure_kpa":[1,2],"backbone":[[0,0,0]])"), "1 poses found");
  expect_refused(R"({"type":"state","seq":-1,"t":0.1,"pressure_kpa":[1,2]})", "seq");
  expect_refused(R"({"type":"state","seq":1.5,"t":0.1,"pressure_kpa":[1,2]})", "seq");
  expect_refused(R"({"type":"state","t":0.1,"pressure_kpa":[1,2]})", "seq: missing");
  expect_refused(R"({"type":"state","seq":1,"t":"now","pressure_kpa":[1,2]})", "t: ");
}

TEST_F(DriverProtocol, AFaultOfTheDriverIsAFault) {
  EXPECT_THAT([&] { (void)parse_state(fault_line("valve 3 is hot"), host_); },
              ThrowsMessage<SystemFault>(HasSubstr("valve 3 is hot")));
}

// It could print what looks like limber's own lines, or megabytes.
TEST_F(DriverProtocol, WhatADriverSaysStaysOnOneLineAndIsCut) {
  const auto said = [&](const std::string& text) {
    try {
      (void)parse_state(fault_line(text), host_);
    } catch (const SystemFault& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  EXPECT_EQ(said("hot\nvented: 0.0 kPa after 0.1 s"),
            "reports a fault: hot vented: 0.0 kPa after 0.1 s");
  EXPECT_LT(said(std::string(900'000, 'x')).size(), 300U);
  const std::string hello =
      R"({"type":"hello","protocol":1,"rate_hz":20,"segments":2,"driver":"a\nb",)"
      R"("device":")" +
      std::string(5000, 'y') + "\"}";
  EXPECT_EQ(parse_driver_hello(hello, host_).driver, "a b");
  EXPECT_LT(parse_driver_hello(hello, host_).device.size(), 300U);
}

TEST_F(DriverProtocol, LimitsOfEachSideHaveAKeyOfTheirOwn) {
  EXPECT_EQ(to_line(host_).find("limits_kpa"), std::string::npos) << "as before";
  ArmDescription arm = arm_;
  arm.segments[0].pressure_limit_kpa = PressureLimits(-11.0, 13.8);
  const HostHello host = host_hello(arm);
  EXPECT_THAT(to_line(host), HasSubstr(R"("limit_kpa":[13.8,100.0])"));
  EXPECT_THAT(to_line(host), HasSubstr(R"("limits_kpa":[[-11.0,13.8],[-100.0,100.0]])"));
  EXPECT_EQ(parse_request(to_line(host), host_).hello.limit_kpa, host.limit_kpa);
  DriverHello hello;
  hello.rate_hz = 20.0;
  hello.segments = 2;
  hello.limit_kpa = {PressureLimits(-5.0, 0.0), PressureLimits(90.0)};
  EXPECT_EQ(parse_driver_hello(to_line(hello), host_).limit_kpa, hello.limit_kpa);
  const auto refused = [&](const std::string& pairs, const std::string& message) {
    const std::string line = R"({"type":"hello","protocol":1,"rate_hz":20,"segments":2,)"
                             R"("limits_kpa":)" +
                             pairs + "}";
    EXPECT_THAT([&] { (void)parse_driver_hello(line, host_); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refused("[[-5,5]]", "1 pairs found");
  refused("[[-5,5],[1,5]]", "expected lower <= 0 <= upper");
  refused("[[-5,5],[5]]", "limits_kpa[1]");
}

TEST_F(DriverProtocol, HellosSurviveTheWire) {
  DriverHello hello;
  hello.driver = "bench driver 2";
  hello.device = "text over a serial line, mbar";
  hello.rate_hz = 20.0;
  hello.segments = 2;
  hello.tracked = false;
  hello.limit_kpa = {80.0, 90.0};
  const DriverHello found = parse_driver_hello(to_line(hello), host_);
  EXPECT_EQ(found.driver, hello.driver);
  EXPECT_EQ(found.device, hello.device);
  EXPECT_FALSE(found.tracked);
  EXPECT_TRUE(found.real_time);
  EXPECT_EQ(found.limit_kpa, hello.limit_kpa);
}

TEST_F(DriverProtocol, RefusesHellosOfOtherArmsRatesAndVersions) {
  const auto refused = [&](const std::string& line, const std::string& message) {
    EXPECT_THAT([&] { (void)parse_driver_hello(line, host_); },
                ThrowsMessage<InputError>(HasSubstr(message)))
        << line;
  };
  refused(R"({"type":"hello","protocol":2,"rate_hz":20,"segments":2})", "protocol: 2 found");
  refused(R"({"type":"hello","protocol":1,"rate_hz":50,"segments":2})", "runs at 20 Hz");
  refused(R"({"type":"hello","protocol":1,"rate_hz":20,"segments":3})", "has 2 segments");
  refused(R"({"type":"hello","protocol":1,"rate_hz":20,"segments":2,"limit_kpa":[1]})",
          "limit_kpa");
  refused(R"({"type":"state"})", "expected 'hello'");
  refused("ready", "hello");
}

TEST_F(DriverProtocol, ADriverMayAnswerTheHelloWithItsFault) {
  EXPECT_THAT(
      [&] {
        (void)parse_driver_hello(R"({"type":"fault","message":"no device at a port"})", host_);
      },
      ThrowsMessage<SystemFault>(HasSubstr("reports a fault: no device at a port")));
}

}  // namespace
}  // namespace limber
