#include "limber/sim/driver_server.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <deque>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/standard_streams.hpp"
#include "limber/common/version.hpp"
#include "limber/driver/device_process.hpp"
#include "limber/driver/driver_protocol.hpp"
#include "limber/driver/line_reader.hpp"
#include "limber/sim/misassembly.hpp"

namespace limber {

namespace {

using Clock = LineReader::Clock;
using Kind = ServerFaultKind;

constexpr int kSilentFrames = 3;       // without a request: the deadman vents
constexpr double kFastSilenceS = 2.0;  // the same of a server that keeps no frames
constexpr int kLateFrames = 4;
constexpr float kOverLimit = 1.2F;
constexpr float kJumpM = 0.5F;
constexpr float kRiseKpa = 3.0F;  // a frame

class DriverServer {
 public:
  DriverServer(const ArmDescription& arm, const ServerSettings& settings)
      : device_(settings.device_log),
        settings_(settings),
        description_(arm),
        host_(host_hello(arm)),
        arm_(arm, settings.arm),
        wire_(settings.misassembly, arm_, settings.arm, !settings.fast),
        input_(::dup(STDIN_FILENO), kMaxDriverLine),
        in_force_(Pressures::Zero(arm.channel_count())) {}

  void run() {
    std::string line;
    if (answers_at_once()) {
      measured_ = advance(in_force_);
    }
    while (!done_) {
      if (interrupt_requested()) {
        vent("stopped on request");
        return;
      }
      switch (input_.read_line(line, next_deadline())) {
        case LineReader::Read::line:
          answer(line);
          break;
        case LineReader::Read::timeout:
          tick();
          break;
        default:
          vent("end of input");
          return;
      }
    }
  }

 private:
  double period_s() const { return description_.frame_period_s(); }

  static Clock::duration duration(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

  /// While it moves: until the deadman. Then, in real time, frame by frame: the arm goes on.
  Clock::time_point next_deadline() const {
    if (settings_.fast) {
      return (resting_ ? Clock::now() : last_set_) + duration(kFastSilenceS);
    }
    return resting_ ? Clock::now() + duration(period_s())
                    : last_set_ + duration(kSilentFrames * period_s());
  }

  void tick() {
    if (!resting_) {
      vent("no set for three frames");
    } else if (!settings_.fast) {
      measured_ = advance(in_force_);
    }
  }

  void vent(const char* why) {
    device_.vent(why);
    arm_.vent();
    in_force_.setZero();
    resting_ = true;
  }

  ArmState advance(const Pressures& setpoint_kpa) {
    if (resting_) {
      arm_.vent();
    }
    ArmState state = arm_.command(wire_.from_wire(setpoint_kpa));
    state.setpoint_kpa = in_force_then(wire_.from_wire(in_force_));
    return wire_.to_wire(std::move(state));
  }

  /// Set points of the frame that is measured now: with a latency, of an earlier one.
  Pressures in_force_then(Pressures now_kpa) {
    if (were_in_force_.empty()) {
      constexpr double kRounding = 1e-9;
      const auto late = std::size_t(settings_.arm.latency_s / period_s() + kRounding);
      were_in_force_.assign(late + 1, Pressures::Zero(now_kpa.size()));
    }
    were_in_force_.pop_front();
    were_in_force_.push_back(std::move(now_kpa));
    return were_in_force_.front();
  }

  /// A frame at the set points in force. @return the state that answers its request
  ArmState next_frame() {
    ArmState end = advance(in_force_);
    ArmState state = answers_at_once() ? std::exchange(measured_, std::move(end)) : std::move(end);
    return settings_.sampled_s > 0.0 ? newest_sample(std::move(state)) : state;
  }

  bool answers_at_once() const { return settings_.at_once || settings_.sampled_s > 0.0; }

  /// `now` where the tracker has seen the arm since the last request, else what it saw then.
  ArmState newest_sample(ArmState now) {
    const double since_s = seconds_since(start_);
    const double sample_s = std::floor(since_s / settings_.sampled_s) * settings_.sampled_s;
    if (!sample_ || sample_s > sample_->time_s) {
      sample_ = std::move(now);
      sample_->time_s = sample_s;
    }
    return *sample_;
  }

  void answer(const std::string& line) {
    try {
      const DriverRequest request = parse_request(line, host_);
      switch (request.kind) {
        case RequestKind::hello:
          say_hello();
          break;
        case RequestKind::set:
          last_set_ = Clock::now();
          set(request);
          break;
        case RequestKind::vent:
          vent("command");
          reply(request.seq, next_frame());
          break;
        default:
          vent("bye");
          done_ = true;
      }
    } catch (const std::runtime_error& error) {
      vent("fault");
      write(fault_line(error.what()) + "\n");
    }
  }

  void say_hello() {
    DriverHello hello;
    hello.driver = fmt::format("limber virtual-arm {}", version());
    hello.device = "a simulated arm and its valves";
    hello.rate_hz = host_.rate_hz;
    hello.segments = host_.segments + (plays(Kind::hello) ? 1 : 0);
    hello.chambers = host_.chambers;
    hello.real_time = !settings_.fast;
    if (!plays(Kind::hello)) {
      hello.limit_kpa = wire_.to_wire(host_.limit_kpa);
    }
    write(limber::to_line(hello) + "\n");
  }

  void set(const DriverRequest& request) {
    ++frame_;
    resting_ = false;
    in_force_ = request.setpoint_kpa;
    device_.set(in_force_);
    const ArmState state = next_frame();
    if (due() && frame_ == settings_.fault->frame) {
      device_.note(to_string(settings_.fault->kind), frame_);
    }
    reply(request.seq, state);
  }

  std::string to_line(std::int64_t seq, const ArmState& state) {
    return state_line(seq, state, wire_.bodies(state)) + "\n";
  }

  /// Whether the fault plays from this frame on.
  bool due() const { return settings_.fault && frame_ >= settings_.fault->frame; }
  bool plays(Kind kind) const { return settings_.fault && settings_.fault->kind == kind; }

  void reply(std::int64_t seq, const ArmState& state) {
    if (due()) {
      wrong_reply(seq, state);
    } else {
      write(to_line(seq, state));
      last_ = state;
    }
  }

  void wrong_reply(std::int64_t seq, ArmState state) {
    const std::string line = to_line(seq, state);
    switch (settings_.fault->kind) {
      case Kind::late:
        std::this_thread::sleep_for(duration(kLateFrames * period_s()));
        write(line);
        break;
      case Kind::repeat:
        write(line + line);
        break;
      case Kind::old:
        write(to_line(seq - 1, state));
        break;
      case Kind::half:
        write(line.substr(0, line.size() / 2));
        break;
      case Kind::huge:
        write_a_gigabyte();
        break;
      case Kind::nan:
        write(with_first_pressure(line, "NaN"));
        break;
      case Kind::size:
        write(with_first_pressure(line, "0.0, 0.0"));
        break;
      case Kind::clock:
        state.time_s -= 2.0 * period_s();
        write(to_line(seq, state));
        break;
      case Kind::die:
        ::_exit(9);
      case Kind::hang:
        std::this_thread::sleep_for(std::chrono::hours(1));
        break;
      case Kind::flood:
        while (write(line)) {
        }
        break;
      default:
        write(to_line(seq, wrong_state(std::move(state))));
    }
  }

  ArmState wrong_state(ArmState state) {
    if (last_.pressure_kpa.size() == 0) {
      last_ = state;  // the first reply is wrong already
    }
    switch (settings_.fault->kind) {
      case Kind::over:
        state.pressure_kpa[0] = kOverLimit * float(host_.limit_kpa[0].largest_kpa());
        break;
      case Kind::stuck:
        state.pressure_kpa[0] = last_.pressure_kpa[0];
        break;
      case Kind::jump:
        if (state.backbone) {
          state.backbone->bottomRows(1)(0, 1) += kJumpM;
        } else if (state.space_backbone) {
          state.space_backbone->bottomRows(1)(0, 1) += kJumpM;
        }
        break;
      case Kind::sealed:
        state.pressure_kpa = last_.pressure_kpa;
        break;
      case Kind::rise:
        if (resting_) {
          state.pressure_kpa = last_.pressure_kpa.array() + kRiseKpa;
        }
        last_ = state;
        break;
      case Kind::release:
        vent("by itself");
        state.setpoint_kpa = in_force_;
        break;
      default:
        break;
    }
    return state;
  }

  /// `line` with `text` in place of its first pressure.
  static std::string with_first_pressure(std::string line, const std::string& text) {
    const std::string key = "\"pressure_kpa\":[";
    const std::size_t begin = line.find(key) + key.size();
    return line.replace(begin, line.find_first_of(",]", begin) - begin, text);
  }

  void write_a_gigabyte() {
    constexpr std::size_t kBlock = std::size_t{1} << 20U;
    constexpr int kBlocks = 1024;
    const std::string block(kBlock, 'x');
    for (int i = 0; i < kBlocks && write(block); ++i) {
    }
  }

  /// @return whether somebody still reads.
  bool write(std::string_view text) {
    WithoutBrokenPipe guard;
    while (!text.empty() && !done_) {
      const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
      if (written >= 0) {
        text.remove_prefix(std::size_t(written));
      } else if (errno != EINTR || interrupt_requested()) {
        guard.note(errno);
        vent("nobody reads the states");
        done_ = true;
      }
    }
    return !done_;
  }

  DeviceProcess device_;  // first: it is a copy of this process as it was then
  ServerSettings settings_;
  ArmDescription description_;
  HostHello host_;
  VirtualArm arm_;
  MisassembledWire wire_;
  LineReader input_;
  ArmState measured_;               // at the end of the last frame, as on the wire
  std::optional<ArmState> sample_;  // that the tracker has seen last
  Clock::time_point start_ = Clock::now();
  Pressures in_force_;
  std::deque<Pressures> were_in_force_;  // in the last frames, the one that is measured first
  Clock::time_point last_set_ = Clock::now();
  ArmState last_;
  int frame_ = -1;  // of the last `set`
  bool resting_ = true;
  bool done_ = false;
};

}  // namespace

void serve_virtual_arm(const ArmDescription& arm, const ServerSettings& settings) {
  require_pressure_driven(arm, "the virtual arm");
  DriverServer(arm, settings).run();
}

}  // namespace limber
