#include "limber/driver/driver_check.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <thread>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr double kRestS = 3.0;
constexpr double kPulseS = 1.0;
constexpr double kStepS = 1.5;
constexpr double kPulseShare = 0.05;  // of the limit in force
constexpr double kStepShare = 0.3;
constexpr double kMeanS = 0.3;         // at the end of a hold
constexpr int kMinHoldFrames = 3;      // at low rates: a state may be of the frame before
constexpr double kMaxCrosstalk = 0.5;  // of a pulse, in a segment that was not told to move
constexpr double kSlotS = 0.005;       // a `set` later than that is late
constexpr double kMaxLateShare = 0.001;
constexpr double kMaxLateS = 0.025;  // of any
constexpr double kNoiseDeviations = 4.0;
constexpr double kMovedShare = 0.05;  // of the jump: the reading has moved
constexpr double kVentedShare = 0.5;  // of the pressure before: less says that a deadman vented

/// Index, interpolated, at which the readings first reach `level`.
std::optional<double> crossing(const std::vector<double>& readings, double level) {
  const auto at = std::ranges::find_if(readings, [&](double kpa) { return kpa >= level; });
  if (at == readings.begin() || at == readings.end()) {
    return at == readings.end() ? std::nullopt : std::optional(0.0);
  }
  return double(at - readings.begin()) - (*at - level) / (*at - *std::prev(at));
}

/// One run of checks on one driver.
class Check {
 public:
  Check(const ArmDescription& arm, const ProcessDriverSettings& settings)
      : arm_(arm), settings_(settings) {
    // What the watch would stop for is what this check measures.
    constexpr double kNever = 1e9;
    settings_.check_rate = false;
    settings_.safety.following_error_kpa = kNever;
    settings_.safety.stuck_change_kpa = kNever;
    driver_.emplace(arm_, settings_);
    result_.hello = driver_->hello();
    for (int s = 0; s < channels(); ++s) {
      result_.channels.push_back(channel_name(arm_, s));
    }
  }

  DriverCheck run() {
    rest();
    const bool reads_right = for_each_side(&Check::pulse);
    if (reads_right) {
      for_each_side(&Check::step);
      test_silence();
    }
    driver_->vent();
    result_.timing = driver_->timing();
    if (reads_right) {
      test_end_of_input();
    }
    judge_timing();
    keep_episode();
    return std::move(result_);
  }

 private:
  int channels() const { return arm_.channel_count(); }
  const std::string& name(int channel) const { return result_.channels[channel]; }

  /// Holds a set point and keeps what is read. @return the first frame of it
  std::size_t hold(const Pressures& setpoint_kpa, double seconds, int min_frames = kMinHoldFrames) {
    const std::size_t first = time_s_.size();
    for (int k = 0; k < std::max(arm_.frames_in(seconds), min_frames); ++k) {
      throw_if_interrupted();
      const ArmState& state = driver_->command(setpoint_kpa);
      time_s_.push_back(state.time_s);
      setpoints_.push_back(state.setpoint_kpa.value_or(setpoint_kpa));
      readings_.push_back(state.pressure_kpa);
    }
    return first;
  }

  std::vector<double> readings(int segment, std::size_t first) const {
    std::vector<double> values;
    for (std::size_t k = first; k < readings_.size(); ++k) {
      values.push_back(readings_[k][segment]);
    }
    return values;
  }

  double last_mean(int segment) const {
    const std::vector<double> values = readings(segment, 0);
    const auto count = std::size_t(arm_.frames_in(kMeanS));
    return mean(std::span(values).last(count));
  }

  void rest() {
    const std::size_t first = hold(Pressures::Zero(channels()), kRestS);
    for (int s = 0; s < channels(); ++s) {
      const std::vector<double> values = readings(s, first);
      result_.zero_kpa.push_back(mean(values));
      result_.noise_kpa.push_back(standard_deviation(values));
    }
  }

  /// @return whether nothing was wrong; the first complaint ends it.
  bool for_each_side(void (Check::*move)(int segment, double sign)) {
    for (int s = 0; s < channels(); ++s) {
      for (const double sign : {1.0, -1.0}) {
        if (limit_kpa(s, sign) != 0.0) {
          (this->*move)(s, sign);
        }
        if (!result_.complaints.empty()) {
          return false;
        }
      }
    }
    return true;
  }

  Pressures alone(int segment, double kpa) const {
    Pressures result = Pressures::Zero(channels());
    result[segment] = float(kpa);
    return result;
  }

  /// Of the side that positive or negative set points are on; 0 where the segment has none there.
  double limit_kpa(int segment, double sign) const {
    return driver_->limits_kpa()[segment].side_kpa(sign);
  }

  void pulse(int segment, double sign) {
    const double wanted = kPulseShare * limit_kpa(segment, sign);
    hold(alone(segment, wanted), kPulseS);
    const double zero = result_.zero_kpa[segment];
    const std::string wrong = scale_complaint(name(segment), wanted, last_mean(segment) - zero);
    for (int s = 0; s < channels(); ++s) {
      const double moved = last_mean(s) - result_.zero_kpa[s];
      if (s != segment && std::abs(moved) > kMaxCrosstalk * std::abs(wanted)) {
        complain(
            fmt::format("a set point of {:.1f} kPa for {} moved {} by {:.1f} kPa: channels "
                        "are swapped, or share air",
                        wanted, name(segment), name(s), moved));
      }
    }
    if (!wrong.empty()) {
      complain(wrong);
    }
    hold(Pressures::Zero(channels()), kPulseS);
  }

  void step(int segment, double sign) {
    const double wanted = kStepShare * limit_kpa(segment, sign);
    const std::size_t first = hold(alone(segment, wanted), kStepS);
    std::vector<double> moved_kpa = readings(segment, first);
    for (double& kpa : moved_kpa) {
      kpa -= result_.zero_kpa[segment];
    }
    StepResponse response =
        step_response(moved_kpa, arm_.frame_period_s(), wanted, result_.noise_kpa[segment]);
    response.channel = segment;
    result_.steps.push_back(response);
    ramp_down(alone(segment, wanted));
    hold(Pressures::Zero(channels()), kStepS);
  }

  /// Back to zero at half the arm's rate: jumps alone say little about a valve.
  void ramp_down(const Pressures& from_kpa) {
    constexpr int kMinFrames = 10;
    const Pressures zero = Pressures::Zero(channels());
    const int count = std::max(
        kMinFrames, 2 * motion_frame_count(from_kpa, zero, arm_.pressure_step_limit_kpa()));
    Pressures setpoint_kpa = from_kpa;
    for (int k = 1; k <= count; ++k) {
      motion_setpoint(from_kpa, zero, k, count, setpoint_kpa);
      hold(setpoint_kpa, arm_.frame_period_s(), 1);
    }
  }

  /// Raises every pressure to `kPulseShare`-sized ones that a deadman has to take away.
  /// @return what is read then; -1 of a channel that the driver allows nothing
  Pressures pressurise() {
    Pressures wanted(channels());
    for (int s = 0; s < channels(); ++s) {
      const double sign = limit_kpa(s, 1.0) != 0.0 ? 1.0 : -1.0;
      wanted[s] = float(2.0 * kPulseShare * limit_kpa(s, sign));
    }
    hold(wanted, kPulseS);
    return (wanted.array() != 0.0F).select(above_zero_kpa(driver_->state()).array(), -1.0F);
  }

  /// Sizes of the readings, without what the sensors say of no pressure.
  Pressures above_zero_kpa(const ArmState& state) const {
    const Eigen::Map<const Eigen::VectorXd> zero_kpa(result_.zero_kpa.data(), channels());
    return (state.pressure_kpa - zero_kpa.cast<float>()).cwiseAbs();
  }

  void test_silence() {
    if (!result_.hello.real_time) {
      return;  // a simulation that keeps no frames
    }
    result_.silence.tested = true;
    const Pressures before_kpa = pressurise();
    const ArmState after = driver_->read_after_silence(silence_s(arm_.frame_period_s()));
    judge(result_.silence, before_kpa, after, "no set came for three frames");
  }

  void test_end_of_input() {
    DeadmanResult& deadman = result_.end_of_input;
    deadman.tested = true;
    const Pressures before_kpa = pressurise();
    driver_->abandon();
    std::this_thread::sleep_for(std::chrono::duration<double>(silence_s(0.0)));  // frames or not
    judge(deadman, before_kpa, start_again(), "its input was closed");
    deadman.starts_vented = deadman.vented && starts_vented();
  }

  /// What was read at the end of input counts only where a start shows what is there: killed under
  /// pressure, a driver had no time to vent, nor had the device for its 0.3 s.
  bool starts_vented() {
    const Pressures before_kpa = pressurise();
    driver_->abandon(true);
    return !held_channel(before_kpa, above_zero_kpa(start_again()));
  }

  const ArmState& start_again() {
    keep_episode();
    driver_.reset();
    settings_.append_to_log = true;
    driver_.emplace(arm_, settings_);
    return driver_->first_state();
  }

  /// A channel that has kept its pressure; none: all were vented.
  static std::optional<int> held_channel(const Pressures& before_kpa, const Pressures& after_kpa) {
    for (int s = 0; s < before_kpa.size(); ++s) {
      if (before_kpa[s] >= 0.0F && !(after_kpa[s] < kVentedShare * before_kpa[s])) {
        return s;
      }
    }
    return std::nullopt;
  }

  void judge(DeadmanResult& deadman, const Pressures& before_kpa, const ArmState& after,
             const char* when) {
    const Pressures after_kpa = above_zero_kpa(after);
    const std::optional<int> held = held_channel(before_kpa, after_kpa);
    Eigen::Index shown = 0;
    before_kpa.maxCoeff(&shown);
    shown = held.value_or(int(shown));
    deadman.vented = !held;
    deadman.before_kpa = before_kpa[shown];
    deadman.after_kpa = after_kpa[shown];
    if (held) {
      complain(
          fmt::format("the driver did not vent when {}: {:.1f} kPa before, {:.1f} kPa after, {}. "
                      "docs/driver.md says what it has to do",
                      when, deadman.before_kpa, deadman.after_kpa, name(*held)));
    }
  }

  void judge_timing() {
    const std::vector<double>& late = result_.timing.late_s;
    const auto count = std::count_if(late.begin(), late.end(), [](double s) { return s > kSlotS; });
    const double share = late.empty() ? 0.0 : double(count) / double(late.size());
    const double latest_s = late.empty() ? 0.0 : *std::max_element(late.begin(), late.end());
    if (result_.hello.real_time &&
        (share > kMaxLateShare || latest_s > kMaxLateS || result_.timing.skipped_slots > 0)) {
      complain(fmt::format(
          "{} of {} set points left more than 5 ms after their slot, the latest {:.0f} ms, and {} "
          "slots passed without one: the driver answers too late, or this computer is too busy",
          count, late.size(), 1e3 * latest_s, result_.timing.skipped_slots));
    }
  }

  void complain(std::string text) { result_.complaints.push_back(std::move(text)); }

  /// Of the first driver alone: the clock of the next one begins again.
  void keep_episode() {
    if (result_.episode.frame_count() == 0) {
      result_.episode = episode();
    }
  }

  Episode episode() const {
    Episode result;
    const auto frames = Eigen::Index(time_s_.size());
    result.time_s = Eigen::Map<const Eigen::VectorXd>(time_s_.data(), frames).array() - time_s_[0];
    result.pressure_kpa.resize(frames, channels());
    result.setpoint_kpa.resize(frames, channels());
    for (Eigen::Index k = 0; k < frames; ++k) {
      result.pressure_kpa.row(k) = readings_[k].transpose();
      result.setpoint_kpa.row(k) = setpoints_[k].transpose();
    }
    result.dimension = arm_.dimension;
    result.backbone = FrameMatrix::Zero(frames, pose_size(arm_.dimension) * arm_.point_count());
    for (Eigen::Index w = 6; arm_.is_spatial() && w < result.backbone.cols(); w += kSpacePoseSize) {
      result.backbone.col(w).setOnes();  // no rotation
    }
    result.motion_index.assign(time_s_.size(), 0);
    result.tracked.assign(time_s_.size(), 0);
    return result;
  }

  ArmDescription arm_;
  ProcessDriverSettings settings_;
  std::optional<ProcessDriver> driver_;
  DriverCheck result_;
  std::vector<double> time_s_;
  std::vector<Pressures> setpoints_;
  std::vector<Pressures> readings_;
};

}  // namespace

DriverCheck check_driver(const ArmDescription& arm, const ProcessDriverSettings& settings) {
  return Check(arm, settings).run();
}

std::string scale_complaint(const std::string& channel, double setpoint_kpa, double measured_kpa) {
  struct Scale {
    double factor;
    const char* says;
  };
  constexpr std::array<Scale, 6> kScales = {{
      {1.0 / kKpaPerPsi, "the driver sends psi; the wire is in kPa"},
      {kKpaPerPsi, "the driver takes set points for psi; the wire is in kPa"},
      {10.0, "the driver sends mbar; the wire is in kPa"},
      {0.1, "the driver takes set points for mbar; the wire is in kPa"},
      {0.01, "the driver sends bar; the wire is in kPa"},
      {1000.0, "the driver sends Pa; the wire is in kPa"},
  }};
  constexpr double kAlike = 1.25;  // factors so close are the same unit
  const double factor = measured_kpa / setpoint_kpa;
  if (factor >= 0.5 && factor <= 2.0) {
    return "";
  }
  std::string guess = "check supply, valve and sensor";
  if (factor <= -0.5 && factor >= -2.0) {
    guess = "left and right are swapped, or the sign";
  }
  for (const Scale& scale : kScales) {
    if (factor > scale.factor / kAlike && factor < scale.factor * kAlike) {
      guess = scale.says;
    }
  }
  return fmt::format("{} reads {:.2f} kPa at a set point of {:.2f} kPa: {}", channel, measured_kpa,
                     setpoint_kpa, guess);
}

StepResponse step_response(const std::vector<double>& reading_kpa, double period_s,
                           double setpoint_kpa, double noise_kpa) {
  StepResponse response;
  response.setpoint_kpa = setpoint_kpa;
  const double sign = setpoint_kpa < 0.0 ? -1.0 : 1.0;
  const auto upward =
      mapped<double>(reading_kpa, [&](const double reading) { return sign * reading; });
  if (upward.empty()) {
    return response;
  }
  const auto count =
      std::min(upward.size(), std::size_t(std::max(1L, std::lround(kMeanS / period_s))));
  const double reached = mean(std::span(upward).last(count));
  response.reached_kpa = sign * reached;
  response.overshoot_kpa = std::max(0.0, *std::max_element(upward.begin(), upward.end()) - reached);
  const double moved = std::max(kNoiseDeviations * noise_kpa, kMovedShare * std::abs(setpoint_kpa));
  const std::optional<double> dead = crossing(upward, moved);
  const std::optional<double> low = crossing(upward, 0.1 * reached);
  const std::optional<double> high = crossing(upward, 0.9 * reached);
  if (dead && low && high && reached > moved) {
    response.answered = true;
    response.dead_time_s = *dead * period_s;
    response.rise_time_s = (*high - *low) * period_s;
  }
  return response;
}

}  // namespace limber
