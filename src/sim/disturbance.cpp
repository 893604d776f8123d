#include "limber/sim/disturbance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

constexpr double kDisturbedLatencyS = 0.1;
constexpr std::uint64_t kDisturbanceStreams = 0x64697374;  // + the kind

struct KindFacts {
  DisturbanceKind kind;
  const char* name;
  double usual;
  double max;
  const char* unit;
};

constexpr std::array kKindFacts = {
    KindFacts{DisturbanceKind::tip_load, "tip_load", 0.05, 1.0, "kg"},
    KindFacts{DisturbanceKind::friction, "friction", 0.3, 10.0, "share more"},
    KindFacts{DisturbanceKind::weak_actuator, "weak_actuator", 0.2, 1.0, "share lost"},
    KindFacts{DisturbanceKind::noise, "noise", 0.0005, 0.1, "m"},
    KindFacts{DisturbanceKind::lost_tracking, "lost_tracking", 0.5, 60.0, "s"},
    KindFacts{DisturbanceKind::obstacle, "obstacle", 0.02, 0.5, "m, radius"},
    KindFacts{DisturbanceKind::sensor_noise, "sensor_noise", 0.0005, 0.1, "m"},
    KindFacts{DisturbanceKind::picked_up, "picked_up", 0.05, 1.0, "kg"},
    KindFacts{DisturbanceKind::leak, "leak", 0.1, 0.9, "share of a set point"},
};

const KindFacts& facts_of(DisturbanceKind kind) {
  return kKindFacts[std::size_t(kind)];
}

double read_amount(const KindFacts& facts, const std::string& text) {
  const double amount = number_in(text).value_or(0.0);
  refuse_if(!(amount > 0.0 && amount <= facts.max),
            "disturbance {}={}: expected a number above 0, at most {} ({})", facts.name, text,
            facts.max, facts.unit);
  return amount;
}

Disturbance parse_one(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  for (const KindFacts& facts : kKindFacts) {
    if (name == facts.name) {
      return {facts.kind, equals == std::string::npos
                              ? facts.usual
                              : read_amount(facts, text.substr(equals + 1))};
    }
  }
  throw InputError(
      fmt::format("disturbance '{}': no such kind; expected {}", text, disturbance_kinds()));
}

/// Somewhere in the plan's motion, so that it ends within it where the motion is long enough.
double drawn_start_s(const ArmDescription& arm, const Plan& plan, double duration_s,
                     RandomStream& random) {
  const int moving = plan.frame_count() - 1 - plan.hold_frame_count;
  return random.uniform(0.0, std::max(moving * arm.frame_period_s() - duration_s, 0.0));
}

}  // namespace

const char* to_string(DisturbanceKind kind) {
  return facts_of(kind).name;
}

std::string disturbance_kinds() {
  std::string text;
  for (const KindFacts& facts : kKindFacts) {
    text += fmt::format("{}{}[={}] ({})", text.empty() ? "" : ", ", facts.name, facts.usual,
                        facts.unit);
  }
  return text;
}

std::vector<Disturbance> parse_disturbances(const std::string& text) {
  std::vector<Disturbance> result;
  for (std::size_t begin = 0; begin < text.size() || (begin > 0 && begin == text.size());) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const Disturbance one = parse_one(text.substr(begin, end - begin));
    if (has_kind(result, one.kind)) {
      throw InputError(fmt::format("disturbance '{}': {} twice; each kind acts once", text,
                                   to_string(one.kind)));
    }
    result.push_back(one);
    begin = end + 1;
  }
  return result;
}

std::string to_string(const std::vector<Disturbance>& disturbances) {
  std::string text;
  for (const Disturbance& one : disturbances) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", to_string(one.kind));
    if (one.amount != facts_of(one.kind).usual) {
      text += fmt::format("={}", one.amount);
    }
  }
  return text;
}

bool has_kind(const std::vector<Disturbance>& disturbances, DisturbanceKind kind) {
  return std::ranges::count(disturbances, kind, &Disturbance::kind) > 0;
}

DisturbedArm disturbed(const ArmDescription& arm, const Plan& plan,
                       const std::vector<Disturbance>& disturbances, std::uint64_t seed,
                       const VirtualArmOptions& options) {
  DisturbedArm result{arm, options, std::nullopt};
  result.options.seed = seed;
  VirtualArmParameters later;  // what changes in mid-plan, all of it at one moment
  for (const Disturbance& one : disturbances) {
    const std::uint64_t stream = kDisturbanceStreams + std::uint64_t(one.kind);
    RandomStream random(seed, stream);
    switch (one.kind) {
      case DisturbanceKind::tip_load:
        change_virtual_arm(result.arm, [&](auto& p) { p.tip_load_kg += one.amount; });
        break;
      case DisturbanceKind::friction:
        change_virtual_arm(result.arm, [&](auto& p) {
          p.friction_coefficient *= 1.0 + one.amount;
          p.joint_friction_n_m *= arm.is_spatial() ? 1.0 + one.amount : 1.0;
          p.hysteresis_fraction *= 1.0 + one.amount;
          p.hysteresis_floor_n *= 1.0 + one.amount;
        });
        break;
      case DisturbanceKind::weak_actuator:
        require_planar(arm, "the disturbance weak_actuator");
        change_virtual_arm(result.arm, [&](auto& p) {
          p.weak_side = int(random.index(2 * std::uint32_t(arm.segment_count())));
          p.weak_side_loss = one.amount;
        });
        break;
      case DisturbanceKind::noise:
        result.options.latency_s = kDisturbedLatencyS;
        [[fallthrough]];
      case DisturbanceKind::sensor_noise:
        result.options.noise_m = std::hypot(result.options.noise_m, one.amount);
        break;
      case DisturbanceKind::lost_tracking:
        result.options.lost_for_s = one.amount;
        result.options.lost_from_s = drawn_start_s(arm, plan, one.amount, random);
        break;
      case DisturbanceKind::picked_up:
        later.tip_load_kg = one.amount;
        break;
      case DisturbanceKind::leak:
        later.leak_share = one.amount;
        later.leaking_channel = int(random.index(std::uint32_t(arm.channel_count())));
        break;
      case DisturbanceKind::obstacle:
        result.obstacle = appearing_obstacle(arm, plan, one.amount, seed, stream);
        break;
    }
  }
  if (later.tip_load_kg > 0.0 || later.leak_share > 0.0) {  // of the arm as all other kinds have it
    RandomStream random(seed, kDisturbanceStreams + std::uint64_t(DisturbanceKind::picked_up));
    result.options.later_from_s = drawn_start_s(arm, plan, 0.0, random);
    result.options.later = result.arm;
    change_virtual_arm(*result.options.later, [&](auto& p) {
      p.tip_load_kg += later.tip_load_kg;
      if (later.leak_share > 0.0) {
        p.leak_share = later.leak_share;
        p.leaking_channel = later.leaking_channel;
      }
    });
  }
  return result;
}

}  // namespace limber
