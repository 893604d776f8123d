#include "limber/forward/recorded_region.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr float kRateSlack = 1.01F;     // rounding, and noise of what was measured
constexpr double kWithinSlack = 0.999;  // steps at a rate are rounded

/// Of a number over a whole plan.
struct Range {
  float low;
  float high;
  void cover(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

float slack_kpa(const LearntRegion& learnt, Eigen::Index i) {
  return float(kPressureSlack) * 0.5F * (learnt.high_kpa[i] - learnt.low_kpa[i]);
}

void add_pressures(const LearntRegion& learnt, const Plan& plan, Eigen::Index i,
                   const std::string& unit, std::vector<std::string>& found) {
  Range range{plan.frames.front().setpoint_kpa[i], plan.frames.front().setpoint_kpa[i]};
  for (const PlanFrame& frame : plan.frames) {
    range.cover(frame.setpoint_kpa[i]);
    range.cover(frame.pressure_kpa[i]);
  }
  const auto add = [&](const char* direction, float value) {
    found.push_back(fmt::format("{} {} {:.4g} {}; recorded {:.4g} … {:.4g}", segment_name(i),
                                direction, value, unit, learnt.low_kpa[i], learnt.high_kpa[i]));
  };
  if (range.low < learnt.low_kpa[i] - slack_kpa(learnt, i)) {
    add("down to", range.low);
  }
  if (range.high > learnt.high_kpa[i] + slack_kpa(learnt, i)) {
    add("up to", range.high);
  }
}

void add_rates(const LearntRegion& learnt, const Plan& plan, Eigen::Index i,
               const std::string& unit, std::vector<std::string>& found) {
  Range rate{0.0F, 0.0F};  // of a second
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    rate.cover((plan.frames[k].pressure_kpa[i] - plan.frames[k - 1].pressure_kpa[i]) *
               float(plan.frame_rate_hz));
  }
  const auto add = [&](const char* direction, float value, float recorded) {
    found.push_back(fmt::format("{} {} by {:.4g} {} per second; recorded up to {:.4g}",
                                segment_name(i), direction, value, unit, recorded));
  };
  if (-rate.low > kRateSlack * learnt.steepest_fall_kpa_per_s[i]) {
    add("falls", -rate.low, learnt.steepest_fall_kpa_per_s[i]);
  }
  if (rate.high > kRateSlack * learnt.steepest_rise_kpa_per_s[i]) {
    add("rises", rate.high, learnt.steepest_rise_kpa_per_s[i]);
  }
}

void add_novelty(const LearntRegion& learnt, const Plan& plan, const Command& command,
                 std::vector<std::string>& found) {
  int beyond = 0;
  double max_novelty = 0.0;
  std::size_t worst = 0;
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    const PlanFrame& now = plan.frames[k];
    const PlanFrame& before = plan.frames[k - 1];
    const double novelty =
        learnt.novelty(now.pressure_kpa, now.backbone, before.pressure_kpa, before.backbone);
    beyond += novelty > 1.0 ? 1 : 0;
    if (novelty > max_novelty) {
      max_novelty = novelty;
      worst = k;
    }
  }
  if (beyond > 0) {
    found.push_back(fmt::format(
        "in {} of {} frames {}s and shape together, or how they change, are beyond what was "
        "recorded, farthest in {}: novelty {:.2f}; 1 is the border",
        beyond, plan.frames.size() - 1, followed_name(command), frame_name(worst), max_novelty));
  }
}

}  // namespace

RecordedRegion::RecordedRegion(const LearntRegion& learnt, double frame_rate_hz)
    : learnt_(learnt),
      measure_(learnt),
      fall_kpa_(kRateSlack * learnt.steepest_fall_kpa_per_s / float(frame_rate_hz)),
      rise_kpa_(kRateSlack * learnt.steepest_rise_kpa_per_s / float(frame_rate_hz)) {}

double RecordedRegion::rate_limit_kpa_per_s() const {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Pressures* rates :
       {&learnt_.steepest_fall_kpa_per_s, &learnt_.steepest_rise_kpa_per_s}) {
    for (const float rate : *rates) {
      slowest = rate > 0.0F ? std::min(slowest, double(rate)) : slowest;
    }
  }
  return kWithinSlack * kRateSlack * slowest;
}

bool RecordedRegion::holds(const Eigen::Ref<const Pressures>& before_kpa,
                           const Eigen::Ref<const Pressures>& now_kpa,
                           const Eigen::Ref<const Backbone>& backbone_before,
                           const Eigen::Ref<const Backbone>& backbone, Workspace& workspace) const {
  const auto change = (now_kpa - before_kpa).array();
  return (change <= rise_kpa_.array()).all() && (-change <= fall_kpa_.array()).all() &&
         measure_.novelty(now_kpa.data(), backbone.data(), before_kpa.data(),
                          backbone_before.data(), workspace) <= 1.0F;
}

PressureBox RecordedRegion::setpoints_of(const ArmDescription& arm) const {
  return pressure_box(arm).within({learnt_.low_kpa, learnt_.high_kpa});
}

std::vector<std::string> excursions_beyond(const LearntRegion& learnt, const Plan& plan,
                                           const Command& command) {
  std::vector<std::string> found;
  for (Eigen::Index i = 0; i < learnt.segment_count(); ++i) {
    add_pressures(learnt, plan, i, command.unit, found);
    add_rates(learnt, plan, i, command.unit, found);
  }
  add_novelty(learnt, plan, command, found);
  return found;
}

}  // namespace limber
