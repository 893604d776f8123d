#include "limber/run/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/run/safety_settings.hpp"

namespace limber {

namespace {

constexpr int kTransitionEpisodes = 16;
constexpr int kMaxFullSchedule = 3;  // channels; 729 transitions
constexpr int kMaxWalk = 6;          // channels; 531 441 edges held in memory
constexpr int kMaxCount = 10'000'000;
constexpr double kLongestHold_s = 3600.0;
constexpr std::uint64_t kScheduleStream = 0x7363'6865'6475'6c65;  // apart from a driver's streams

/// Vertices of an Eulerian circuit of the complete directed graph with self-loops (Hierholzer),
/// from vertex 0 back to it: vertices² + 1 entries. Order sampled by `random`.
std::vector<int> eulerian_circuit(int vertices, RandomStream& random) {
  std::vector<std::vector<int>> unused(static_cast<std::size_t>(vertices));
  for (std::vector<int>& successors : unused) {
    successors.resize(static_cast<std::size_t>(vertices));
    std::iota(successors.begin(), successors.end(), 0);
    for (std::size_t i = successors.size(); i > 1; --i) {
      std::swap(successors[i - 1], successors[random.index(static_cast<std::uint32_t>(i))]);
    }
  }
  std::vector<int> path = {0};
  std::vector<int> circuit;
  while (!path.empty()) {
    std::vector<int>& successors = unused[static_cast<std::size_t>(path.back())];
    if (successors.empty()) {
      circuit.push_back(path.back());
      path.pop_back();
    } else {
      path.push_back(successors.back());
      successors.pop_back();
    }
  }
  std::reverse(circuit.begin(), circuit.end());
  return circuit;
}

std::vector<int> random_walk(std::uint32_t vertices, int steps, RandomStream& random) {
  std::vector<int> walk = {0};
  for (int i = 0; i < steps; ++i) {
    walk.push_back(static_cast<int>(random.index(vertices)));
  }
  return walk;
}

void require(bool condition, const std::string& message) {
  if (!condition) {
    throw InputError(message);
  }
}

void check(const ScheduleSettings& settings) {
  require(settings.count >= 0 && settings.count <= kMaxCount,
          fmt::format("--count {}: expected a number of motions from 1 to {}", settings.count,
                      kMaxCount));
  require(settings.episodes >= 0 && settings.episodes <= 1'000'000,
          fmt::format("--episodes {}: expected from 1 to 1000000", settings.episodes));
  require(settings.hold_s > 0.0 && settings.hold_s <= kLongestHold_s,
          fmt::format("--hold-s {}: expected seconds, > 0 and at most {}", settings.hold_s,
                      kLongestHold_s));
  const double min_s = settings.hold_min_s.value_or(0.0);
  require(min_s >= 0.0 && min_s <= settings.hold_s,
          fmt::format("--hold-min-s {}: expected seconds from 0 to --hold-s {}", min_s,
                      settings.hold_s));
}

Motion make_motion(const ScheduleSettings& settings, Pressures setpoint_kpa, RandomStream& random) {
  const double hold_s =
      settings.hold_min_s ? random.uniform(*settings.hold_min_s, settings.hold_s) : settings.hold_s;
  return {std::move(setpoint_kpa), hold_s, !settings.hold_min_s.has_value()};
}

int transition_count(const ArmDescription& arm, const ScheduleSettings& settings) {
  const int n = arm.channel_count();
  const double all = std::pow(static_cast<double>(kCornerStates), 2 * n);
  if (settings.count == 0) {
    require(n <= kMaxFullSchedule,
            fmt::format("--schedule transitions: arm '{}' has {} {}, so {:.0f} ordered "
                        "transitions, {:.1f} h at {} s each; give --count N to take N of them",
                        arm.name, n, arm.is_spatial() ? "chambers" : "segments", all,
                        all * settings.hold_s / 3600.0, settings.hold_s));
    return static_cast<int>(all);
  }
  require(settings.count <= all,
          fmt::format("--count {}: arm '{}' has only {:.0f} ordered transitions", settings.count,
                      arm.name, all));
  return settings.count;
}

std::vector<EpisodeSchedule> transition_schedule(const ArmDescription& arm,
                                                 const ScheduleSettings& settings,
                                                 std::uint64_t seed) {
  const int n = arm.channel_count();
  const int count = transition_count(arm, settings);
  RandomStream random(seed, kScheduleStream);
  std::uint32_t vertices = 1;  // where there are more, some corners are never walked to
  for (int i = 0; i < n; ++i) {
    vertices *= kCornerStates;
  }
  const std::vector<int> walk = n <= kMaxWalk ? eulerian_circuit(static_cast<int>(vertices), random)
                                              : random_walk(vertices, count, random);
  const int wanted = settings.episodes == 0 ? kTransitionEpisodes : settings.episodes;
  const int episodes = std::min(wanted, count);
  std::vector<EpisodeSchedule> result(static_cast<std::size_t>(episodes));
  for (int e = 0; e < episodes; ++e) {
    const auto first = static_cast<std::size_t>(std::int64_t{e} * count / episodes);
    const auto last = static_cast<std::size_t>(std::int64_t{e + 1} * count / episodes);
    EpisodeSchedule& episode = result[static_cast<std::size_t>(e)];
    episode.first_kpa = corner_configuration(arm, walk[first]);
    for (std::size_t i = first; i < last; ++i) {
      episode.motions.push_back(
          make_motion(settings, corner_configuration(arm, walk[i + 1]), random));
    }
  }
  return result;
}

std::vector<EpisodeSchedule> random_schedule(const ArmDescription& arm,
                                             const ScheduleSettings& settings, std::uint64_t seed) {
  require(settings.count > 0, "--schedule random: --count N is missing, motions of each episode");
  const int episodes = std::max(1, settings.episodes);
  std::vector<EpisodeSchedule> result(static_cast<std::size_t>(episodes));
  for (std::size_t e = 0; e < result.size(); ++e) {
    RandomStream random(seed, kScheduleStream + 1 + e);
    result[e].first_kpa = Pressures::Zero(arm.channel_count());
    for (int i = 0; i < settings.count; ++i) {
      Pressures setpoint_kpa(arm.channel_count());
      for (Eigen::Index s = 0; s < setpoint_kpa.size(); ++s) {
        const PressureLimits& limits = arm.limits_of_channel(static_cast<int>(s));
        setpoint_kpa[s] = static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
      }
      result[e].motions.push_back(make_motion(settings, std::move(setpoint_kpa), random));
    }
  }
  return result;
}

}  // namespace

std::vector<EpisodeSchedule> make_schedule(const ArmDescription& arm,
                                           const ScheduleSettings& settings, std::uint64_t seed) {
  check(settings);
  const ArmDescription scaled = with_scaled_limits(arm, settings.limit_scale);
  std::vector<EpisodeSchedule> episodes = settings.kind == ScheduleKind::transitions
                                              ? transition_schedule(scaled, settings, seed)
                                              : random_schedule(scaled, settings, seed);
  for (EpisodeSchedule& episode : episodes) {
    episode.approach = settings.approach;
  }
  return episodes;
}

ScheduleSettings identifying_schedule(Dimension dimension) {
  return {.kind = ScheduleKind::random,
          .count = dimension == Dimension::plane ? 36 : 68,
          .approach = Approach::straight,
          .hold_s = 1.0,
          .hold_min_s = 0.2};
}

std::string describe(const ScheduleSettings& settings) {
  const bool transitions = settings.kind == ScheduleKind::transitions;
  std::string text = transitions ? "transitions" : "random";
  text += settings.count == 0
              ? ", all"
              : fmt::format(", {} motions{}", settings.count, transitions ? "" : " an episode");
  if (settings.episodes != 0) {
    text += fmt::format(", {} episodes", settings.episodes);
  }
  text += settings.approach == Approach::step ? ", step" : ", straight";
  text += settings.hold_min_s
              ? fmt::format(", holds from {} to {} s", *settings.hold_min_s, settings.hold_s)
              : fmt::format(", hold {} s and until reached", settings.hold_s);
  if (settings.limit_scale != 1.0) {
    text += fmt::format(", limits times {}", settings.limit_scale);
  }
  return text;
}

Pressures corner_configuration(const ArmDescription& arm, int index) {
  Pressures result(arm.channel_count());
  for (Eigen::Index s = 0; s < result.size(); ++s) {
    const PressureLimits& limits = arm.limits_of_channel(static_cast<int>(s));
    result[s] = static_cast<float>(corner_kpa(limits, index % kCornerStates));
    index /= kCornerStates;
  }
  return result;
}

}  // namespace limber
