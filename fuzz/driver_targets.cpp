#include <fmt/format.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/utf8.hpp"
#include "limber/driver/driver_protocol.hpp"
#include "limber/driver/process_driver.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

constexpr int kFrames = 6;
constexpr float kStepKpa = 1.0F;

void read_line_for(const Input& input, const HostHello& host) {
  const auto either = [](auto&& read) {
    try {
      read();
    } catch (const InputError&) {
    } catch (const SystemFault&) {  // that the driver reports
    }
  };
  either([&] { (void)parse_driver_hello(input.bytes, host); });
  either([&] {
    const DriverReply reply = parse_state(input.bytes, host);
    (void)parse_state(state_line(reply.seq, reply.state, reply.bodies), host);
  });
  either([&] { (void)parse_vent_answer(input.bytes, host); });
  either([&] { (void)parse_request(input.bytes, host); });
}

/// One line of either side.
void read_driver_line(const Input& input) {
  read_line_for(input, host_hello(small_arm()));
  read_line_for(input, host_hello(small_space_arm()));
}

/// A run of a few frames with a driver that answers with the input's lines. Every fault of a driver
/// is a SystemFault.
void talk_to_driver(const Input& input) {
  ProcessDriverSettings settings;
  settings.command = fmt::format("'{}' '{}'", LIMBER_SCRIPTED_DRIVER, input.file.string());
  settings.simulated = true;
  settings.check_rate = false;
  settings.install_signals = false;
  settings.pass_bodies = input.bytes.find("bodies") != std::string_view::npos;
  settings.say = [](const std::string& /*message*/) {};
  try {
    ProcessDriver driver(small_arm(), settings);
    for (int k = 1; k <= kFrames; ++k) {
      (void)driver.command(Pressures::Constant(1, kStepKpa * static_cast<float>(k)));
    }
    driver.vent();
  } catch (const SystemFault& fault) {
    require(is_utf8(fault.what()), "a fault that is not UTF-8: " + printable(fault.what()));
  }
}

/// What a driver says that does all it is asked.
std::string conversation(bool in_space) {
  const NoLoadModel model(small_arm());
  std::string text =
      R"({"type":"hello","protocol":1,"driver":"d","device":"s","rate_hz":20.0,"segments":1,)"
      R"("real_time":false,"limits_kpa":[[-90,100]]})"
      "\n";
  for (int k = 0; k <= kFrames + 1; ++k) {
    ArmState state;
    state.time_s = 0.05 * k;
    state.pressure_kpa = Pressures::Constant(1, k > kFrames ? 0.0F : kStepKpa * float(k));
    state.backbone.emplace(small_arm().point_count(), 3);
    model.backbone(state.pressure_kpa, *state.backbone);
    std::optional<BodyPoses> bodies;
    if (in_space) {
      bodies.emplace(small_arm().point_count(), 7);
      bodies->setZero();
      bodies->col(6).setOnes();
      state.backbone.reset();
    }
    text += state_line(k + 1, state, bodies) + "\n";
  }
  return text;
}

std::vector<std::string> line_seeds() {
  const std::string text = conversation(false);
  const std::size_t end = text.find('\n');
  ArmState in_space;
  in_space.pressure_kpa = Pressures::Zero(3);
  in_space.space_backbone.emplace(small_space_arm().point_count(), 7);
  in_space.space_backbone->setZero();
  in_space.space_backbone->col(6).setOnes();
  return {to_line(host_hello(small_space_arm())),
          state_line(1, in_space),
          text.substr(0, end),
          text.substr(end + 1, text.find('\n', end + 1) - end - 1),
          set_line(1, 0.5, Pressures::Zero(1)),
          to_line(host_hello(small_arm())),
          R"({"type":"fault","message":"no air"})"};
}

std::vector<std::string> conversation_seeds() {
  return {conversation(false), conversation(true)};
}

}  // namespace

std::vector<Target> driver_targets() {
  return {{"driver_line", "", read_driver_line, line_seeds},
          {"driver", "replies.txt", talk_to_driver, conversation_seeds}};
}

}  // namespace limber::fuzz
